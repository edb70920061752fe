//! Cut and scale: which scene frames a track covers, and which file frame each of them shows.

use serde::{Deserialize, Serialize};

use crate::error::ParameterError;
use crate::keys::SAME_FRAME;

/// A start and an end, either of which may be left open. Frames are whole numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Span {
    /// The first frame.
    pub start: Option<i64>,
    /// The last frame, included.
    pub end: Option<i64>,
}

impl Span {
    fn is_open(self) -> bool {
        self == Self::default()
    }
}

/// Where a track's keys stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub enum KeySpacing {
    /// On whole scene frames.
    #[default]
    Frames,
    /// One for every sample of the file, on sub-frames where the rates differ.
    Samples,
}

/// Where a track lies in the scene: the mapping from scene frames `t` to file frames
/// `x = file_anchor + (t - scene_anchor) * numerator / denominator`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// First scene frame of the track.
    pub start: f64,
    /// Last scene frame of the track.
    pub end: f64,
    /// First file frame that there is.
    pub file_first: f64,
    /// Last file frame that there is.
    pub file_last: f64,
    file_anchor: f64,
    scene_anchor: f64,
    numerator: f64,
    denominator: f64,
    spacing: KeySpacing,
}

impl Placement {
    /// Places a file of frames `file.0..=file.1` by the table of the original's combiner:
    ///
    /// | given | x |
    /// |---|---|
    /// | nothing, or cut only | the same moment: `t` itself where file and scene run at one rate |
    /// | scale only | `first + (t - scale.start) / (scale.end - scale.start) * (last - first)` |
    /// | cut and scale | `cut.start + (t - scale.start) / (scale.end - scale.start) * (cut.end - cut.start)` |
    ///
    /// `frames_per_frame` is the file's rate over the scene's. The cut is in file frames and clamped to the file,
    /// the scale in scene frames.
    ///
    /// # Errors
    /// Where a range ends before it starts, or the cut lies outside the file.
    pub fn new(
        file: (i64, i64),
        cut: Span,
        scale: Span,
        frames_per_frame: f64,
        spacing: KeySpacing,
    ) -> Result<Self, ParameterError> {
        let (first, last) = file;
        let (from, to) = (cut.start.unwrap_or(first), cut.end.unwrap_or(last));
        if from > to {
            return Err(ParameterError(format!("the cut ends at frame {to}, before it starts at frame {from}")));
        }
        if to < first || from > last {
            return Err(ParameterError(format!(
                "the cut {from} to {to} lies outside the clip's frames {first} to {last}"
            )));
        }
        let (from, to) = (from.max(first) as f64, to.min(last) as f64);
        let (first, last) = (first as f64, last as f64);
        let natural = |frame: f64| first + (frame - first) / frames_per_frame;
        let unscaled = Self {
            start: natural(from),
            end: natural(to),
            file_first: first,
            file_last: last,
            file_anchor: first,
            scene_anchor: first,
            numerator: frames_per_frame,
            denominator: 1.0,
            spacing,
        };
        let mut placed = unscaled;
        if !scale.is_open() {
            placed.start = scale.start.map_or(unscaled.start.round(), |frame| frame as f64);
            placed.end = scale.end.map_or(unscaled.end.round(), |frame| frame as f64);
            if placed.end < placed.start {
                return Err(ParameterError(format!(
                    "the scaled track would end at frame {}, before it starts at frame {}",
                    placed.end, placed.start
                )));
            }
            (placed.file_anchor, placed.scene_anchor) = (from, placed.start);
            (placed.numerator, placed.denominator) = (to - from, (placed.end - placed.start).max(1.0));
        }
        if spacing == KeySpacing::Frames {
            placed.start = (placed.start - SAME_FRAME).ceil();
            // The clip's own end comes to the nearest frame, so that it lasts as long as it was recorded; a cut never
            // shows what lies behind it.
            let is_files_end = scale.is_open() && to == last;
            let end = if is_files_end { (placed.end - SAME_FRAME).round() } else { (placed.end + SAME_FRAME).floor() };
            placed.end = end.max(placed.start);
        }
        Ok(placed)
    }

    /// Returns the file frame that scene frame `frame` shows; a whole number is exactly that.
    pub fn file_frame(&self, frame: f64) -> f64 {
        let x = self.file_anchor + (frame - self.scene_anchor) * self.numerator / self.denominator;
        if (x - x.round()).abs() < SAME_FRAME {
            x.round()
        } else {
            x
        }
    }

