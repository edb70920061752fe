//! One track over what was there before.
