//! A stack file as text.

use std::path::Path;

use serde::Deserialize;

use super::{Recipe, VERSION};
use crate::error::ParameterError;

impl Recipe {
    /// Reads a stack file: JSON where it begins with `{`, else TOML. `name` stands for its path in messages.
    ///
    /// # Errors
    /// Where it is neither, holds something unknown, or is of a newer version; the message has the line.
    pub fn parse(source: &str, name: &Path) -> Result<Self, ParameterError> {
        let wrong = |place: String, text: String| ParameterError(format!("{}{place}: {text}", name.display()));
        let source = source.trim_start_matches('\u{FEFF}');
        let recipe: Self = if source.trim_start().starts_with('{') {
            serde_json::from_str(source).map_err(|error| {
                let text = error.to_string();
                let text = text.split(" at line ").next().unwrap_or_default().to_owned();
                wrong(format!(", line {}, column {}", error.line(), error.column()), text)
            })?
        } else {
            let document = toml::Deserializer::parse(source);
            document.and_then(Self::deserialize).map_err(|error| {
                let place = error.span().map(|span| line_and_column(source, span.start));
                wrong(place.unwrap_or_default(), error.message().to_owned())
            })?
        };
        match recipe.version {
            VERSION => Ok(recipe),
            other => Err(wrong(
                String::new(),
                format!("a stack file of version {other} is not known here, only version {VERSION}"),
            )),
        }
    }

    /// Returns the file as TOML; what has its default is left out.
    pub fn to_toml(&self) -> String {
        // Numbers, words and lists of them: there is nothing in a recipe that TOML could not hold.
        toml::to_string(self).unwrap_or_default()
    }

    /// Returns the file as JSON, indented; what has its default is left out.
    pub fn to_json(&self) -> String {
        serde_json::to_string_pretty(self).map(|text| text + "\n").unwrap_or_default()
    }
}

fn line_and_column(source: &str, offset: usize) -> String {
    let before = source.get(..offset).unwrap_or(source);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    format!(", line {}, column {}", before.matches('\n').count() + 1, before.len() - line_start + 1)
}
