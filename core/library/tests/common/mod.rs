//! Small libraries to scan.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use motion_theater_library::catalogue::ClipRow;
use motion_theater_library::scan::{Options, Progress, Scan};
use motion_theater_library::Library;

/// A library beside a folder of clips.
pub struct Stage {
    pub library: Arc<Library>,
    pub clips: PathBuf,
    _folder: tempfile::TempDir,
}

impl Stage {
    /// A folder of these files (by their paths below it), and a library that knows it; nothing is scanned yet.
    pub fn with(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().expect("a folder for the test");
        let clips = folder.path().join("clips");
        std::fs::create_dir(&clips).expect("a folder of clips");
        let library = Library::open(&folder.path().join("library.sqlite")).expect("a new library");
        library.add_folder(&clips).expect("a folder that is there");
        let stage = Self { library: Arc::new(library), clips, _folder: folder };
        for (name, text) in files {
            stage.put(name, text);
        }
        stage
    }

    /// Writes a file.
    pub fn put(&self, name: &str, text: &str) {
        let path = self.clips.join(name);
        std::fs::create_dir_all(path.parent().expect("within the folder")).expect("folders");
        std::fs::write(path, text).expect("a file");
    }

    /// Moves a file.
    pub fn rename(&self, from: &str, to: &str) {
        let to = self.clips.join(to);
        std::fs::create_dir_all(to.parent().expect("within the folder")).expect("folders");
        std::fs::rename(self.clips.join(from), to).expect("a file that is moved");
    }

    /// Scans everything, and returns what came of it.
    pub fn scan(&self) -> Progress {
        let scan = Scan::start(&self.library, &Options::default()).expect("a scan");
        assert!(scan.wait(None));
        let progress = scan.progress();
        assert_eq!(progress.error, None);
        progress
    }

    /// The clip of a file.
    pub fn clip(&self, name: &str) -> ClipRow {
        self.find(name).unwrap_or_else(|| panic!("no clip {name}"))
    }

    /// The clip of a file, if there is one.
    pub fn find(&self, name: &str) -> Option<ClipRow> {
        let id = self.library.find(&self.path(name)).expect("a library that can be read")?;
        self.library.clips(&[id]).expect("a library that can be read").pop()
    }

    /// Where a file is.
    pub fn path(&self, name: &str) -> PathBuf {
        self.clips.join(Path::new(name))
    }
}

/// A BVH of two joints and so many frames at 50 Hz; `start` makes its values its own.
pub fn bvh(frames: usize, start: usize) -> String {
    let rows: String = (start..start + frames).map(|i| format!("{i}.5 2 3 0.25 -1e-2 {i}\n")).collect();
    format!(
        "HIERARCHY\nROOT Hips\n{{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n\
         JOINT Spine\n{{\nOFFSET 0 1 0\nEnd Site\n{{\nOFFSET 0 1 0\n}}\n}}\n}}\nMOTION\nFrames: {frames}\nFrame Time: 0.02\n{rows}"
    )
}
