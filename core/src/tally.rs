//! Looks over text that should hold numbers, many bytes at a time, without reading a single one.
//!
//! What makes a number is checked by each byte and the two before it: a sign stands at the start of a word or behind an
//! `e`, a point behind a digit or at the start, and so on. That refuses nearly all damage; two points in one word, or two
//! exponents, are left to be found by who reads the numbers.

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
    /// The sum of those, ...
    pub(crate) sum: u8,
    /// ... and their bits against each other: equal where they are the same names.
    pub(crate) xor: u8,
    /// Whether something stands where a number cannot have it.
    pub(crate) is_odd: bool,
}

/// So many bytes are counted in counters of a byte.
const BLOCK: usize = 255;

impl Tally {
    /// Looks over a piece of text that begins and ends where words do.
    pub(crate) fn of(text: &[u8]) -> Self {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the function is safe but for needing AVX2, which this processor was just found to have.
            return unsafe { of_in_avx2(text) };
        }
        of_any(text)
    }

    /// Whether there is nothing but as many words as asked for, all of them numbers, as far as that is seen.
    pub(crate) fn is_numbers(&self, count: usize) -> bool {
        !self.is_odd && self.others == 0 && self.words == count && self.points <= count
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
    // The first two bytes have blanks before them.
    let mut before = [b' '; 4];
    let head = text.get(..2).unwrap_or(text);
    before[2..2 + head.len()].copy_from_slice(head);
    tally.add(&before[2..2 + head.len()], &before[1..], &before);
    let rest = text.get(2..).unwrap_or_default();
    let one_before = text.get(1..).unwrap_or_default();
    for ((bytes, one_before), two_before) in rest.chunks(BLOCK).zip(one_before.chunks(BLOCK)).zip(text.chunks(BLOCK)) {
        tally.add(bytes, one_before, two_before);
    }
    // The last word ends here.
    let last = |back: usize| text.len().checked_sub(back).and_then(|at| text.get(at)).copied().unwrap_or(b' ');
    tally.is_odd |= is_odd(b' ', last(1), last(2));
    tally
}

impl Tally {
    /// Adds bytes, given with the ones before and the ones before these.
    ///
    /// Slices of one length, no branch and counters of a byte: in this form the compiler puts neighbours into
    /// neighbouring lanes.
    #[inline(always)]
    fn add(&mut self, bytes: &[u8], one_before: &[u8], two_before: &[u8]) {
        let (mut words, mut lines, mut points, mut others, mut sum, mut xor, mut odd) =
            (0_u8, 0_u8, 0_u8, 0_u8, 0_u8, 0_u8, 0_u8);
        for ((&byte, &before), &two_before) in bytes.iter().zip(one_before).zip(two_before) {
            let other = is_other(byte, before);
            words = words.wrapping_add(u8::from(!is_space(byte) & is_space(before)));
            lines = lines.wrapping_add(u8::from(byte == b'\n'));
            points = points.wrapping_add(u8::from(byte == b'.'));
            others = others.wrapping_add(u8::from(other));
            let name = if other { byte } else { 0 };
            sum = sum.wrapping_add(name);
            xor ^= name;
            odd |= u8::from(is_odd(byte, before, two_before));
        }
        self.words += usize::from(words);
        self.lines += usize::from(lines);
        self.points += usize::from(points);
        self.others += usize::from(others);
        self.sum = self.sum.wrapping_add(sum);
        self.xor ^= xor;
        self.is_odd |= odd != 0;
    }
}

#[inline(always)]
fn is_space(byte: u8) -> bool {
    (byte == b' ') | (byte == b'\t') | (byte == b'\n') | (byte == b'\r')
}

#[inline(always)]
fn is_sign(byte: u8) -> bool {
    (byte == b'-') | (byte == b'+')
}

/// A letter that begins an exponent: where a digit or a point is before it.
#[inline(always)]
fn is_exponent(byte: u8, before: u8) -> bool {
    (byte | 0x20 == b'e') & (before.is_ascii_digit() | (before == b'.'))
}

