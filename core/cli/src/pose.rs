//! `motion-theater pose`: where everything is at one frame.

use std::path::Path;

use motion_theater_core::loaded::Loaded;
use motion_theater_core::markers::{Markers, PointKind};
use motion_theater_core::upright::to_z_up;
use serde::Serialize;

use crate::arguments::PoseOptions;
use crate::console::Console;
use crate::load::{load, moving, named_skeleton, skeleton, warning};
use crate::points::{points, positions};
use crate::{report, Outcome};

/// The fields of the JSON object; a marker that is not seen has no position.
#[derive(Debug, Serialize)]
struct PoseReport {
    path: String,
    frame: serde_json::Number,
    names: Vec<String>,
    /// In metres, Z up.
    positions_m: Vec<Option<[f64; 3]>>,
    /// In the file's own axes and units.
    positions_file: Vec<Option<[f64; 3]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    warning: Option<&'static str>,
}

/// Runs the command.
pub fn run(options: &PoseOptions, console: &Console) -> Outcome {
    let named = named_skeleton(options.skeleton.as_deref())?;
    let pose = load(&options.file, named.as_ref()).and_then(|loaded| pose_at(&loaded, options.frame));
    Ok(report(
        console,
        pose.map(|pose| {
            if options.json {
                console.say(&serde_json::to_string(&pose).unwrap_or_default());
            } else {
                pose.print(console);
            }
        }),
    ))
}

fn pose_at(loaded: &Loaded, frame: Option<f64>) -> Result<PoseReport, String> {
    let first = loaded.clip.first_frame() as f64;
    let last = first + loaded.frame_count().saturating_sub(1) as f64;
    let frame = frame.unwrap_or(first);
    if !(first..=last).contains(&frame) {
        return Err(match loaded.frame_count() {
            0 => format!("{}: without motion there is only the rest pose, frame {first}", loaded.path.display()),
            _ => format!("{}: its frames are {first} to {last}, without {frame}", loaded.path.display()),
        });
    }
    if let Some(markers) = loaded.clip.markers() {
        return seen_at(&loaded.path, markers, frame);
    }
    if loaded.frame_count() > 0 {
        moving(loaded)?;
    }
    let skeleton = skeleton(loaded)?;
    let points = points(&loaded.clip, skeleton);
    let positions = positions(&points, skeleton, loaded.motion.as_ref(), frame);
    let to_metres = to_z_up(skeleton.up) * skeleton.unit.metres;
    Ok(PoseReport {
        path: loaded.path.display().to_string(),
        frame: number(frame),
        names: points.into_iter().map(|point| point.name).collect(),
        positions_m: positions.iter().map(|at| Some((to_metres * *at).to_array())).collect(),
        positions_file: positions.iter().map(|at| Some(at.to_array())).collect(),
        warning: warning(loaded),
    })
}

/// Markers are where they were seen: there are none between two frames. What is no position has no place in metres.
fn seen_at(path: &Path, markers: &Markers, frame: f64) -> Result<PoseReport, String> {
    if frame.fract() != 0.0 {
        return Err(format!("{}: markers have whole frames, not {frame}", path.display()));
    }
    let index = (frame as i64 - markers.first_frame) as usize;
    let seen = |marker: usize| markers.positions.get(marker, index);
    let is_place = |marker: &usize| markers.kinds.get(*marker) == Some(&PointKind::Position);
    let to_metres = to_z_up(markers.up.axis) * markers.unit.metres;
    let place = |marker: usize| Some((to_metres * seen(marker)?).to_array());
    let all = 0..markers.count();
    Ok(PoseReport {
        path: path.display().to_string(),
        frame: number(frame),
        names: markers.names.clone(),
        positions_m: all.clone().map(|marker| Some(marker).filter(is_place).and_then(place)).collect(),
        positions_file: all.map(|marker| Some(seen(marker)?.to_array())).collect(),
        warning: None,
    })
}

/// A frame as JSON: whole where it is.
fn number(frame: f64) -> serde_json::Number {
    let whole = frame as i64;
    if whole as f64 == frame {
        whole.into()
    } else {
        serde_json::Number::from_f64(frame).unwrap_or_else(|| whole.into())
    }
}

impl PoseReport {
    /// Prints a table: metres, Z up.
    fn print(&self, console: &Console) {
        let width = self.names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        console.say(&format!("{}: frame {}, metres, Z up", self.path, self.frame));
        if let Some(warning) = self.warning {
            console.say(&format!("  {warning}"));
        }
        for (name, position) in self.names.iter().zip(&self.positions_m) {
            let text = match position {
                Some([x, y, z]) => format!("{x:10.4} {y:10.4} {z:10.4}"),
                None => "not seen".to_owned(),
            };
            if !console.say(&format!("{name:width$} {text}")) {
                break;
            }
        }
    }
}
