//! Keys of one channel over scene frames.
