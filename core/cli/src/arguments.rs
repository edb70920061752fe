//! What can be asked of the program.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use motion_theater_core::filter::FilterKind;
use motion_theater_core::read::Format;

use crate::library::LibraryOptions;

/// Motion capture: what is in it, other formats, poses, filters, stacks.
#[derive(Debug, Parser)]
#[command(name = "motion-theater", version, arg_required_else_help = true)]
pub struct Arguments {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Tell what is in files: frames, rate, names, and what was inferred
    Info(InfoOptions),
    /// Bring files into another format or to another rate
    Convert(ConvertOptions),
    /// Print where everything is at one frame
    Pose(PoseOptions),
    /// Filter the motion of one file
    Filter(FilterOptions),
    /// Evaluate a stack file: tracks and filters, one over the other
    Combine(CombineOptions),
    /// Keep a catalogue of all clips in folders
    Library(LibraryOptions),
}

#[derive(Debug, Args)]
pub struct InfoOptions {
    /// Motion files, or folders of them
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Print one JSON object per file, one per line
    #[arg(long)]
    pub json: bool,
    /// The skeleton of AMC files; without this it is looked for beside them
    #[arg(long, value_name = "ASF")]
    pub skeleton: Option<PathBuf>,
    #[command(flatten)]
    pub workers: Workers,
}

#[derive(Debug, Args)]
#[command(override_usage = "motion-theater convert [OPTIONS] <IN>... <OUT>")]
pub struct ConvertOptions {
    /// Motion files, or folders of them, and then where to: a file, or for several files a folder
    #[arg(required = true, num_args = 2.., value_names = ["IN", "OUT"])]
    pub paths: Vec<PathBuf>,
    /// The format to write; without this the extension of OUT says it
    #[arg(long, value_parser = format)]
    pub format: Option<Format>,
    /// Frames per second to resample to; without this every frame is kept
    #[arg(long, value_name = "HZ", value_parser = rate, allow_negative_numbers = true)]
    pub rate: Option<f64>,
    /// The skeleton of AMC files; without this it is looked for beside them
    #[arg(long, value_name = "ASF")]
    pub skeleton: Option<PathBuf>,
    /// Write outputs anew that are newer than their inputs
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub workers: Workers,
}

#[derive(Debug, Args)]
pub struct Workers {
    /// How many files are worked on at a time; without this, one per core
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
}

#[derive(Debug, Args)]
pub struct PoseOptions {
    /// A motion or skeleton file
    pub file: PathBuf,
    /// The skeleton of an AMC file; without this it is looked for beside it
    #[arg(long, value_name = "ASF")]
    pub skeleton: Option<PathBuf>,
    /// The frame, in the file's own numbers; without this the first
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub frame: Option<f64>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
pub struct FilterOptions {
    /// A motion file
    #[arg(value_name = "IN")]
    pub input: PathBuf,
    /// Where to; the extension says the format
    #[arg(value_name = "OUT")]
    pub output: PathBuf,
    /// Which value stands for its neighbours
    #[arg(long)]
    pub kind: Kind,
    /// How many values one result is made of: an odd number
    #[arg(long, value_name = "N")]
    pub depth: usize,
    /// Names of bones or markers, separated by commas; without this all
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub bones: Option<Vec<String>>,
    /// The skeleton of an AMC file; without this it is looked for beside it
    #[arg(long, value_name = "ASF")]
    pub skeleton: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub struct CombineOptions {
    /// A stack file: TOML or JSON
    #[arg(value_name = "STACK")]
    pub stack: PathBuf,
    /// Where to; the extension says the format
    #[arg(value_name = "OUT")]
    pub output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// The middle of the sorted values: removes spikes
    Median,
    /// The mean: removes noise and softens
    Average,
    /// The mean with weights from Pascal's triangle: softens less
    Weighted,
}

impl From<Kind> for FilterKind {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Median => Self::Median,
            Kind::Average => Self::Average,
            Kind::Weighted => Self::Weighted,
        }
    }
}

fn format(text: &str) -> Result<Format, String> {
    Format::from_extension(text).ok_or_else(|| format!("the formats are {}", Format::list()))
}

fn rate(text: &str) -> Result<f64, String> {
    let rate = text.parse().ok().filter(|rate: &f64| rate.is_finite() && *rate > 0.0);
    rate.ok_or_else(|| "a rate is a number of frames per second above 0".to_owned())
}
