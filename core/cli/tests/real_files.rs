//! The public data sets, where they are at hand: `../shared/data` beside the project.

mod common;

use std::path::{Path, PathBuf};

use common::{apart, Clips};

fn data(folder: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(folder);
    folder.is_dir().then_some(folder)
}

#[test]
fn every_motion_keeps_its_joints_through_amc_and_bvh() {
    let clips = Clips::new();
    for folder in ["bvh", "asf_amc"] {
        let Some(folder) = data(folder) else { continue };
        let folder = folder.display();
        let first = clips.run(&format!("convert {folder} {{}}/amc --format amc"));
        assert_eq!((first.code, first.err.as_str()), (0, ""));
        let second = clips.run("convert {}/amc {}/bvh --format bvh");
        assert_eq!((second.code, second.err.as_str()), (0, ""));
        let infos = clips.succeed(&format!("info --json {folder}")).json();
        for info in infos.iter().filter(|info| info["frames"].as_u64() > Some(0)) {
            let path = Path::new(info["path"].as_str().unwrap());
            let below = path.strip_prefix(folder.to_string()).unwrap().with_extension("");
            let frame = 1 + info["frames"].as_u64().unwrap() / 2;
            let [own, amc, bvh] = [
                path.display().to_string(),
                format!("{{}}/amc/{}.amc", below.display()),
                format!("{{}}/bvh/{}.bvh", below.display()),
            ]
            .map(|file| places(&clips, &file, frame));
            let size = extent(&own);
            // A BVH names starts and an AMC names ends, so each is compared with its own kind.
            let (distance, count) =
                if info["format"] == "bvh" { apart(&as_acclaim_names(own.clone()), &bvh) } else { apart(&own, &amc) };
            assert!(distance < 1e-5 * size, "{}: {distance} of {size}", path.display());
            assert!(count * 10 >= own.len() * 9, "{}: {count} of {}", path.display(), own.len());
        }
    }
}

/// What ASF calls the root, and a joint whose name is one of its keywords.
fn as_acclaim_names(mut points: Vec<(String, [f64; 3])>) -> Vec<(String, [f64; 3])> {
    for (name, _) in &mut points {
        if name == "End" || name == "End_End" {
            *name = format!("bone_{name}");
        }
    }
    "root".clone_into(&mut points[0].0);
    points
}

/// The points of a file in its own units.
fn places(clips: &Clips, file: &str, frame: u64) -> Vec<(String, [f64; 3])> {
    let pose = clips.succeed(&format!("pose {file} --frame {frame} --json")).json().remove(0);
    let names = pose["names"].as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_owned());
    let places = pose["positions_file"].as_array().unwrap().iter();
    names.zip(places.map(|at| [0, 1, 2].map(|axis| at[axis].as_f64().unwrap()))).collect()
}

fn extent(points: &[(String, [f64; 3])]) -> f64 {
    let along = |axis: usize| points.iter().map(move |(_, at)| at[axis]);
    let spans = (0..3).map(|axis| along(axis).fold(f64::MIN, f64::max) - along(axis).fold(f64::MAX, f64::min));
    spans.fold(0.0, f64::max)
}

#[test]
fn every_marker_file_goes_through_csm_and_trc() {
    let Some(folder) = data("c3d") else { return };
    let clips = Clips::new();
    for format in ["csm", "trc"] {
        let ended = clips.run(&format!("convert {} {{}}/{format} --format {format}", folder.display()));
        for line in ended.err.lines() {
            assert!(line.contains("btk_Empty.c3d"), "{line}");
        }
        let last = ended.out.lines().last().unwrap();
        assert!(last.ends_with(" converted, 0 skipped, 1 failed"), "{last}");
    }
}
