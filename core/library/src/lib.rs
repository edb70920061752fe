//! A catalogue of clips on disk: which there are, what is in them, what people say of them, how they look.

pub mod figure;
pub mod sidecar;
