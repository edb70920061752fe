//! `motion-theater library sidecar`.

use motion_theater_library::sidecar::{today, Field, SidecarFile};
use motion_theater_library::{Library, LibraryError};

use super::arguments::SidecarOptions;
use super::{failed, find, unknown};
use crate::console::Console;
use crate::{Failures, Outcome};

/// Where systems keep the user's name.
const NAMES: [&str; 3] = ["LOGNAME", "USER", "USERNAME"];

/// Runs the command: a sidecar that cannot be saved is what it was, and the others are done all the same.
pub fn run(library: &Library, options: &SidecarOptions, console: &Console) -> Outcome {
    let mut failures = Failures::default();
    for name in &options.clips {
        let Some(id) = find(library, name).map_err(failed)? else {
            console.warn(&unknown(name));
            failures.0 = true;
            continue;
        };
        match written(library, id, options) {
            Ok(sidecar) => print(&sidecar, options.json, console),
            Err(error) => {
                console.warn(&error.to_string().replace(['\n', '\r'], " "));
                failures.0 = true;
            }
        }
    }
    Ok(failures)
}

/// Returns the sidecar of a clip as it is after what was asked for.
fn written(library: &Library, id: i64, options: &SidecarOptions) -> Result<SidecarFile, LibraryError> {
    let who = NAMES.iter().find_map(|name| std::env::var(name).ok()).unwrap_or_default();
    if options.write {
        library.write_sidecar(id, &[], &today(), &who)?;
    }
    let mut file = library.sidecar(id)?;
    if !options.set.is_empty() {
        for (field, value) in &options.set {
            file.sidecar.set(*field, value).map_err(motion_theater_library::sidecar::SidecarError::from)?;
        }
        file.stamp(&today(), &who)?;
        file.save()?;
        library.read_sidecar(id, &options.set.iter().map(|(field, _)| *field).collect::<Vec<_>>())?;
    }
    Ok(file)
}

/// Prints the lines that have a value, those that no field means after them.
fn print(file: &SidecarFile, is_json: bool, console: &Console) {
    let value = |field: Field| file.sidecar.get(field).unwrap_or_default();
    if is_json {
        let fields = Field::ALL.into_iter().map(|field| (field.name().to_owned(), value(field).into())).collect();
        let object = serde_json::json!({
            "path": file.path().to_string_lossy(),
            "is_on_disk": file.is_on_disk(),
            "fields": serde_json::Value::Object(fields),
            "unknown": file.sidecar.unknown().collect::<Vec<_>>(),
        });
        console.say(&object.to_string());
        return;
    }
    let state = if file.is_on_disk() { "" } else { " (not written yet)" };
    console.say(&format!("{}{state}", file.path().display()));
    for field in Field::ALL.into_iter().filter(|field| !value(*field).is_empty()) {
        console.say(&format!("  {}: {}", field.label(), value(field)));
    }
    for line in file.sidecar.unknown() {
        console.say(&format!("  {line}"));
    }
}
