"""Motion <-> F-curves: reading what is there, noticing hand edits, writing what changes."""
