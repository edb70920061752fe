//! Pictures of a few colours as PNGs with a palette, and back.
//!
//! Blue, orange and greys over a dark rim, more or less transparent at their edges: a palette holds them in a quarter of the
//! bytes, and packs far better.

use png::{BitDepth, ColorType, Decoder, DeflateCompression, Encoder, Filter, Limits, Transformations};
use std::io::Cursor;
use tiny_skia::PremultipliedColorU8;

/// So many colours fit into a palette, transparency among them.
const MOST_COLOURS: usize = 256;

/// How many bits of each of a colour's four components tell colours apart.
const BITS: u32 = 3;

/// Twice as fast as the usual level, for a tenth more bytes.
const LEVEL: DeflateCompression = DeflateCompression::Level(2);

/// No picture that is unpacked is larger; ours are far smaller.
const MOST_BYTES: usize = 64 << 20;

/// Gathers frames side by side.
pub(super) struct Packer {
    width: usize,
    height: usize,
    /// Which of `colours` each pixel has.
    pixels: Vec<u16>,
    /// By key, which colour it is; 0 for one that is new.
    known: Vec<u16>,
    /// The first is transparency.
    colours: Vec<Mean>,
}

/// The mean of the colours that have one key.
#[derive(Debug, Clone, Copy, Default)]
struct Mean {
    sums: [u32; 4],
    count: u32,
}

impl Packer {
    /// Makes room for a number of frames of `size` pixels in width and height.
    pub(super) fn new(frames: usize, size: usize) -> Self {
        let width = frames * size;
        Self {
            width,
            height: size,
            pixels: vec![0; width * size],
            known: vec![0; 1 << (4 * BITS)],
            colours: vec![Mean::default()],
        }
    }

    /// Puts a frame at its place.
    pub(super) fn add(&mut self, frame: usize, picture: &[PremultipliedColorU8]) {
        let size = self.height;
        let rows = self.pixels.chunks_exact_mut(self.width).zip(picture.chunks_exact(size));
        for (row, picture) in rows {
            let Some(row) = row.get_mut(frame * size..(frame + 1) * size) else { return };
            for (pixel, colour) in row.iter_mut().zip(picture).filter(|(_, colour)| colour.alpha() > 0) {
                let plain = colour.demultiply();
                let components = [plain.red(), plain.green(), plain.blue(), plain.alpha()];
                let key = components.iter().fold(0, |key, part| key << BITS | usize::from(part >> (8 - BITS)));
                let Some(known) = self.known.get_mut(key) else { continue };
                if *known == 0 {
                    *known = self.colours.len() as u16;
                    self.colours.push(Mean::default());
                }
                *pixel = *known;
                if let Some(mean) = self.colours.get_mut(usize::from(*known)) {
                    mean.add(components);
                }
            }
        }
    }

    /// Returns everything as a PNG.
    pub(super) fn pack(self) -> Vec<u8> {
        let (palette, places) = palette(&self.colours);
        let place = |pixel: &u16| places.get(usize::from(*pixel)).copied().unwrap_or(0);
        let indices: Vec<u8> = self.pixels.iter().map(place).collect();
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Eight);
        encoder.set_deflate_compression(LEVEL);
        encoder.set_filter(Filter::NoFilter);
        encoder.set_palette(palette.iter().flat_map(|[red, green, blue, _]| [*red, *green, *blue]).collect::<Vec<_>>());
        encoder.set_trns(palette.iter().map(|colour| colour[3]).collect::<Vec<_>>());
        // Memory takes whatever is written to it.
        let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&indices));
        written.map_or_else(|_| Vec::new(), |()| bytes)
    }
}

impl Mean {
    fn add(&mut self, components: [u8; 4]) {
        for (sum, part) in self.sums.iter_mut().zip(components) {
            *sum = sum.saturating_add(u32::from(part));
        }
        self.count = self.count.saturating_add(1);
    }

    fn colour(&self) -> [u8; 4] {
        self.sums.map(|sum| (sum / self.count.max(1)) as u8)
    }
}

