//! A catalogue of clips on disk: which there are, what is in them, what people say of them, how they look.
//!
//! This crate knows files and `SQLite`; it knows neither Python nor Blender.
//!
//! | module | what it does |
//! |---|---|
//! | [`catalogue`] | the database: opening it, folders, rows, edits, tags |
//! | [`facts`] | what is in a file, without its samples |
//! | [`figure`] | a clip as points and lines, ready to draw |
//! | [`index_file`] | lists that describe the clips of a folder |
//! | [`preview`] | how a clip looks: a still and a moving strip, drawn once and kept |
//! | [`query`] | what is searched for, and which clips that are |
//! | [`scan`] | folders compared with the database: what is new, changed, moved or gone |
//! | [`sidecar`] | the `.i3d` beside a clip |

pub mod catalogue;
pub mod error;
pub mod facts;
pub mod figure;
pub mod index_file;
pub mod preview;
pub mod query;
pub mod scan;
pub mod sidecar;

pub use catalogue::Library;
pub use error::LibraryError;
