//! What a file becomes in another format.

use std::path::{Path, PathBuf};

use motion_theater_core::formats::amc::{with_dofs_for, Amc};
use motion_theater_core::formats::asf::Asf;
use motion_theater_core::formats::bvh::Bvh;
use motion_theater_core::formats::c3d::{C3d, Encoding, Processor, Storage};
use motion_theater_core::formats::csm::Csm;
use motion_theater_core::formats::trc::Trc;
use motion_theater_core::formats::AngleUnit;
use motion_theater_core::loaded::Loaded;
use motion_theater_core::markers::Markers;
use motion_theater_core::read::Format;
use motion_theater_core::stack::ASSUMED_RATE_HZ;
use motion_theater_core::{Dof, Motion, ParameterError, Skeleton};

use crate::folder::format_of;
use crate::joints_as_markers::joints_as_markers;
use crate::left_out::left_out;
use crate::load::{moving, skeleton, warning};
use crate::store::store;
use crate::WrongUse;

/// An angle below this is lost in what any capture resolves: a tenth of a degree.
const TRACE_RAD: f64 = 0.1 * std::f64::consts::PI / 180.0;

/// Files that are to be written together.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Files {
    /// The one that was asked for comes last.
    outputs: Vec<(PathBuf, Vec<u8>)>,
    /// What the format has no place for, a few words each.
    left_out: Vec<String>,
    /// What must be told of the motion that they hold.
    warning: Option<&'static str>,
}

impl Files {
    fn one(path: &Path, bytes: Vec<u8>) -> Self {
        Self { outputs: vec![(path.to_owned(), bytes)], ..Self::default() }
    }

    /// Writes them, the one that was asked for last: where it is there, all are.
    pub fn store(&self) -> Result<(), String> {
        self.outputs.iter().try_for_each(|(path, bytes)| store(path, bytes))
    }

    /// Returns the paths, the one that was asked for first.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.outputs.iter().rev().map(|(path, _)| path.as_path())
    }

    /// Tells with them what must be told of the skeleton that the motion was taken to have.
    pub fn warning_of(self, loaded: &Loaded) -> Self {
        Self { warning: warning(loaded), ..self }
    }

    /// Returns what became of a file: a line, and another one where there is something to be told.
    pub fn verdict(&self, input: &Path) -> String {
        let written: Vec<_> = self.paths().map(|path| path.display().to_string()).collect();
        let left_out =
            if self.left_out.is_empty() { String::new() } else { format!(" (left out: {})", self.left_out.join(", ")) };
        let warning = self.warning.map(|text| format!("\n  {text}")).unwrap_or_default();
        format!("{} -> {}{left_out}{warning}", input.display(), written.join(", "))
    }
}

/// Returns the format that the name of an output says.
pub fn output_format(path: &Path) -> Result<Format, WrongUse> {
    format_of(path).ok_or_else(|| {
        WrongUse(format!("{}: the extension says no format that can be written: {}", path.display(), Format::list()))
    })
}

/// Returns a file in a format, at another rate where one is given. In its own format and at its own rate, every value
/// stays what it is.
pub fn converted(loaded: &Loaded, format: Format, rate_hz: Option<f64>, output: &Path) -> Result<Files, String> {
    if format == loaded.clip.format && rate_hz.is_none() {
        return Ok(Files::one(output, loaded.clip.to_bytes()));
    }
    let resampled = |error: ParameterError| format!("{}: {error}", loaded.path.display());
    if let Some(markers) = loaded.clip.markers() {
        let Some(rate_hz) = rate_hz else { return of_markers(loaded, markers, format, output) };
        let changed = markers.resampled(rate_hz).map_err(resampled)?;
        return of_markers(loaded, &changed, format, output);
    }
    if loaded.frame_count() == 0 {
        return of_motion(loaded, skeleton(loaded)?, &Motion::default(), format, output);
    }
    let (skeleton, motion) = moving(loaded)?;
    let motion = match rate_hz {
        None => motion,
        Some(rate_hz) => {
            let known = Motion { rate_hz: loaded.rate_hz(), ..motion.clone() };
            &known.resampled(rate_hz).map_err(resampled)?
        }
    };
    Ok(of_motion(loaded, skeleton, motion, format, output)?.warning_of(loaded))
}

/// Returns a motion that was made from that of a file, in a format; as markers, its joints.
///
/// An AMC says nothing without its skeleton: where the one that the file has is not enough, an ASF of the same name is
/// written beside it.
pub fn of_motion(
    loaded: &Loaded,
    skeleton: &Skeleton,
    motion: &Motion,
    format: Format,
    output: &Path,
) -> Result<Files, String> {
    let has_frames = motion.frame_count > 0;
    match format {
        Format::Asf => Ok(Files::one(output, Asf::from_skeleton(&with_dofs_for(skeleton, motion)).to_bytes())),
        Format::Bvh => {
            let rate_hz = motion.rate_hz.or(Some(ASSUMED_RATE_HZ));
            let mut bvh = Bvh::from_motion(skeleton, &Motion { rate_hz, ..motion.clone() });
            bvh.motion = bvh.motion.filter(|_| has_frames);
            Ok(Files::one(output, bvh.to_bytes()))
        }
        _ if !has_frames => Err(format!("{}: there is no motion in it", loaded.path.display())),
        Format::Amc => {
            let motion = without_traces(skeleton, motion);
            let needed = with_dofs_for(skeleton, &motion);
            let amc = Amc::from_motion(&needed, &motion, AngleUnit::Degrees).to_bytes();
            let mut files = Files::one(output, amc);
            if loaded.clip.format != Format::Amc || needed != *skeleton {
                files.outputs.insert(0, (output.with_extension("asf"), Asf::from_skeleton(&needed).to_bytes()));
            }
            Ok(files)
        }
        _ => of_markers(loaded, &joints_as_markers(&loaded.clip, skeleton, motion), format, output),
    }
}

/// Returns a motion without angles of degrees of freedom that its bones do not have, where these never amount to anything:
/// the mean of rotations about two axes has a trace of the third, and is no reason for another skeleton.
fn without_traces(skeleton: &Skeleton, motion: &Motion) -> Motion {
    let mut motion = motion.clone();
    for (bone, channels) in skeleton.bones.iter().zip(&mut motion.bones) {
        for axis in (0..3).filter(|axis| !bone.dofs.contains(&Dof::Rotate(*axis))) {
            if channels.angles.iter().all(|angles| angles[axis].abs() < TRACE_RAD) {
                channels.angles.iter_mut().for_each(|angles| angles[axis] = 0.0);
            }
        }
    }
    motion
}

/// Returns markers in a format, with what the file had and they do not.
pub fn of_markers(loaded: &Loaded, markers: &Markers, format: Format, output: &Path) -> Result<Files, String> {
    let name = output.file_name().unwrap_or_default().to_string_lossy();
    let bytes = match format {
        Format::C3d => {
            let usual = Encoding { processor: Processor::Intel, storage: Storage::Float };
            let encoding = loaded.clip.c3d.as_ref().map_or(usual, C3d::encoding);
            C3d::compose(markers, encoding).map_err(|error| format!("{}: {error}", loaded.path.display()))?
        }
        Format::Csm => Csm::of_markers(markers).to_bytes(),
        Format::Trc => Trc::of_markers(markers, &name).to_bytes(),
        other => {
            return Err(format!(
                "{}: markers have no skeleton, so they cannot become {}",
                loaded.path.display(),
                other.extension().to_uppercase()
            ));
        }
    };
    Ok(Files { left_out: left_out(&loaded.clip, markers, format), ..Files::one(output, bytes) })
}
