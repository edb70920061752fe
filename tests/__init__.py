"""The tests of Motion Theater; CONTRIBUTING.md says which folder tests what."""
