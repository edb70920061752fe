//! What speaks for a skeleton, in words.

use std::fmt;

/// What speaks for a skeleton, the strongest first.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Reason {
    /// The user gave it together with the motion.
    Chosen,
    /// The motion's sidecar names it.
    Sidecar,
    /// The motion file names it.
    Motion,
    /// It has the name of the motion.
    Name,
    /// Its name begins with the motion's subject.
    Subject(String),
    /// There is no other in the motion's folder.
    OnlyOne,
    /// There is no other in the folder above.
    OnlyOneAbove,
    /// It lies in the motion's folder.
    Folder,
    /// It lies in the folder above.
    Above,
    /// It is known, wherever it lies.
    Bones,
}

impl fmt::Display for Reason {
    /// Writes the end of the sentence "Took 02.asf, because ...".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Chosen => f.write_str("it came with the motion"),
            Self::Sidecar => f.write_str("named in the sidecar"),
            Self::Motion => f.write_str("named in the motion file"),
            Self::Name => f.write_str("it has the same name"),
            Self::Subject(subject) => write!(f, "it is of the same subject, {subject}"),
            Self::OnlyOne => f.write_str("it is the only skeleton in the folder"),
            Self::OnlyOneAbove => f.write_str("it is the only skeleton of the folder above"),
            Self::Folder => f.write_str("its bones fit and it lies in the same folder"),
            Self::Above => f.write_str("its bones fit and it lies in the folder above"),
            Self::Bones => f.write_str("its bones fit"),
        }
    }
}
