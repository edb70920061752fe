//! Acclaim skeletons (`.asf`).
//!
//! ```text
//! asf       = { section }
//! section   = :version TEXT | :name TEXT
//!           | :units { mass N | length N | angle (deg | rad) }
//!           | :documentation { any line }
//!           | :root { order dof... | axis ORDER | position N N N | orientation N N N }
//!           | :bonedata { begin { field } end }
//!           | :hierarchy [begin] { parent { child } } [end]
//!           | :OTHER { any line }
//! field     = id N | name NAME | direction N N N | length N | axis N N N [ORDER] | dof dof...
//!           | limits { "(" N N ")" } | bodymass N | cofmass N... | any other line
//! ```
//! Keywords are recognised in either case (endorphin writes `tx ty tz`, Vicon `TX TY TZ`); names keep theirs. Sections
//! and fields may come in any order. What has no meaning here is kept as text and written again; comments are not.
//! A file that ends early is refused, unless all that is lost comes after the last word.

mod bone;
mod build;
mod hierarchy;
mod read;
mod skeleton;
#[cfg(test)]
mod tests;
mod unit;
mod write;

pub(crate) use build::file_names;
pub(crate) use skeleton::rotation_order;

use super::AngleUnit;
use crate::error::ParseError;
use crate::skeleton::{Dof, EulerOrder, Limit};

/// What an ASF file says, in its own units and order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Asf {
    /// The text behind `:version`.
    pub version: Option<String>,
    /// The text behind `:name`.
    pub name: Option<String>,
    /// `:units`.
    pub units: Units,
    /// The lines of `:documentation`, as they are.
    pub documentation: Option<Vec<String>>,
    /// `:root`.
    pub root: Root,
    /// `:bonedata`, in file order.
    pub bones: Vec<AsfBone>,
    /// `:hierarchy`, line by line.
    pub hierarchy: Vec<Family>,
    /// Sections without a meaning here, in file order.
    pub others: Vec<OtherSection>,
}

/// The section `:units`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Units {
    /// What a mass is to be multiplied by.
    pub mass: Option<f64>,
    /// What a length is to be divided by; from 1e-9 to 1e9.
    pub length: Option<f64>,
    /// The unit of angles; degrees where the file does not say.
    pub angle: Option<AngleUnit>,
    /// Other lines, as they are.
    pub others: Vec<String>,
}

/// The section `:root`: the top of the hierarchy, which is a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Root {
    /// The values of a frame.
    pub order: Vec<Dof>,
    /// The order in which the angles of `orientation` are applied.
    pub axis: EulerOrder,
    /// Where the root stands in the rest pose.
    pub position: [f64; 3],
    /// The root's own axes, as angles about X, Y and Z.
    pub orientation: [f64; 3],
    /// Other lines, as they are.
    pub others: Vec<String>,
}

impl Default for Root {
    /// What the format says where a file does not.
    fn default() -> Self {
        let order = (0..3).map(Dof::Translate).chain((0..3).map(Dof::Rotate)).collect();
        Self { order, axis: EulerOrder::Xyz, position: [0.0; 3], orientation: [0.0; 3], others: Vec::new() }
    }
}

/// One `begin ... end` of `:bonedata`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct AsfBone {
    /// The file's number of the bone.
    pub id: Option<i64>,
    /// The bone's name: one word.
    pub name: String,
    /// Where the bone points, in global axes; usually of length 1.
    pub direction: [f64; 3],
    /// What `direction` is multiplied by.
    pub length: f64,
    /// The bone's own axes, as angles about X, Y and Z ...
    pub axis: [f64; 3],
    /// ... applied in this order.
    pub axis_order: EulerOrder,
    /// The values of a frame, in file order.
    pub dofs: Vec<Dof>,
    /// The pairs of `limits`, in file units; not always as many as degrees of freedom.
    pub limits: Vec<Limit>,
    /// The mass of the body around the bone.
    pub body_mass: Option<f64>,
    /// Where the centre of that mass lies: the numbers as given.
    pub centre_of_mass: Vec<f64>,
    /// Other lines, as they are.
    pub others: Vec<String>,
}

/// One line of `:hierarchy`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Family {
    /// A bone, or `root`.
    pub parent: String,
    /// The bones that start where it ends.
    pub children: Vec<String>,
}

/// A section without a meaning here, such as `:skin`.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct OtherSection {
    /// Its name with the colon.
    pub name: String,
    /// The rest of the line of its name.
    pub value: String,
    /// Its lines, as they are.
    pub lines: Vec<String>,
}

/// The name of the top of the hierarchy.
pub(crate) const ROOT: &str = "root";

impl Asf {
    /// Reads what a file says.
    ///
    /// # Errors
    /// Where the bytes are something else, a number is missing or damaged, a bone is not complete, or the hierarchy does
    /// not connect every bone with the root in exactly one way.
    pub fn parse(source: &[u8]) -> Result<Self, ParseError> {
        read::parse(source)
    }

    /// Returns the unit of the file's angles.
    pub fn angle_unit(&self) -> AngleUnit {
        self.units.angle.unwrap_or(AngleUnit::Degrees)
    }
}

/// The words for degrees of freedom, in lower case.
const DOF_WORDS: [(&str, Dof); 7] = [
    ("tx", Dof::Translate(0)),
    ("ty", Dof::Translate(1)),
    ("tz", Dof::Translate(2)),
    ("rx", Dof::Rotate(0)),
    ("ry", Dof::Rotate(1)),
    ("rz", Dof::Rotate(2)),
    ("l", Dof::Length),
];

/// Returns the word for a degree of freedom, as an ASF has it: `rx`.
pub fn dof_word(dof: Dof) -> &'static str {
    DOF_WORDS.iter().find(|(_, known)| *known == dof).map_or("?", |(word, _)| word)
}

/// Returns the words for degrees of freedom, as an ASF has them: `rx ry rz`.
pub fn dof_words(dofs: &[Dof]) -> String {
    dofs.iter().map(|dof| dof_word(*dof)).collect::<Vec<_>>().join(" ")
}

/// The words for orders of angles.
const ORDER_WORDS: [(&str, EulerOrder); 6] = [
    ("XYZ", EulerOrder::Xyz),
    ("XZY", EulerOrder::Xzy),
    ("YXZ", EulerOrder::Yxz),
    ("YZX", EulerOrder::Yzx),
    ("ZXY", EulerOrder::Zxy),
    ("ZYX", EulerOrder::Zyx),
];
