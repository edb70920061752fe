//! Euler angles of any order <-> unit quaternions.
