//! Which file becomes which.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use motion_theater_core::read::Format;

use crate::arguments::ConvertOptions;
use crate::folder::{format_of, look, Found};
use crate::write::output_format;
use crate::{Refusal, WrongUse};

/// One file to convert.
#[derive(Debug, Clone, PartialEq)]
pub struct Job {
    pub input: PathBuf,
    pub output: PathBuf,
    pub format: Format,
}

/// Returns what is to be done, or why one input has nothing to do.
///
/// One file goes to one file. Several, or a folder, go into a folder: a folder's files with the folders that they lie
/// in, other files side by side.
pub fn plan(options: &ConvertOptions) -> Result<Vec<Result<Job, String>>, Refusal> {
    let Some((output, inputs)) = options.paths.split_last() else { return Ok(Vec::new()) };
    let is_folder = inputs.len() > 1 || inputs.iter().any(|path| path.is_dir()) || is_meant_as_folder(output);
    let mut jobs = Vec::new();
    match (inputs, options.format) {
        ([input], format) if !is_folder => {
            let format = format.map_or_else(|| output_format(output), Ok)?;
            jobs.push(Ok(Job { input: input.clone(), output: output.clone(), format }));
        }
        (_, None) => {
            return Err(WrongUse("several files go into a folder, and --format says what they become".to_owned()).into())
        }
        (_, Some(_)) if output.is_file() => {
            return Err(WrongUse(format!("several files go into a folder, and {} is a file", output.display())).into())
        }
        (inputs, Some(format)) => {
            for input in inputs {
                match look(input, Some(output)) {
                    Ok(Found::File(path)) => {
                        let name = PathBuf::from(path.file_name().unwrap_or_default());
                        jobs.push(Ok(job(path, output, &name, format)));
                    }
                    Ok(Found::Folder(found)) => jobs.extend(of_folder(input, found, output, format)),
                    Err(text) => jobs.push(Err(text)),
                }
            }
        }
    }
    Ok(without_collisions(jobs))
}

fn is_meant_as_folder(output: &Path) -> bool {
    let text = output.to_string_lossy();
    output.is_dir() || text.ends_with(std::path::is_separator)
}

fn job(input: PathBuf, folder: &Path, below: &Path, format: Format) -> Job {
    Job { input, output: folder.join(below).with_extension(format.extension()), format }
}

/// The skeletons in a folder belong to the motions beside them: they become files of their own only among AMCs.
fn of_folder(input: &Path, found: Vec<(PathBuf, PathBuf)>, output: &Path, format: Format) -> Vec<Result<Job, String>> {
    let jobs: Vec<_> = found
        .into_iter()
        .filter_map(|(path, below)| match (format_of(&path), format) {
            (Some(Format::Asf), Format::Asf | Format::Amc) => Some(Ok(job(path, output, &below, Format::Asf))),
            (Some(Format::Asf), _) => None,
            _ => Some(Ok(job(path, output, &below, format))),
        })
        .collect();
    if jobs.is_empty() {
        vec![Err(format!("{}: no motion file is in it", input.display()))]
    } else {
        jobs
    }
}

/// Of several files that would become the same one, only the first does.
fn without_collisions(jobs: Vec<Result<Job, String>>) -> Vec<Result<Job, String>> {
    let mut taken: HashMap<PathBuf, PathBuf> = HashMap::new();
    let mut check = |job: Job| {
        let Some(first) = taken.insert(job.output.clone(), job.input.clone()) else { return Ok(job) };
        let (input, output) = (job.input.display(), job.output.display());
        let text = format!("{input}: not converted, for {output} is made from {}", first.display());
        taken.insert(job.output, first);
        Err(text)
    };
    jobs.into_iter().map(|job| job.and_then(&mut check)).collect()
}
