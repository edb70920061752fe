//! BVH motions (`.bvh`): a hierarchy of joints and the values of their channels over frames.
//!
//! ```text
//! bvh       = HIERARCHY root { root } [ MOTION head { VALUE } ]
//! root      = ROOT joint
//! joint     = [NAME] "{" { OFFSET N N N | CHANNELS COUNT { CHANNEL } | JOINT joint | end_site } "}"
//! end_site  = End [Site] [NAME] "{" OFFSET N N N "}"
//! head      = [ Frames [:] COUNT ] [ Frame Time [:] SECONDS ]        in either order
//! ```
//! Keywords and channels are recognised in either case. A name is the rest of its line, blanks included, up to a brace
//! that stands alone or ends the line. A joint has exactly one `OFFSET` and at most one `CHANNELS`, which lists any of
//! the six channels in any order and number. Values come in file order, usually one line per frame; what happens where
//! they do not is said in [`rows`].

mod convert;
mod faults;
mod hierarchy;
mod motion;
mod name;
mod rows;
mod skeleton;
mod skim;
#[cfg(test)]
mod tests;
mod tokens;
mod write;

use crate::error::ParseError;
use crate::formats::kind::{self, Kind};
use crate::skeleton::Dof;
use faults::Faults;
use tokens::Tokens;

/// What a BVH file says, in its own units, names and order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bvh {
    /// The joints as they are nested: each behind its parent, with all its descendants before its next sibling.
    pub joints: Vec<Joint>,
    /// What stands behind `MOTION`; `None` for a hierarchy alone.
    pub motion: Option<BvhMotion>,
    /// Where the motion says something else than it holds.
    faults: Faults,
}

/// One `ROOT` or `JOINT`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Joint {
    /// The joint's name as it is, possibly empty, not always the only one of its kind.
    pub name: String,
    /// Index of the parent; `None` for a root.
    pub parent: Option<usize>,
    /// Where it starts, from its parent's start, unless position channels say something else.
    pub offset: [f64; 3],
    /// The values of a frame, in file order.
    pub channels: Vec<Channel>,
    /// Where the bone ends: mostly one for a joint without children, and none for others.
    pub end_sites: Vec<EndSite>,
}

/// The end of a bone.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EndSite {
    /// The name that some files give it, or empty.
    pub name: String,
    /// Where it is, from the joint's start.
    pub offset: [f64; 3],
}

/// What one value of a frame means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Channel {
    /// `Xposition`, `Yposition` or `Zposition` (0, 1, 2): stands in for that component of the offset.
    Position(usize),
    /// `Xrotation`, `Yrotation` or `Zrotation` (0, 1, 2): degrees.
    Rotation(usize),
}

/// The values of the channels over frames.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BvhMotion {
    /// `Frame Time`, in seconds, whatever it is; `None` where the file does not say.
    pub frame_time_s: Option<f64>,
    /// How many frames there are.
    pub frame_count: usize,
    /// Frame by frame the values of all channels, as they are in the file.
    pub values: Vec<f64>,
}

/// The words for channels, as files have them.
const CHANNEL_WORDS: [(&str, Channel); 6] = [
    ("Xposition", Channel::Position(0)),
    ("Yposition", Channel::Position(1)),
    ("Zposition", Channel::Position(2)),
    ("Xrotation", Channel::Rotation(0)),
    ("Yrotation", Channel::Rotation(1)),
    ("Zrotation", Channel::Rotation(2)),
];

impl Channel {
    /// Returns the channel's word, such as `Xrotation`.
    pub fn word(self) -> &'static str {
        CHANNEL_WORDS.iter().find(|(_, known)| *known == self).map_or("?", |(word, _)| word)
    }

    /// Returns the degree of freedom that it is.
    fn dof(self) -> Dof {
        match self {
            Self::Position(axis) => Dof::Translate(axis),
            Self::Rotation(axis) => Dof::Rotate(axis),
        }
    }
}

impl Bvh {
    /// Makes what a file would say: joints as they are nested, and rows of as many values as these have channels.
    pub fn new(joints: Vec<Joint>, motion: Option<BvhMotion>) -> Self {
        Self { joints, motion, faults: Faults::default() }
    }

    /// Reads what a file says.
    ///
    /// # Errors
    /// Where the bytes are something else, the hierarchy is damaged or a value is no number. Too many or too few values
    /// are no error: see [`Bvh::notices`].
    pub fn parse(source: &[u8]) -> Result<Self, ParseError> {
        kind::check(source, Kind::Bvh)?;
        let mut tokens = Tokens::new(source);
        let joints = hierarchy::read(&mut tokens)?;
        let mut bvh = Self { joints, ..Self::default() };
        if tokens.next().is_some() {
            let head = rows::read_head(&mut tokens)?;
            let rows = rows::read(source, tokens.at(), &bvh)?;
            bvh.faults = rows.faults;
            bvh.faults.set_declared(head.frame_count, rows.frame_count);
            bvh.motion =
                Some(BvhMotion { frame_time_s: head.frame_time_s, frame_count: rows.frame_count, values: rows.values });
        }
        Ok(bvh)
    }

    /// Returns how many values a frame has.
    pub fn width(&self) -> usize {
        self.joints.iter().map(|joint| joint.channels.len()).sum()
    }
}