/// Returns the colours that are most in use, and for every colour which of these stands for it.
fn palette(colours: &[Mean]) -> (Vec<[u8; 4]>, Vec<u8>) {
    let mut order: Vec<usize> = (1..colours.len()).collect();
    order.sort_by_key(|index| std::cmp::Reverse(colours.get(*index).map_or(0, |mean| mean.count)));
    let mut palette = vec![[0; 4]];
    let mut places = vec![0; colours.len()];
    for index in order {
        let Some(colour) = colours.get(index).map(Mean::colour) else { continue };
        let place = if palette.len() < MOST_COLOURS {
            palette.push(colour);
            palette.len() - 1
        } else {
            nearest(&palette, colour)
        };
        if let Some(known) = places.get_mut(index) {
            *known = place as u8;
        }
    }
    (palette, places)
}

fn nearest(palette: &[[u8; 4]], colour: [u8; 4]) -> usize {
    let apart = |other: &[u8; 4]| other.iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b))).sum::<u32>();
    (0..palette.len()).min_by_key(|index| palette.get(*index).map_or(u32::MAX, apart)).unwrap_or(0)
}

/// Pictures of one size.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Frames {
    /// How many there are.
    pub count: usize,
    /// How wide each is, in pixels.
    pub width: usize,
    /// How high each is.
    pub height: usize,
    /// Frame after frame, row after row from the top: red, green, blue and opacity. Colours are not multiplied by opacity.
    pub rgba: Vec<u8>,
}

/// Unpacks `count` pictures that lie side by side in a PNG; `None` where it is none of these.
pub fn unpack(png: &[u8], count: usize) -> Option<Frames> {
    let mut decoder = Decoder::new_with_limits(Cursor::new(png), Limits { bytes: MOST_BYTES });
    decoder.set_transformations(Transformations::EXPAND | Transformations::ALPHA);
    let mut reader = decoder.read_info().ok()?;
    let size = reader.output_buffer_size().filter(|size| *size <= MOST_BYTES)?;
    let mut side_by_side = vec![0; size];
    let info = reader.next_frame(&mut side_by_side).ok()?;
    let (all, height) = (info.width as usize, info.height as usize);
    let width = all.checked_div(count)?;
    if width == 0 || width * count != all || info.color_type != ColorType::Rgba || info.bit_depth != BitDepth::Eight {
        return None;
    }
    let mut rgba = Vec::with_capacity(size);
    for frame in 0..count {
        for row in side_by_side.chunks_exact(all * 4) {
            rgba.extend_from_slice(row.get(frame * width * 4..(frame + 1) * width * 4)?);
        }
    }
    Some(Frames { count, width, height, rgba })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tiny_skia::ColorU8;

    fn premultiplied(colour: [u8; 4]) -> PremultipliedColorU8 {
        let [red, green, blue, opacity] = colour;
        ColorU8::from_rgba(red, green, blue, opacity).premultiply()
    }

    #[test]
    fn frames_come_back_in_their_places() {
        let (red, clear) = ([250, 0, 0, 255], [0; 4]);
        let pictures = [[red, clear, clear, clear], [clear, clear, clear, [0, 0, 250, 255]]];
        let mut packer = Packer::new(2, 2);
        for (frame, picture) in pictures.iter().enumerate() {
            packer.add(frame, &picture.map(premultiplied));
        }
        let frames = unpack(&packer.pack(), 2).unwrap();
        assert_eq!((frames.count, frames.width, frames.height), (2, 2, 2));
        assert_eq!(frames.rgba, pictures.as_flattened().as_flattened());
    }

    #[test]
    fn more_colours_than_a_palette_holds_become_their_nearest() {
        let size = 64;
        let colour = |at: usize| [(at % 64 * 4) as u8, (at / 64 * 4) as u8, 128, 255];
        let picture: Vec<[u8; 4]> = (0..size * size).map(colour).collect();
        let mut packer = Packer::new(1, size);
        packer.add(0, &picture.iter().map(|colour| premultiplied(*colour)).collect::<Vec<_>>());
        let frames = unpack(&packer.pack(), 1).unwrap();
        let off = frames.rgba.iter().zip(picture.as_flattened()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(off <= 32, "{off}");
    }

    #[test]
    fn what_is_no_strip_of_ours_is_refused() {
        let png = Packer::new(1, 8).pack();
        assert!(unpack(&png, 1).is_some());
        assert_eq!(unpack(&png, 0), None);
        assert_eq!(unpack(&png, 3), None);
        assert_eq!(unpack(&png[..png.len() / 2], 1), None);
        assert_eq!(unpack(b"no picture", 1), None);
    }
}
