//! Where a motion says something else than it holds, and what was done about it.

/// What the reader met; all zero for a file in order.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Faults {
    /// How many frames the file says it has, and how many it holds, where these differ.
    pub(super) frames: Option<(Option<u64>, usize)>,
    /// Lines that end before their frame does.
    pub(super) short: LineFault,
    /// Lines that go on behind their frame.
    pub(super) long: LineFault,
    /// How many values the last frame has, where it is not complete.
    pub(super) left_over: usize,
}

/// Lines with a fault in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct LineFault {
    /// How many there are.
    pub(super) count: usize,
    /// The first of them, from 1 ...
    pub(super) first_line: usize,
    /// ... and how many values it has.
    pub(super) value_count: usize,
}

impl LineFault {
    /// Counts one more.
    pub(super) fn add(&mut self, line: usize, value_count: usize) {
        if self.count == 0 {
            *self = Self { count: 0, first_line: line, value_count };
        }
        self.count += 1;
    }

    fn sentence(&self, width: usize, done: &str) -> Option<String> {
        let others = match self.count {
            0 => return None,
            1 => String::new(),
            more => format!(" (and so have {} lines more)", more - 1),
        };
        let Self { first_line, value_count, .. } = self;
        Some(format!("Line {first_line} has {value_count} values where a frame has {width}{others}: {done}"))
    }
}

impl Faults {
    /// Notes how many frames the file says it has.
    pub(super) fn set_declared(&mut self, declared: Option<u64>, found: usize) {
        self.frames = (declared != Some(found as u64)).then_some((declared, found));
    }

    /// Returns a sentence for each.
    pub(super) fn sentences(&self, width: usize) -> Vec<String> {
        let mut sentences = Vec::new();
        match self.frames {
            Some((Some(declared), found)) => {
                sentences.push(format!("The file says that it has {declared} frames, but it holds {found}: these are used"));
            }
            Some((None, found)) => sentences.push(format!("The file does not say how many frames it has: it holds {found}")),
            None => {}
        }
        sentences.extend(self.short.sentence(width, "the frame before it is shown instead"));
        sentences.extend(self.long.sentence(width, "the values behind them are left out"));
        if self.left_over > 0 {
            let left_over = self.left_over;
            sentences.push(format!("The last frame has {left_over} of {width} values and is left out"));
        }
        sentences
    }
}
