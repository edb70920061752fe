//! What a file becomes in another format.

use std::path::{Path, PathBuf};

use motion_theater_core::formats::amc::{with_dofs_for, Amc};
use motion_theater_core::formats::asf::Asf;
use motion_theater_core::formats::bvh::Bvh;
use motion_theater_core::formats::AngleUnit;
use motion_theater_core::read::Format;
use motion_theater_core::stack::ASSUMED_RATE_HZ;
use motion_theater_core::{Motion, Skeleton};

use crate::folder::format_of;
use crate::load::Loaded;
use crate::store::store;
use crate::WrongUse;

/// Files that are to be written together; the one that was asked for comes last.
#[derive(Debug, Clone, PartialEq)]
pub struct Files(Vec<(PathBuf, Vec<u8>)>);

impl Files {
    /// Writes them, the one that was asked for last: where it is there, all are.
    pub fn store(&self) -> Result<(), String> {
        self.0.iter().try_for_each(|(path, bytes)| store(path, bytes))
    }

    /// Returns the paths, the one that was asked for first.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().rev().map(|(path, _)| path.as_path())
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
        return Ok(Files(vec![(output.to_owned(), loaded.clip.to_bytes())]));
    }
    if loaded.frame_count() == 0 {
        let skeleton = loaded.skeleton()?;
        return moving(loaded, skeleton, &Motion::default(), format, output);
    }
    let (skeleton, motion) = loaded.moving()?;
    let Some(rate_hz) = rate_hz else { return moving(loaded, skeleton, motion, format, output) };
    let known = Motion { rate_hz: loaded.rate_hz(), ..motion.clone() };
    let resampled = known.resampled(rate_hz).map_err(|error| format!("{}: {error}", loaded.path.display()))?;
    moving(loaded, skeleton, &resampled, format, output)
}

/// Returns a motion that was made from that of a file, in a format.
///
/// An AMC says nothing without its skeleton: where the one that the file has is not enough, an ASF of the same name is
/// written beside it.
pub fn moving(
    loaded: &Loaded,
    skeleton: &Skeleton,
    motion: &Motion,
    format: Format,
    output: &Path,
) -> Result<Files, String> {
    let files = match format {
        Format::Asf => vec![(output.to_owned(), Asf::from_skeleton(&with_dofs_for(skeleton, motion)).to_bytes())],
        Format::Amc => {
            let needed = with_dofs_for(skeleton, motion);
            let amc = Amc::from_motion(&needed, motion, AngleUnit::Degrees).to_bytes();
            let own_is_enough = loaded.clip.format == Format::Amc && needed == *skeleton;
            let asf = (!own_is_enough).then(|| (output.with_extension("asf"), Asf::from_skeleton(&needed).to_bytes()));
            asf.into_iter().chain([(output.to_owned(), amc)]).collect()
        }
        Format::Bvh => {
            let rate_hz = motion.rate_hz.or(Some(ASSUMED_RATE_HZ));
            let bvh = Bvh::from_motion(skeleton, &Motion { rate_hz, ..motion.clone() });
            vec![(output.to_owned(), bvh.to_bytes())]
        }
        other => {
            return Err(format!(
                "{}: a skeleton's motion cannot become {}",
                loaded.path.display(),
                other.extension().to_uppercase()
            ));
        }
    };
    Ok(Files(files))
}
