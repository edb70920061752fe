//! Looks over text that should hold numbers, many bytes at a time, without reading a single one.
//!
//! Words are counted, and bytes that no number has. What is made of the right bytes in a wrong order (`1.2.3`) is left to
//! be found by who reads the numbers.

// A branch would keep bytes from being looked at side by side.
#![allow(clippy::needless_bitwise_bool)]

/// What a piece of text holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Tally {
    /// How many words there are.
    pub(crate) words: usize,
    /// How many line ends (LF).
    pub(crate) lines: usize,
    /// How many points.
    pub(crate) points: usize,
    /// How many bytes that are part of no number, and no blank.
    pub(crate) others: usize,
    /// The sum of those: equal where they are the same names.
    pub(crate) sum: u8,
}

/// So many bytes are looked at together: few enough to be counted in a byte, and a whole number of vectors of 32.
const BLOCK: usize = 224;

/// A block, with the byte before it.
type Window = [u8; BLOCK + 1];

impl Tally {
    /// Looks over a piece of text that begins where a word or a blank does.
    pub(crate) fn of(text: &[u8]) -> Self {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the function is safe but for needing AVX2, which this processor was just found to have.
            return unsafe { of_in_avx2(text) };
        }
        of_any(text)
    }

    /// Whether there are as many words as asked for, all of them numbers, as far as that is seen.
    pub(crate) fn is_numbers(&self, count: usize) -> bool {
        self.others == 0 && self.words == count && self.points <= count
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn of_in_avx2(text: &[u8]) -> Tally {
    of_any(text)
}

#[inline(always)]
fn of_any(text: &[u8]) -> Tally {
    let mut tally = Tally::default();
    let mut rest = text;
    // The first byte has a blank before it; it is the byte before the first block.
    let mut first = [b' '; BLOCK + 1];
    if let [byte, ..] = text {
        first[1] = *byte;
        tally.add(&first);
    }
    while let Some(window) = rest.first_chunk::<{ BLOCK + 1 }>() {
        tally.add(window);
        rest = rest.get(BLOCK..).unwrap_or_default();
    }
    if rest.len() > 1 {
        let mut last = [b' '; BLOCK + 1];
        if let Some(place) = last.get_mut(..rest.len()) {
            place.copy_from_slice(rest);
        }
        tally.add(&last);
    }
    tally
}

impl Tally {
    /// Adds the bytes of a window but for the first.
    ///
    /// A fixed length, no branch and counters of a byte: in this form the compiler puts neighbours into neighbouring
    /// lanes.
    #[inline(always)]
    fn add(&mut self, window: &Window) {
        let (mut words, mut lines, mut points, mut others, mut sum) = (0_u8, 0_u8, 0_u8, 0_u8, 0_u8);
        for at in 0..BLOCK {
            let (before, byte) = (window[at], window[at + 1]);
            let other = is_other(byte);
            words = words.wrapping_add(u8::from(!is_space(byte) & is_space(before)));
            lines = lines.wrapping_add(u8::from(byte == b'\n'));
            points = points.wrapping_add(u8::from(byte == b'.'));
            others = others.wrapping_add(u8::from(other));
            sum = sum.wrapping_add(if other { byte } else { 0 });
        }
        self.words += usize::from(words);
        self.lines += usize::from(lines);
        self.points += usize::from(points);
        self.others += usize::from(others);
        self.sum = self.sum.wrapping_add(sum);
    }
}

/// What separates words: blanks, line ends, and other bytes that are no text.
#[inline(always)]
fn is_space(byte: u8) -> bool {
    byte <= b' '
}

/// A byte that is part of no number, and no blank.
#[inline(always)]
fn is_other(byte: u8) -> bool {
    let is_blank = (byte == b' ') | (byte.wrapping_sub(b'\t') < 5);
    // From `+` to `9` all but two belong to numbers.
    let is_of_number = (byte.wrapping_sub(b'+') < 15) & (byte != b',') & (byte != b'/');
    !(is_blank | is_of_number | (byte | 0x20 == b'e'))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const BLANKS: [char; 6] = [' ', '\t', '\n', '\x0B', '\x0C', '\r'];

    /// The clear version.
    fn counted(text: &str) -> Tally {
        let others: Vec<u8> = text
            .bytes()
            .filter(|byte| !(b"0123456789+-.eE".contains(byte) || BLANKS.contains(&(*byte as char))))
            .collect();
        Tally {
            words: text.split(|c| c <= ' ').filter(|word| !word.is_empty()).count(),
            lines: text.matches('\n').count(),
            points: text.matches('.').count(),
            others: others.len(),
            sum: others.iter().fold(0, |sum, byte| sum.wrapping_add(*byte)),
        }
    }

    #[test]
    fn words_that_no_number_can_be_have_other_bytes() {
        for word in ["x", "1,5", "inf", "nan", "0x10", "\0", "1#", "1/2", "é", "\u{1}"] {
            assert!(!Tally::of(format!("1 {word} 2").as_bytes()).is_numbers(3), "{word:?}");
        }
        assert!(!Tally::of(b"1.2.3").is_numbers(1), "more points than words");
        assert!(Tally::of(b"1.5 -2e-3 +4.").is_numbers(3));
    }

    proptest! {
        #[test]
        fn fast_counts_are_those_of_the_clear_version(text in "[ -.0-9eE\t-\r,xné\0]{0,700}") {
            prop_assert_eq!(Tally::of(text.as_bytes()), counted(&text));
            prop_assert_eq!(of_any(text.as_bytes()), counted(&text));
        }
    }
}
