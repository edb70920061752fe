//! `motion-theater library show`.

use motion_theater_library::Library;

use super::arguments::ShowOptions;
use super::{failed, find, unknown};
use crate::console::Console;
use crate::{Failures, Outcome};

/// Runs the command.
pub fn run(library: &Library, options: &ShowOptions, console: &Console) -> Outcome {
    let mut failures = Failures::default();
    for name in &options.clips {
        let id = find(library, name).map_err(failed)?;
        let clips = library.clips(&id.into_iter().collect::<Vec<_>>()).map_err(failed)?;
        let Some(clip) = clips.first() else {
            console.warn(&unknown(name));
            failures.0 = true;
            continue;
        };
        let object = serde_json::to_value(clip).unwrap_or_default();
        if options.json {
            console.say(&object.to_string());
            continue;
        }
        for (field, value) in object.as_object().into_iter().flatten() {
            let text = match value {
                serde_json::Value::String(text) => text.clone(),
                other => other.to_string(),
            };
            // What nobody knows is left out.
            if !value.is_null() && !text.is_empty() && text != "[]" {
                console.say(&format!("{:22}{text}", format!("{field}:")));
            }
        }
    }
    Ok(failures)
}
