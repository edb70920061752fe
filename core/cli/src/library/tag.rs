//! `motion-theater library tag`.

use motion_theater_library::Library;

use super::arguments::TagOptions;
use super::{failed, find, unknown};
use crate::console::Console;
use crate::{Failures, Outcome, WrongUse};

/// Runs the command: all clips get the same tags, or none where one of them is not there.
pub fn run(library: &Library, options: &TagOptions, console: &Console) -> Outcome {
    if options.add.is_empty() && options.remove.is_empty() {
        return Err(WrongUse("which tags? Name them with --add or --remove".to_owned()).into());
    }
    let mut ids = Vec::new();
    let mut failures = Failures::default();
    for name in &options.clips {
        let id = find(library, name).map_err(failed)?;
        if id.is_none() {
            console.warn(&unknown(name));
            failures.0 = true;
        }
        ids.extend(id);
    }
    if !failures.0 {
        library.tag(&ids, &options.add, &options.remove).map_err(failed)?;
    }
    Ok(failures)
}
