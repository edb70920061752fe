//! What can be asked of a library.

use std::path::PathBuf;

use clap::{Args, Subcommand};
use motion_theater_library::query::Sort;
use motion_theater_library::sidecar::Field;

use crate::arguments::Workers;

#[derive(Debug, Args)]
pub struct LibraryOptions {
    /// The library's file; without this the variable `MOTION_THEATER_LIBRARY` names it
    #[arg(long, value_name = "FILE", global = true)]
    pub library: Option<PathBuf>,
    #[command(subcommand)]
    pub command: LibraryCommand,
}

#[derive(Debug, Subcommand)]
pub enum LibraryCommand {
    /// Look for clips that are new, changed, moved or gone
    Scan(ScanOptions),
    /// Find clips by what is known of them
    Search(SearchOptions),
    /// Print everything that is known of clips
    Show(ShowOptions),
    /// Put tags on clips, and take others off
    Tag(TagOptions),
    /// Print the sidecars of clips, write what the library knows into them, or edit their lines
    Sidecar(SidecarOptions),
    /// Print a table of all clips
    Export(ExportOptions),
}

#[derive(Debug, Args)]
pub struct ScanOptions {
    /// Folders; new ones are added to the library. Without this all of the library's
    #[arg(value_name = "FOLDER")]
    pub folders: Vec<PathBuf>,
    /// Do not draw previews, for which every number is read
    #[arg(long)]
    pub no_previews: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub workers: Workers,
}

#[derive(Debug, Args)]
pub struct SearchOptions {
    /// Words and terms: subject:07 walk 'rate>=100' -tag:done; without them all clips. What begins with a minus
    /// comes after --
    #[arg(value_name = "QUERY")]
    pub query: Vec<String>,
    /// What clips are ordered by: name, path, date, modified, duration, rate, frames, size, rating, used or relevance
    #[arg(long, default_value = "name", value_parser = sort)]
    pub sort: Sort,
    /// Begin with the greatest
    #[arg(long)]
    pub descending: bool,
    /// How many clips at most
    #[arg(long, value_name = "N")]
    pub limit: Option<usize>,
    /// Print one JSON object per clip, one per line
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct ShowOptions {
    /// Clips by their files or numbers
    #[arg(required = true, value_name = "CLIP")]
    pub clips: Vec<String>,
    /// Print one JSON object per clip, one per line
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct TagOptions {
    /// Clips by their files or numbers
    #[arg(required = true, value_name = "CLIP")]
    pub clips: Vec<String>,
    /// Tags to put on, separated by commas
    #[arg(long, value_delimiter = ',', value_name = "TAGS")]
    pub add: Vec<String>,
    /// Tags to take off, separated by commas
    #[arg(long, value_delimiter = ',', value_name = "TAGS")]
    pub remove: Vec<String>,
}

#[derive(Debug, Args)]
pub struct SidecarOptions {
    /// Clips by their files or numbers
    #[arg(required = true, value_name = "CLIP")]
    pub clips: Vec<String>,
    /// Write what the library knows of the clips into their sidecars; one that is not there is made
    #[arg(long)]
    pub write: bool,
    /// Write a value into a line: --set subject=07; may be given several times
    #[arg(long, value_name = "LINE=VALUE", value_parser = line_and_value)]
    pub set: Vec<(Field, String)>,
    /// Print one JSON object per sidecar, one per line
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct ExportOptions {
    /// Print one JSON object per clip, one per line, instead of a table of values separated by commas
    #[arg(long)]
    pub json: bool,
}

/// Reads `subject=07`: a line by its name or its label.
fn line_and_value(text: &str) -> Result<(Field, String), String> {
    let (name, value) = text.split_once('=').ok_or("a line, an equals sign and a value, such as subject=07")?;
    let field = Field::of_name(name).or_else(|| Field::of_label(name));
    let field = field.ok_or_else(|| format!("the lines are {}", Field::ALL.map(Field::name).join(", ")))?;
    Ok((field, value.to_owned()))
}

fn sort(text: &str) -> Result<Sort, String> {
    Sort::named(text).ok_or_else(|| format!("the orders are {}", Sort::list()))
}
