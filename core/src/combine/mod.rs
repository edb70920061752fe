//! One track over what was there before: where it goes, how it meets the old motion, how its root is aligned.

mod align;
mod blend;
mod lay;
mod place;

pub use align::{align, Alignment, Rigid, RootPose};
pub use blend::{Border, Borders, Depth};
pub use lay::{lay_over, Manner, Overlay};
pub use place::{KeySpacing, Placement, Span};
