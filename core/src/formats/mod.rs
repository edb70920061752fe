//! One file or folder per format, named after it.
