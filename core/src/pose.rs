//! Forward kinematics.
