//! Looks over text that should hold numbers, many bytes at a time, without reading a single one.
//!
//! Words are counted, and bytes that no number has. What is made of the right bytes in a wrong order (`1.2.3`) is left to
//! be found by who reads the numbers.

// A branch would keep bytes from being looked at side by side.
#![allow(clippy::needless_bitwise_bool)]

/// What a piece of text holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Tally {
    /// How many words there are; one counts where it begins.
    pub(crate) words: usize,
    /// How many line ends (LF).
    pub(crate) lines: usize,
    /// How many bytes that are part of no number, and no blank.
    pub(crate) others: usize,
    /// The sum of those: equal where they are the same names.
    pub(crate) sum: u8,
}

/// So many bytes are looked at together: a vector of the widest kind.
const LANES: usize = 64;

/// So many bytes are counted before the lanes, which are bytes themselves, can be full.
pub(crate) const BLOCK_BYTES: usize = 1 << 13;

const _: () = assert!(BLOCK_BYTES.is_multiple_of(LANES) && BLOCK_BYTES / LANES <= u8::MAX as usize);

/// What each lane has counted.
struct Counts {
    words: [u8; LANES],
    lines: [u8; LANES],
    others: [u8; LANES],
    sum: [u8; LANES],
}

impl Tally {
    /// Looks over a piece of text that begins where a word or a blank does.
    pub(crate) fn of(text: &[u8]) -> Self {
        Self::up_to_blocks(text).last().copied().unwrap_or_default()
    }

    /// Looks over a text in blocks of [`BLOCK_BYTES`], the last of which may be shorter: returns for each what the text
    /// holds up to the block's end.
    pub(crate) fn up_to_blocks(text: &[u8]) -> Vec<Self> {
        let of_block = of_block();
        let starts = (0..text.len()).step_by(BLOCK_BYTES);
        let counted = starts.scan(Self::default(), |sum, start| {
            sum.add(&of_block(text, start));
            Some(*sum)
        });
        counted.collect()
    }

    fn add(&mut self, other: &Self) {
        self.words += other.words;
        self.lines += other.lines;
        self.others += other.others;
        self.sum = self.sum.wrapping_add(other.sum);
    }
}

/// Looks over the block of a text that begins at a byte.
type OfBlock = fn(&[u8], usize) -> Tally;

/// Returns the way that uses the widest vectors of this processor.
fn of_block() -> OfBlock {
    #[cfg(target_arch = "x86_64")]
    {
        if std::arch::is_x86_feature_detected!("avx512bw") {
            // SAFETY: the function is safe but for needing AVX-512BW, which this processor was just found to have.
            return |text, start| unsafe { of_block_in_avx512(text, start) };
        }
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the same with AVX2.
            return |text, start| unsafe { of_block_in_avx2(text, start) };
        }
    }
    of_any_block
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512bw")]
fn of_block_in_avx512(text: &[u8], start: usize) -> Tally {
    of_any_block(text, start)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn of_block_in_avx2(text: &[u8], start: usize) -> Tally {
    of_any_block(text, start)
}

#[inline(always)]
fn of_any_block(text: &[u8], start: usize) -> Tally {
    let mut counts = Counts::new();
    let end = text.len().min(start + BLOCK_BYTES);
    for at in (start..end).step_by(LANES) {
        let with_byte_before = at.checked_sub(1).and_then(|before| text.get(before..)?.first_chunk());
        match with_byte_before {
            Some(window) => counts.add(window),
            None => counts.add(&padded(text, at)),
        }
    }
    counts.total()
}

/// Returns the bytes from one before `at` on, with blanks where the text has none.
#[inline(always)]
fn padded(text: &[u8], at: usize) -> [u8; LANES + 1] {
    let mut window = [b' '; LANES + 1];
    let from = at.saturating_sub(1);
    let bytes = text.get(from..text.len().min(at + LANES)).unwrap_or_default();
    // Before the first byte there is a blank.
    if let Some(place) = window.get_mut(from + 1 - at..).and_then(|rest| rest.get_mut(..bytes.len())) {
        place.copy_from_slice(bytes);
    }
    window
}

impl Counts {
    #[inline(always)]
    fn new() -> Self {
        let none = [0; LANES];
        Self { words: none, lines: none, others: none, sum: none }
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
            self.others[lane] = self.others[lane].wrapping_add(u8::from(other));
            self.sum[lane] = self.sum[lane].wrapping_add(if other { byte } else { 0 });
        }
    }

    /// Returns what the lanes have counted together.
    #[inline(always)]
    fn total(&self) -> Tally {
        let total = |lanes: &[u8; LANES]| lanes.iter().map(|count| usize::from(*count)).sum::<usize>();
        Tally {
            words: total(&self.words),
            lines: total(&self.lines),
            others: total(&self.others),
            sum: self.sum.iter().fold(0, |sum: u8, byte| sum.wrapping_add(*byte)),
        }
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
            others: others.len(),
            sum: others.iter().fold(0, |sum, byte| sum.wrapping_add(*byte)),
        }
    }

    #[test]
    fn lanes_that_are_full_are_emptied_in_time() {
        let text = "x.\n".repeat(40_000);
        assert_eq!(Tally::of(text.as_bytes()), counted(&text));
        let text = "x".repeat(40_000);
        assert_eq!(Tally::of(text.as_bytes()), counted(&text));
    }

    #[test]
    fn words_that_no_number_can_be_have_other_bytes() {
        for word in ["x", "1,5", "inf", "nan", "0x10", "\0", "1#", "1/2", "é", "\u{1}"] {
            assert!(Tally::of(format!("1 {word} 2").as_bytes()).others > 0, "{word:?}");
        }
        assert_eq!(Tally::of(b"1.5 -2e-3 +4.").others, 0);
    }

    #[test]
    fn each_block_tells_of_the_text_up_to_its_end() {
        let text: String = (0..4000).map(|number| format!("{number} x\r\n")).collect();
        let blocks = Tally::up_to_blocks(text.as_bytes());
        assert_eq!(blocks.len(), text.len().div_ceil(BLOCK_BYTES));
        for (block, tally) in blocks.iter().enumerate() {
            let end = text.len().min((block + 1) * BLOCK_BYTES);
            assert_eq!(*tally, counted(&text[..end]), "block {block}");
        }
    }

    proptest! {
        #[test]
        fn fast_counts_are_those_of_the_clear_version(text in "[ -.0-9eE\t-\r,xné\0]{0,700}") {
            prop_assert_eq!(Tally::of(text.as_bytes()), counted(&text));
            prop_assert_eq!(of_any_block(text.as_bytes(), 0), counted(&text));
        }
    }
}
