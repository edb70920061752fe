//! Reads motion capture, combines it and filters it.
//!
//! This crate knows neither Python nor Blender: bytes and plain data in, plain data out.
//!
//! | module | what it does |
//! |---|---|
//! | [`formats`] | bytes <-> what a file says, and from there a [`Skeleton`] and a [`Motion`], or [`Markers`] |
//! | [`gaps`] | gaps of markers, found and filled; which markers are neighbours |
//! | [`infer`] | what a file does not say: the unit, which axis is up, where it faces |
//! | [`number`] | decimal numbers in text, fast and exact |
//! | [`pose`] | forward kinematics |
//! | [`sample`] | values between frames, other rates |
//! | [`combine`] | cut, scale, blend and align one track over what was there |
//! | [`filter`] | median, moving average, weighted average |
//! | [`recipe`] | a stack as a small TOML or JSON file |
//! | [`pairing`] | which skeleton file belongs to a motion file |
//! | [`loaded`] | a file with what belongs to it |
//! | [`sidecar`] | what people say of a clip, in a small text beside it |
//! | [`upright`] | from a file's axes to Z up |
//! | [`skim`] | what a file is about, without reading every number in it |
//! | [`stack`] | base motion + ordered tracks and filters -> the resulting channels and what to tell the user |

mod bytes;
pub mod combine;
pub mod error;
pub mod euler;
pub mod filter;
pub mod formats;
pub mod gaps;
pub mod infer;
pub mod keys;
pub mod loaded;
pub mod markers;
pub mod motion;
pub mod number;
pub mod pairing;
pub mod pose;
pub mod rate;
pub mod read;
pub mod recipe;
pub mod rest_axes;
pub mod sample;
pub mod sidecar;
pub mod skeleton;
pub mod skim;
pub mod stack;
mod table;
mod tally;
mod text;
pub mod upright;
pub mod value;

pub use error::{MisfitError, ParameterError, ParseError, Position, ReadError};
pub use markers::Markers;
pub use motion::{BoneMotion, Motion};
pub use skeleton::{Bone, Dof, EulerOrder, LengthUnit, Limit, Skeleton};
