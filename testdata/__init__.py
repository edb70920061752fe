"""Clips of our own for tests and the demo; `generate` makes them."""
