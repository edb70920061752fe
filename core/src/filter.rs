//! Median, moving average and weighted average over frames.
