//! A catalogue of clips on disk: which there are, what is in them, what people say of them, how they look.
//!
//! This crate knows files and `SQLite`; it knows neither Python nor Blender.
//!
//! | module | what it does |
//! |---|---|
//! | [`catalogue`] | the database: opening it, folders, rows, edits, tags |
//! | [`query`] | what is searched for, and which clips that are |

pub mod catalogue;
pub mod error;
pub mod query;

pub use catalogue::Library;
pub use error::LibraryError;
