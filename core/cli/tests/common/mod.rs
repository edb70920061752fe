//! The program as a caller sees it: arguments in; exit code and two streams out.

#![allow(dead_code)] // each file of tests uses its own part

use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use motion_theater_cli::{run, Console};
use serde_json::Value;

/// How a run ended.
pub struct Ended {
    pub code: u8,
    pub out: String,
    pub err: String,
}

impl Ended {
    /// Every line of output as JSON.
    pub fn json(&self) -> Vec<Value> {
        self.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

#[derive(Clone, Default)]
struct Buffer(Arc<Mutex<Vec<u8>>>);

impl Write for Buffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Runs the program with arguments separated by blanks; `{}` stands for `folder`.
pub fn program(arguments: &str, folder: &Path) -> Ended {
    let words = arguments.split_whitespace().map(|word| word.replace("{}", &folder.display().to_string()));
    let words = ["motion-theater".to_owned()].into_iter().chain(words).map(OsString::from);
    let (out, err) = (Buffer::default(), Buffer::default());
    let code = run(words, &Console::new(out.clone(), err.clone()), &AtomicBool::new(false));
    let text = |buffer: Buffer| String::from_utf8(buffer.0.lock().unwrap().clone()).unwrap();
    Ended { code, out: text(out), err: text(err) }
}

/// A folder with copies of our clips, removed at the end.
pub struct Clips(pub PathBuf);

impl Clips {
    pub fn new() -> Self {
        static NEXT: AtomicUsize = AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("motion-theater-cli-{}-{number}", std::process::id()));
        let clips = Self(folder);
        for name in ["human.asf", "wave.amc", "step_and_jump.amc"] {
            let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../testdata").join(name);
            clips.write(name, &std::fs::read(source).unwrap());
        }
        clips
    }

    pub fn run(&self, arguments: &str) -> Ended {
        program(arguments, &self.0)
    }

    /// Runs what must go well, and returns its output.
    pub fn succeed(&self, arguments: &str) -> Ended {
        let ended = self.run(arguments);
        assert_eq!((ended.code, ended.err.as_str()), (0, ""), "{arguments}");
        ended
    }

    pub fn write(&self, name: &str, bytes: &[u8]) {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.join(name)).unwrap()
    }

    pub fn has(&self, name: &str) -> bool {
        self.0.join(name).exists()
    }

    /// The positions of a file at a frame in metres, by name.
    pub fn pose(&self, file: &str, frame: &str) -> Vec<(String, [f64; 3])> {
        let pose = self.succeed(&format!("pose {{}}/{file} --frame {frame} --json")).json().remove(0);
        let names = pose["names"].as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_owned());
        let places = pose["positions_m"].as_array().unwrap().iter();
        let places = places.map(|at| [0, 1, 2].map(|axis| at[axis].as_f64().unwrap_or(f64::NAN)));
        names.zip(places).collect()
    }
}

impl Drop for Clips {
    fn drop(&mut self) {
        // A folder that stays behind in the system's own place for such is no reason to fail.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The largest distance between points of the same name, and how many of those there are.
pub fn apart(a: &[(String, [f64; 3])], b: &[(String, [f64; 3])]) -> (f64, usize) {
    let distances: Vec<f64> = a
        .iter()
        .filter_map(|(name, at)| Some((at, b.iter().find(|(other, _)| other == name)?.1)))
        .map(|(at, other)| (0..3).map(|axis| (at[axis] - other[axis]).powi(2)).sum::<f64>().sqrt())
        .collect();
    (distances.iter().copied().fold(0.0, f64::max), distances.len())
}
