//! What a worker does with a file: read it once, hash it, tell what is in it.

use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use motion_theater_core::read::Format;

use super::skeletons::{Paired, Skeletons};
use super::walk::Found;
use crate::error::words;
use crate::facts::{self, Facts};

/// Every worker may hold a file of this size in memory; larger ones are read one at a time.
const USUAL_BYTES: i64 = 64 << 20;

/// Larger files are not read; no motion is as large.
const MOST_BYTES: i64 = 2 << 30;

/// How much of a file that is not read is hashed at a time.
const CHUNK_BYTES: usize = 1 << 20;

/// What became of one file.
pub(super) struct Reading {
    pub(super) found: Found,
    /// The BLAKE3 hash of the bytes; `None` where they could not be read.
    pub(super) hash: Option<[u8; 32]>,
    pub(super) outcome: Result<(Facts, Option<Paired>), Failure>,
}

/// A file that cannot be used, and why.
pub(super) struct Failure {
    pub(super) format: Option<Format>,
    pub(super) message: String,
}

/// Reads files; one for all workers.
pub(super) struct Reader<'a> {
    skeletons: &'a Skeletons,
    large: Mutex<()>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(skeletons: &'a Skeletons) -> Self {
        Self { skeletons, large: Mutex::new(()) }
    }

    /// Reads a file; `shared` is the worker's own, to be used again.
    pub(super) fn read(&self, found: Found, shared: &mut Arc<Vec<u8>>) -> Reading {
        let buffer = Arc::make_mut(shared);
        let _one_at_a_time =
            (found.size > USUAL_BYTES).then(|| self.large.lock().unwrap_or_else(PoisonError::into_inner));
        let by_name = || Format::from_extension(found.path.extension()?.to_str()?);
        if found.size > MOST_BYTES {
            let message = format!("the file is larger than {} GB, as no motion is", MOST_BYTES >> 30);
            let hash = hash_in_chunks(&found.path, buffer).ok();
            let outcome = Err(Failure { format: by_name(), message });
            return Reading { found, hash, outcome };
        }
        buffer.clear();
        // What the disk listed may have changed since: the bytes that are read are the ones that count.
        let bytes = File::open(&found.path).and_then(|mut file| file.read_to_end(buffer));
        if let Err(error) = bytes {
            let outcome = Err(Failure { format: by_name(), message: words(&error) });
            return Reading { found, hash: None, outcome };
        }
        let hash = Some(blake3::hash(buffer).into());
        let outcome = self.facts(shared, &found.path);
        if found.size > USUAL_BYTES {
            *shared = Arc::default();
        }
        Reading { found, hash, outcome }
    }

    fn facts(&self, source: &Arc<Vec<u8>>, path: &Path) -> Result<(Facts, Option<Paired>), Failure> {
        let failed = |message| Failure { format: Format::of(source, path), message };
        let skimmed = facts::skim(source, path);
        let (mut facts, mut clip) = skimmed.map_or_else(|| facts::read_shared(source, path), Ok).map_err(failed)?;
        if facts.format == Format::Asf {
            self.skeletons.keep(path, clip.skeleton.take().map(Arc::new));
        }
        let paired = (facts.format == Format::Amc).then(|| self.skeletons.pair(path, &clip));
        if let Some(paired) = &paired {
            if let Some(skeleton) = &paired.skeleton {
                facts.set_skeleton(skeleton);
            }
            if paired.is_default {
                facts.notices.push(paired.reason.clone());
            }
        }
        Ok((facts, paired))
    }
}

fn hash_in_chunks(path: &Path, buffer: &mut Vec<u8>) -> std::io::Result<[u8; 32]> {
    let mut file = File::open(path)?;
    let mut hasher = blake3::Hasher::new();
    buffer.resize(CHUNK_BYTES, 0);
    loop {
        let length = file.read(buffer)?;
        if length == 0 {
            return Ok(hasher.finalize().into());
        }
        hasher.update(buffer.get(..length).unwrap_or_default());
    }
}
