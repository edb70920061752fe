//! Values between frames, and other rates.
