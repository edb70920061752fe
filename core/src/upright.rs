//! From a file's axes and units into metres with Z up, as in Blender.

use glam::{DMat3, DVec3};

/// The axes of a file by their names.
const AXES: [(&str, DVec3); 6] = [
    ("X", DVec3::X),
    ("Y", DVec3::Y),
    ("Z", DVec3::Z),
    ("-X", DVec3::NEG_X),
    ("-Y", DVec3::NEG_Y),
    ("-Z", DVec3::NEG_Z),
];

/// Returns the name of the axis nearest to a direction: `Y`, `-Z`.
pub fn axis_name(up: DVec3) -> &'static str {
    let nearest = AXES.iter().max_by(|a, b| a.1.dot(up).total_cmp(&b.1.dot(up)));
    nearest.map_or("", |(name, _)| name)
}

/// Returns the matrix from a file's axes to Z up. A figure that faces +Z with Y up faces -Y then, the viewer.
///
/// It only swaps and turns signs, so that a file's numbers stay themselves.
pub fn to_z_up(up: DVec3) -> DMat3 {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    // Each row makes one coordinate.
    let [right, back, top] = match axis_name(up) {
        "X" => [-z, y, x],
        "-X" => [z, y, -x],
        "Y" => [x, -z, y],
        "-Y" => [x, z, -y],
        "-Z" => [x, -y, -z],
        _ => [x, y, z],
    };
    DMat3::from_cols(right, back, top).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_becomes_z_and_nothing_is_mirrored() {
        for (name, up) in AXES {
            let turn = to_z_up(up);
            assert_eq!(axis_name(up), name);
            assert_eq!(turn * up, DVec3::Z, "{name}");
            assert_eq!(turn.determinant(), 1.0, "{name}");
        }
    }

    #[test]
    fn y_up_is_turned_as_blender_does() {
        assert_eq!(to_z_up(DVec3::Y) * DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, -3.0, 2.0));
    }
}