    /// Returns the scene frame at which file frame `x` is shown.
    fn scene_frame(&self, x: f64) -> f64 {
        let frame = self.scene_anchor + (x - self.file_anchor) * self.denominator / self.numerator;
        if (frame - frame.round()).abs() < SAME_FRAME {
            frame.round()
        } else {
            frame
        }
    }

    /// Returns how many file frames one scene frame advances.
    pub fn speed(&self) -> f64 {
        self.numerator / self.denominator
    }

    /// Returns the keys from scene frame `start` to `end`: pairs of scene frame and file frame.
    pub fn keys(&self, start: f64, end: f64) -> Vec<(f64, f64)> {
        if self.spacing == KeySpacing::Frames || self.numerator <= 0.0 {
            let (first, last) = ((start - SAME_FRAME).ceil() as i64, (end + SAME_FRAME).floor() as i64);
            return (first..=last).map(|frame| (frame as f64, self.file_frame(frame as f64))).collect();
        }
        let first = (self.file_frame(start) - SAME_FRAME).ceil() as i64;
        let last = (self.file_frame(end) + SAME_FRAME).floor() as i64;
        (first..=last).map(|x| (self.scene_frame(x as f64), x as f64)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn span(start: i64, end: i64) -> Span {
        let set = |frame| (frame != 0).then_some(frame);
        Span { start: set(start), end: set(end) }
    }

    fn place(cut: Span, scale: Span) -> Placement {
        Placement::new((1, 113), cut, scale, 1.0, KeySpacing::Frames).unwrap()
    }

    #[test]
    fn without_scale_a_frame_shows_itself() {
        let whole = place(Span::default(), Span::default());
        assert_eq!((whole.start, whole.end, whole.file_frame(77.0)), (1.0, 113.0, 77.0));
        let cut = place(span(50, 100), Span::default());
        assert_eq!((cut.start, cut.end, cut.file_frame(77.0)), (50.0, 100.0, 77.0));
    }

    #[test]
    fn scale_only_stretches_the_whole_file() {
        let placed = place(Span::default(), span(10, 234));
        assert_eq!((placed.start, placed.end), (10.0, 234.0));
        assert_eq!((placed.file_frame(10.0), placed.file_frame(11.0), placed.file_frame(234.0)), (1.0, 1.5, 113.0));
    }

    #[test]
    fn worked_example_of_the_combiner() {
        let placed = place(span(50, 113), span(50, 140));
        assert_eq!((placed.start, placed.end), (50.0, 140.0));
        assert_eq!(placed.file_frame(45.0), 46.5);
        assert_eq!((placed.file_frame(50.0), placed.file_frame(140.0)), (50.0, 113.0));
    }

    #[test]
    fn one_side_of_the_scale_leaves_the_other_where_it_was() {
        let placed = place(span(20, 40), Span { start: Some(10), end: None });
        assert_eq!((placed.start, placed.end), (10.0, 40.0));
        assert_eq!((placed.file_frame(10.0), placed.file_frame(40.0)), (20.0, 40.0));
    }

    #[test]
    fn another_rate_shows_the_same_moment() {
        let placed = Placement::new((1, 601), span(241, 361), Span::default(), 5.0, KeySpacing::Frames).unwrap();
        assert_eq!((placed.start, placed.end), (49.0, 73.0));
        assert_eq!(placed.file_frame(49.0), 241.0);
    }

    #[test]
    fn samples_keep_every_frame_of_the_file() {
        let placed = Placement::new((1, 11), Span::default(), Span::default(), 2.5, KeySpacing::Samples).unwrap();
        let keys = placed.keys(placed.start, placed.end);
        assert_eq!(keys.len(), 11);
        assert_eq!((keys[1], keys[10]), ((1.4, 2.0), (5.0, 11.0)));
    }

    #[test]
    fn ranges_that_run_backwards_are_refused_in_words() {
        let refused = |cut, scale| Placement::new((1, 113), cut, scale, 1.0, KeySpacing::Frames).unwrap_err().0;
        assert_eq!(refused(span(60, 50), Span::default()), "the cut ends at frame 50, before it starts at frame 60");
        assert_eq!(
            refused(span(200, 300), Span::default()),
            "the cut 200 to 300 lies outside the clip's frames 1 to 113"
        );
        assert_eq!(
            refused(Span::default(), span(150, 0)),
            "the scaled track would end at frame 113, before it starts at frame 150"
        );
    }

    #[test]
    fn a_single_frame_maps_to_itself() {
        let placed = place(span(50, 50), span(80, 80));
        assert_eq!((placed.start, placed.end, placed.file_frame(80.0)), (80.0, 80.0, 50.0));
    }
}
