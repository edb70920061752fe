//! Lines of marker files in text: words between blanks, cells between tabs. Here `#` begins no comment.

use crate::markers::{Markers, PointKind};
use crate::text::{is_blank, Word, Words, LARGEST};
use glam::DVec3;

/// Returns the words of a line.
pub(super) fn words<'a>(source: &'a [u8], line: &Words<'a>) -> impl Iterator<Item = Word<'a>> + use<'a> {
    pieces(source, line, is_blank).filter(|word| !word.bytes.is_empty())
}

/// Returns the cells of a line, without blanks around what they hold; empty ones too.
pub(super) fn cells<'a>(source: &'a [u8], line: &Words<'a>) -> impl Iterator<Item = Word<'a>> + use<'a> {
    pieces(source, line, |byte| byte == b'\t').map(move |cell| {
        let text = cell.bytes.trim_ascii_end();
        let trimmed = text.trim_ascii_start();
        Word::new(source, cell.at + text.len() - trimmed.len(), trimmed.len())
    })
}

fn pieces<'a>(
    source: &'a [u8],
    line: &Words<'a>,
    separates: fn(u8) -> bool,
) -> impl Iterator<Item = Word<'a>> + use<'a> {
    let mut at = line.at();
    line.raw().split(move |byte| separates(*byte)).map(move |bytes| {
        let word = Word::new(source, at, bytes.len());
        at += bytes.len() + 1;
        word
    })
}

/// Turns values that lie frame after frame into values that lie marker after marker, three each.
pub(super) fn turned(values: &[f64], marker_count: usize, frame_count: usize) -> Vec<f64> {
    let rows = values.as_chunks::<3>().0;
    let trajectory = |marker: usize| rows.iter().skip(marker).step_by(marker_count.max(1)).take(frame_count);
    (0..marker_count).flat_map(trajectory).flatten().copied().collect()
}

/// Returns coordinates as text files have them: not numbers in a gap, and where no reader would take them.
pub(super) fn written(position: Option<DVec3>) -> [f64; 3] {
    position.filter(|at| at.abs().max_element() <= LARGEST).unwrap_or(DVec3::NAN).to_array()
}

/// Returns the markers that are positions, and a name for each that a text file can hold: no blank, no comma, not empty.
pub(super) fn writable_names(markers: &Markers) -> (Vec<usize>, Vec<String>) {
    let is_position = |marker: &usize| markers.kinds.get(*marker) == Some(&PointKind::Position);
    let chosen: Vec<usize> = (0..markers.count()).filter(is_position).collect();
    let unusable = |character: char| character.is_whitespace() || character.is_control() || character == ',';
    let name_of = |marker: &usize| match markers.names.get(*marker).map_or("", |name| name.trim()) {
        "" => format!("Marker{}", marker + 1),
        // In a CSM a dollar sign would begin a section.
        name => name.replace(unusable, "_").replace('$', "_"),
    };
    let names = chosen.iter().map(name_of).collect();
    (chosen, names)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Lines;

    fn texts<'a>(found: impl Iterator<Item = Word<'a>>) -> Vec<(usize, String)> {
        found.map(|word| (word.at, word.text())).collect()
    }

    #[test]
    fn words_and_cells_know_where_they_stand() {
        let source = b"x\n a #b\t\t c d \t";
        let mut lines = Lines::new(source);
        lines.next_line();
        let line = lines.next_line().unwrap();
        let owned =
            |list: &[(usize, &str)]| list.iter().map(|(at, text)| (*at, (*text).to_owned())).collect::<Vec<_>>();
        assert_eq!(texts(words(source, &line)), owned(&[(3, "a"), (5, "#b"), (10, "c"), (12, "d")]));
        assert_eq!(texts(cells(source, &line)), owned(&[(3, "a #b"), (8, ""), (10, "c d"), (15, "")]));
    }

    #[test]
    fn frames_of_markers_become_markers_of_frames() {
        let frames: Vec<f64> = (0..12).map(f64::from).collect();
        assert_eq!(turned(&frames, 2, 2), [0.0, 1.0, 2.0, 6.0, 7.0, 8.0, 3.0, 4.0, 5.0, 9.0, 10.0, 11.0]);
        assert!(turned(&[], 0, 5).is_empty());
    }
}
