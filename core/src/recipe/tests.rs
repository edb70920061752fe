use std::path::Path;
use std::sync::Arc;

use super::*;
use crate::combine::Span;
use crate::filter::FilterKind;
use crate::motion::Motion;
use crate::stack::{Entry, Source};
use crate::value::{Blend, FilterChannels};

const STACK: &str = r#"
skeleton = "human.asf"
rate_hz = 29.97

[[entries]]
kind = "TRACK"
name = "Wave"
source = "wave.amc"
bones = ["b", "a"]
cut_end = 55
scale_start = -3
blend_depth = 10
preserve = true
preserve_rotation = "FULL"
blend = "EULER"
sampling = "SMOOTH"

[[entries]]
kind = "FILTER"
enabled = false
filter_kind = "WEIGHTED"
depth = 7
filter_channels = "CHANNELS"
"#;

fn parse(text: &str) -> Result<Recipe, String> {
    Recipe::parse(text, Path::new("stack.toml")).map_err(|error| error.to_string())
}

fn refusal(text: &str) -> String {
    parse(text).unwrap_err()
}

#[test]
fn toml_and_json_say_the_same_there_and_back() {
    let recipe = parse(STACK).unwrap();
    assert_eq!(parse(&recipe.to_toml()).unwrap(), recipe);
    assert_eq!(parse(&recipe.to_json()).unwrap(), recipe);
    assert_eq!(recipe.rate_hz, 29.97);
    assert!(recipe.to_json().starts_with("{\n"));
    assert!(!recipe.to_toml().contains("preserve_height"), "{}", recipe.to_toml());
}

#[test]
fn an_entry_has_what_the_file_says_and_0_is_not_set() {
    let recipe = parse(STACK).unwrap();
    let source = Arc::new(Source::new(Motion::default()));
    let Entry::Track(track) = recipe.entries[0].to_entry(&["a", "b"], Some(source)).unwrap() else { panic!() };
    assert_eq!((track.label.as_str(), track.bones), ("Wave", Some(vec![1, 0])));
    assert_eq!(track.cut, Span { start: None, end: Some(55) });
    assert_eq!(track.scale, Span { start: Some(-3), end: None });
    assert_eq!((track.blend_depth, track.blend, track.rate_hz), (Some(10), Blend::Euler, None));
    assert!(track.preserve.is_some_and(|preserve| preserve.full_rotation && !preserve.height));

    let Entry::Filter(filter) = recipe.entries[1].to_entry(&["a"], None).unwrap() else { panic!() };
    assert_eq!((filter.kind, filter.depth.get(), filter.bones), (FilterKind::Weighted, 7, None));
    assert_eq!(filter.channels, FilterChannels::Each);
    assert!(!recipe.entries[1].enabled);
}

#[test]
fn mistakes_are_told_with_their_line() {
    let unknown = refusal("version = 1\n[[entries]]\nkind = \"TRACK\"\ncut = 3\n");
    assert!(unknown.starts_with("stack.toml, line 4, column 1: unknown field `cut`, expected one of"), "{unknown}");
    let kind = refusal("[[entries]]\nkind = \"KEPT\"\n");
    assert_eq!(kind, "stack.toml, line 2, column 8: unknown variant `KEPT`, expected `TRACK` or `FILTER`");
    let word = refusal("{\n \"rate_hz\": \"fast\"\n}");
    assert_eq!(word, "stack.toml, line 2, column 18: invalid type: string \"fast\", expected f64");
    assert_eq!(refusal("version = 2"), "stack.toml: a stack file of version 2 is not known here, only version 1");
    assert!(refusal("rate_hz = = 3").starts_with("stack.toml, line 1, column 11: "));
}

#[test]
fn entries_that_make_no_sense_are_refused_by_their_name() {
    let entry = |text: &str| {
        let recipe = parse(&format!("[[entries]]\n{text}")).unwrap();
        let source = Arc::new(Source::new(Motion::default()));
        recipe.entries[0].to_entry(&["hips", "knee"], Some(source)).unwrap_err().to_string()
    };
    assert_eq!(entry("name = \"Wave\"\nbones = [\"arm\"]"), "Wave: there is no bone `arm`: the bones are hips, knee");
    assert_eq!(
        entry("kind = \"FILTER\""),
        "a filter: `filter_kind` is missing: \"MEDIAN\", \"AVERAGE\" or \"WEIGHTED\""
    );
    assert_eq!(
        entry("kind = \"FILTER\"\nfilter_kind = \"MEDIAN\"\ndepth = 4"),
        "a filter: the depth of a filter is an odd number of at least 3, not 4"
    );
    assert_eq!(
        entry("source = \"a.amc\"\nscale_end = 9999999"),
        "a.amc: a scale frame lies between -1048574 and 1048574, not at 9999999"
    );
}
