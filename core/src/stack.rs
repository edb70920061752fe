//! Base motion + ordered tracks and filters -> the resulting channels.