/// A byte that is part of no number, and no blank.
#[inline(always)]
fn is_other(byte: u8, before: u8) -> bool {
    !(byte.is_ascii_digit() | is_space(byte) | is_sign(byte) | (byte == b'.') | is_exponent(byte, before))
}

/// A byte that cannot stand behind the two before it, in a number or in a name of letters.
#[inline(always)]
fn is_odd(byte: u8, before: u8, two_before: u8) -> bool {
    let behind_exponent = is_exponent(before, two_before);
    let lone_point = (before == b'.') & !two_before.is_ascii_digit();
    (is_sign(byte) & !(is_space(before) | behind_exponent))
        | ((byte == b'.') & !(is_space(before) | is_sign(before) | before.is_ascii_digit()))
        | (is_space(byte) & (is_sign(before) | behind_exponent | lone_point))
        | (is_exponent(byte, before) & lone_point)
        | (is_other(byte, before) & (is_sign(before) | behind_exponent | (before == b'.')))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::read;
    use proptest::prelude::*;

    /// The clear version of whether all words are numbers.
    fn are_numbers(text: &str) -> bool {
        text.split([' ', '\t', '\n', '\r']).filter(|word| !word.is_empty()).all(|word| read(word.as_bytes()).is_some())
    }

    fn words(text: &str) -> usize {
        text.split([' ', '\t', '\n', '\r']).filter(|word| !word.is_empty()).count()
    }

    #[test]
    fn damaged_numbers_are_odd_or_have_other_bytes() {
        for word in [
            "-", "+", ".", "-.", "e5", "1e", "1e+", "1,5", "--1", "+-1", "inf", "nan", "0x10", "1-2", "1.-2", "1ee5",
            "\0", "1#",
        ] {
            for text in [word.to_owned(), format!("1 {word} 2"), format!("{word} 1"), format!("12.5 {word}")] {
                let count = words(&text);
                assert!(!Tally::of(text.as_bytes()).is_numbers(count), "{text:?}");
            }
        }
        assert!(!Tally::of(b"1.2.3").is_numbers(1), "more points than words");
    }

    #[test]
    fn names_are_known_again_by_their_letters() {
        let tally = |text: &str| Tally::of(text.as_bytes());
        let frame = "root 1 2.5 -3\nlfemur 1e-5 0\n";
        let other = "root 4 5 6\nlfemur 7.25 -8e+2\n";
        let names = |text| {
            let Tally { words, lines, others, sum, xor, is_odd, .. } = tally(text);
            (words, lines, others, sum, xor, is_odd)
        };
        assert_eq!(names(frame), names(other));
        for wrong in [
            "root 4 5 6\nrfemur 7 8\n",
            "root 4 5 6\nlfemur 7 8 9\n",
            "root 4 5 6 lfemur 7 8\n",
            "root 4 5x 6\nlfemur 7 8\n",
        ] {
            assert_ne!(names(frame), names(wrong), "{wrong}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]

        #[test]
        fn numbers_are_never_odd(numbers in prop::collection::vec(
            r"[+-]?([0-9]{1,12}(\.[0-9]{0,12})?|\.[0-9]{1,12})([eE][+-]?[0-9]{1,3})?", 0..60), gap in "[ \t\r\n]{1,3}") {
            let text = numbers.join(&gap);
            let tally = Tally::of(text.as_bytes());
            prop_assert!(tally.is_numbers(numbers.len()), "{}", text);
            prop_assert_eq!(tally.lines, text.matches('\n').count());
        }

        #[test]
        fn what_is_odd_is_no_number(text in r"[-+0-9.eE \n]{0,300}") {
            let tally = Tally::of(text.as_bytes());
            prop_assert_eq!(tally.words, words(&text));
            if tally.is_odd || tally.others > 0 {
                prop_assert!(!are_numbers(&text));
            }
        }

        #[test]
        fn wide_vectors_see_the_same_as_single_bytes(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
            prop_assert_eq!(Tally::of(&bytes), of_any(&bytes));
        }
    }
}
