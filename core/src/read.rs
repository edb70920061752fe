//! From a path or bytes to what the file holds.
