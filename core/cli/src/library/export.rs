//! `motion-theater library export`.

use motion_theater_library::catalogue::ClipRow;
use motion_theater_library::query::{Order, Query, Sort};
use motion_theater_library::Library;
use serde_json::Value;

use super::arguments::ExportOptions;
use super::failed;
use crate::console::Console;
use crate::{Failures, Outcome};

/// So many clips are in memory at a time.
const PAGE: usize = 512;

/// Runs the command.
pub fn run(library: &Library, options: &ExportOptions, console: &Console) -> Outcome {
    let order = Order { sort: Sort::Path, ..Order::default() };
    let ids = library.search(&Query::default(), order).map_err(failed)?;
    if !options.json {
        console.say(&columns().join(","));
    }
    for page in ids.chunks(PAGE) {
        for clip in library.clips(page).map_err(failed)? {
            let object = serde_json::to_value(&clip).unwrap_or_default();
            let line = if options.json { object.to_string() } else { as_row(&object) };
            if !console.say(&line) {
                return Ok(Failures(false));
            }
        }
    }
    Ok(Failures(false))
}

/// Returns the names of all fields of a clip, in alphabetical order.
fn columns() -> Vec<String> {
    let object = serde_json::to_value(ClipRow::default()).unwrap_or_default();
    object.as_object().into_iter().flat_map(|fields| fields.keys().cloned()).collect()
}

/// Returns values separated by commas; in quotation marks where they hold one, a comma or the end of a line.
fn as_row(object: &Value) -> String {
    let cell = |value: &Value| {
        let text = match value {
            Value::Null => String::new(),
            Value::String(text) => text.clone(),
            Value::Array(items) => items.iter().map(plain).collect::<Vec<_>>().join("; "),
            other => other.to_string(),
        };
        if text.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", text.replace('"', "\"\""))
        } else {
            text
        }
    };
    object.as_object().into_iter().flat_map(|fields| fields.values()).map(cell).collect::<Vec<_>>().join(",")
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
