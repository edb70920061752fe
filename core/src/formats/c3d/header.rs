//! The first 512 bytes of a file: 256 words, counted from 1 as the format's manual does.

use super::encoding::Processor;
use super::parameters::trimmed;

/// A block: what pointers in a file count.
pub(super) const BLOCK_BYTES: usize = 512;

/// Marks a file as C3D, in its second byte.
pub(super) const KEY: u8 = 0x50;

/// Says that header events have labels of four characters.
pub(super) const EVENT_KEY: u16 = 12345;

/// The most events that fit into a header.
pub(super) const MOST_EVENTS: usize = 18;

/// What the header says; the parameters say most of it again, and not always the same.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Header {
    /// Word 2: the points of a frame.
    pub point_count: u16,
    /// Word 3: the analog values of a frame, all channels and samples together.
    pub analog_per_frame: u16,
    /// Word 4: the number of the first frame.
    pub first_frame: u16,
    /// Word 5: the number of the last frame; 65,535 where it is larger.
    pub last_frame: u16,
    /// Word 6: the longest gap that was filled, in frames.
    pub longest_gap: u16,
    /// Words 7 and 8: what integer points are multiplied by; negative where points are floating point.
    pub scale: f32,
    /// Word 9: the block where the data begin, from 1.
    pub data_block: u16,
    /// Word 10: the samples of each analog channel in a frame.
    pub samples_per_frame: u16,
    /// Words 11 and 12: frames per second.
    pub rate_hz: f32,
    /// Words 150 to 234.
    pub events: Vec<HeaderEvent>,
}

/// An event in the header.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct HeaderEvent {
    /// Up to four characters.
    pub label: String,
    /// In seconds, 0 being frame 1.
    pub time_s: f32,
    /// The byte that says whether to display it.
    pub flag: u8,
}

/// A word of the header and where it is.
pub(super) fn word_at(word: usize) -> usize {
    2 * (word - 1)
}

impl Header {
    pub(super) fn read(block: &[u8; BLOCK_BYTES], processor: Processor) -> Self {
        let word = |word: usize| processor.u16(at(block, word_at(word)));
        let float = |word: usize| processor.f32(at(block, word_at(word)));
        let event_count = if word(150) == EVENT_KEY { usize::from(word(151)).min(MOST_EVENTS) } else { 0 };
        let events = (0..event_count).map(|event| HeaderEvent {
            label: trimmed(&at::<4>(block, word_at(199) + 4 * event)),
            time_s: float(153 + 2 * event),
            flag: at::<1>(block, word_at(189) + event)[0],
        });
        Self {
            point_count: word(2),
            analog_per_frame: word(3),
            first_frame: word(4),
            last_frame: word(5),
            longest_gap: word(6),
            scale: float(7),
            data_block: word(9),
            samples_per_frame: word(10),
            rate_hz: float(11),
            events: events.collect(),
        }
    }

    /// Writes what the header says over a block; the rest of it stays.
    pub(super) fn write(&self, block: &mut [u8; BLOCK_BYTES], processor: Processor) {
        let mut put = |offset: usize, bytes: &[u8]| {
            if let Some(place) = block.get_mut(offset..offset + bytes.len()) {
                place.copy_from_slice(bytes);
            }
        };
        let words = [
            (2, self.point_count),
            (3, self.analog_per_frame),
            (4, self.first_frame),
            (5, self.last_frame),
            (6, self.longest_gap),
            (9, self.data_block),
            (10, self.samples_per_frame),
        ];
        for (word, value) in words {
            put(word_at(word), &processor.u16_bytes(value));
        }
        put(word_at(7), &processor.f32_bytes(self.scale));
        put(word_at(11), &processor.f32_bytes(self.rate_hz));
        if self.events.is_empty() {
            return;
        }
        put(word_at(150), &processor.u16_bytes(EVENT_KEY));
        put(word_at(151), &processor.u16_bytes(self.events.len().min(MOST_EVENTS) as u16));
        for (index, event) in self.events.iter().take(MOST_EVENTS).enumerate() {
            put(word_at(153 + 2 * index), &processor.f32_bytes(event.time_s));
            put(word_at(189) + index, &[event.flag]);
            let mut label = [b' '; 4];
            label.iter_mut().zip(event.label.bytes()).for_each(|(place, byte)| *place = byte);
            put(word_at(199) + 4 * index, &label);
        }
    }
}

/// Returns the bytes at an offset of the block; zeros beyond its end.
fn at<const N: usize>(block: &[u8; BLOCK_BYTES], offset: usize) -> [u8; N] {
    block.get(offset..).and_then(|rest| rest.first_chunk::<N>()).copied().unwrap_or([0; N])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_written_and_read_is_the_same_for_every_processor() {
        let event = |label: &str, time_s, flag| HeaderEvent { label: label.to_owned(), time_s, flag };
        let header = Header {
            point_count: 40_000,
            analog_per_frame: 65_535,
            first_frame: 1,
            last_frame: 65_535,
            longest_gap: 10,
            scale: -0.1,
            data_block: 300,
            samples_per_frame: 20,
            rate_hz: 59.94,
            events: vec![event("RHS", 0.25, 1), event("LTO1", 1.5, 0)],
        };
        for processor in [Processor::Intel, Processor::Dec, Processor::Mips] {
            let mut block = [0; BLOCK_BYTES];
            header.write(&mut block, processor);
            assert_eq!(Header::read(&block, processor), header);
        }
    }
}
