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

    /// Returns which lines it is about: "Line 12 (and 3 others like it)".
    fn lines(&self) -> String {
        let first = self.first_line;
        match self.count {
            0 | 1 => format!("Line {first}"),
            2 => format!("Line {first} (and another like it)"),
            count => format!("Line {first} (and {} others like it)", count - 1),
        }
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
                sentences.push(format!("The file says `Frames: {declared}` but holds {found}: these are used"));
            }
            Some((None, found)) => {
                sentences.push(format!("The file does not say how many frames it has: it holds {found}"));
            }
            None => {}
        }
        let Self { short, long, left_over, .. } = self;
        if short.count > 0 {
            let (lines, count) = (short.lines(), short.value_count);
            let done = "the frame before it is shown instead";
            sentences.push(format!("{lines} holds {count} of the {width} values of a frame: {done}"));
        }
        if long.count > 0 {
            let (lines, count) = (long.lines(), long.value_count);
            sentences
                .push(format!("{lines} holds {count} values where a frame has {width}: those behind are left out"));
        }
        if *left_over > 0 && width == 0 {
            sentences.push("There are values, but no joint has a channel for them: they are left out".to_owned());
        } else if *left_over > 0 {
            sentences.push(format!("The last frame holds {left_over} of its {width} values and is left out"));
        }
        sentences
    }
}
