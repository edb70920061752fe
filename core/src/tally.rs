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

/// So many bytes are looked at together: a vector of the widest kind in common use.
const LANES: usize = 32;

/// So many times a lane can count before it is full.
const MOST_COUNTS: usize = 255;

/// What each lane has counted.
struct Counts {
    words: [u8; LANES],
    lines: [u8; LANES],
    points: [u8; LANES],
    others: [u8; LANES],
    sum: [u8; LANES],
}

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
    let Some((first, rest)) = text.split_first() else { return tally };
    // The first byte has a blank before it; it is the byte before the next.
    let mut counts = Counts::new();
    counts.add(&padded(&[b' ', *first]));
    let groups = rest.len() / LANES;
    let mut at = 0;
    for group in 0..groups {
        if group % MOST_COUNTS == MOST_COUNTS - 1 {
            tally.take(&counts);
            counts = Counts::new();
        }
        if let Some(window) = text.get(at..).and_then(|rest| rest.first_chunk::<{ LANES + 1 }>()) {
            counts.add(window);
        }
        at += LANES;
    }
    tally.take(&counts);
    let left = text.get(at..).unwrap_or_default();
    if left.len() > 1 {
        let mut counts = Counts::new();
        counts.add(&padded(left));
        tally.take(&counts);
    }
    tally
}

/// Returns a few bytes with blanks behind them.
#[inline(always)]
fn padded(bytes: &[u8]) -> [u8; LANES + 1] {
    let mut window = [b' '; LANES + 1];
    if let Some(place) = window.get_mut(..bytes.len()) {
        place.copy_from_slice(bytes);
    }
    window
}

impl Counts {
    #[inline(always)]
    fn new() -> Self {
        let none = [0; LANES];
        Self { words: none, lines: none, points: none, others: none, sum: none }
    }

    /// Adds the bytes of a window but for the first: each lane one.
    ///
    /// A fixed length and no branch: in this form the compiler makes one vector of the lanes.
    #[inline(always)]
    fn add(&mut self, window: &[u8; LANES + 1]) {
        for lane in 0..LANES {
            let (before, byte) = (window[lane], window[lane + 1]);
            let other = is_other(byte);
            self.words[lane] = self.words[lane].wrapping_add(u8::from(!is_space(byte) & is_space(before)));
            self.lines[lane] = self.lines[lane].wrapping_add(u8::from(byte == b'\n'));
            self.points[lane] = self.points[lane].wrapping_add(u8::from(byte == b'.'));
            self.others[lane] = self.others[lane].wrapping_add(u8::from(other));
            self.sum[lane] = self.sum[lane].wrapping_add(if other { byte } else { 0 });
        }
    }
}

impl Tally {
    /// Takes what the lanes have counted.
    #[inline(always)]
    fn take(&mut self, counts: &Counts) {
        let total = |lanes: &[u8; LANES]| lanes.iter().map(|count| usize::from(*count)).sum::<usize>();
        self.words += total(&counts.words);
        self.lines += total(&counts.lines);
        self.points += total(&counts.points);
        self.others += total(&counts.others);
        self.sum = counts.sum.iter().fold(self.sum, |sum, byte| sum.wrapping_add(*byte));
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
    fn lanes_that_are_full_are_emptied_in_time() {
        let text = "x.\n".repeat(40_000);
        assert_eq!(Tally::of(text.as_bytes()), counted(&text));
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
