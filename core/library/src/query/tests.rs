//! Searches in a database give what going through all clips gives.

use proptest::prelude::*;
use proptest::sample::select;
use rusqlite::params;

use super::plain::{self, PlainClip};
use super::{Order, Query, Sort};
use crate::catalogue::{now, Library};

/// Words that are alike, in letters that fold, join and divide in every way.
const WORDS: [&str; 28] = [
    "walk",
    "Walk",
    "walking",
    "WALK",
    "wal",
    "run",
    "run-walk",
    "wälk",
    "wa\u{308}lk",
    "Ärm",
    "arm",
    "02_01",
    "02",
    "2",
    "2a",
    "日本",
    "日",
    "ﬁn",
    "İz",
    "ẞ",
    "straße",
    "it's",
    "x\u{345}y",
    "½",
    "a\"b",
    "\u{1F600}",
    "no",
    "İ\u{307}\u{E000}w",
];
const SUBJECTS: [&str; 9] = ["07", "7", "Anna", "anna", "Änna", "Anna Smith", "", "none", "070"];
const RATES: [f64; 9] = [24.0, 29.97, 30.0003, 59.94, 60.0, 100.0, 119.88, 120.0, 120.0048];
const TIMES: [f64; 8] = [0.0, 1.0, 9.5, 10.0, 10.49, 59.999, 60.0, 3600.0];
const DATES: [&str; 6] = ["2003-12-31", "2004-01-01", "2004-05-17", "2004-06-01", "2005", "2004-05"];
const FINGERPRINTS: [&str; 3] = ["ab12", "AB99", "ab"];
const SKELETONS: [&str; 4] = ["/clips/07.asf", "/other/7.asf", "/clips/Ärm.ASF", ""];

/// Queries as people write them; the same list is measured and tried on real clips, see `tests/library/queries.txt`.
const QUERIES: &str = include_str!("../../../../tests/library/queries.txt");

fn text() -> impl Strategy<Value = String> {
    prop::collection::vec(select(&WORDS[..]), 0..4).prop_map(|words| words.join(" "))
}

prop_compose! {
    fn texts()(
        name in text(), folder in text(), description in prop::option::of(text()),
        subject in prop::option::of(select(&SUBJECTS[..])), group in prop::option::of(select(&SUBJECTS[..])),
        tags in prop::collection::btree_set(select(&WORDS[..]), 0..3),
        skeleton_fingerprint in prop::option::of(select(&FINGERPRINTS[..])),
        skeleton_path in prop::option::of(select(&SKELETONS[..])),
        format in select(vec!["amc", "bvh", "c3d"]), recorded_on in prop::option::of(select(&DATES[..])),
        error in prop::option::weighted(0.2, Just("broken".to_owned())),
    ) -> PlainClip {
        let owned = |text: Option<&str>| text.map(str::to_owned);
        PlainClip {
            name, folder, description, subject: owned(subject), group: owned(group),
            tags: tags.into_iter().map(str::to_owned).collect(),
            skeleton_fingerprint: owned(skeleton_fingerprint), skeleton_path: owned(skeleton_path),
            format: format.to_owned(), recorded_on: owned(recorded_on), error, ..PlainClip::default()
        }
    }
}

prop_compose! {
    fn clip()(
        clip in texts(), rate_hz in prop::option::of(select(&RATES[..])), duration_s in prop::option::of(select(&TIMES[..])),
        height_m in prop::option::of(select(&[1.5, 1.795, 1.8, 1.805][..])), frames in prop::option::of(0..3_i64),
        joints in prop::option::of(30..32_i64), markers in prop::option::of(30..32_i64), size in 999_999..1_000_002_i64,
        modified_ns in (1_i64 << 60)..(1 << 60) + 3, used_at in used_at(), rating in 0..6_i64,
        cleaned in any::<Option<bool>>(), is_missing: bool, is_favourite: bool,
    ) -> PlainClip {
        PlainClip {
            rate_hz, duration_s, height_m, frames, joints, markers, size, modified_ns, used_at, rating, cleaned, is_missing,
            is_favourite, ..clip
        }
    }
}

/// Long ago, or half an hour short of some days: a test takes less than that.
fn used_at() -> impl Strategy<Value = Option<i64>> {
    let lately = (0..20_i64).prop_map(|days| now() - days * 86_400 + 1_800);
    prop::option::of(prop_oneof![0..3_i64, lately])
}

fn clips() -> impl Strategy<Value = Vec<PlainClip>> {
    prop::collection::vec(clip(), 0..20).prop_map(|clips| {
        let placed = |(index, clip): (usize, PlainClip)| PlainClip {
            id: index as i64 * 40_000 + 1,
            path: format!("/clips/{}/{}", index * 7 % 10, index),
            tags: without_doubles(clip.tags),
            ..clip
        };
        clips.into_iter().enumerate().map(placed).collect()
    })
}

/// Tags are the same in either case.
fn without_doubles(mut tags: Vec<String>) -> Vec<String> {
    tags.sort_by_key(|tag| tag.to_ascii_lowercase());
    tags.dedup_by(|a, b| a.eq_ignore_ascii_case(b));
    tags
}

/// One term, as text.
fn term() -> impl Strategy<Value = String> {
    let of = |values: &[&str]| select(values.iter().map(|value| (*value).to_owned()).collect::<Vec<_>>());
    let comparison = of(&[":", "=", "<", "<=", ">", ">="]);
    let number = prop_oneof![of(&[
        "rate", "rate", "duration", "duration", "frames", "height", "rating", "size", "joints", "markers"
    ]),];
    let value = of(&[
        "0", "1", "2", "10", "10.0", "24", "30", "29.97", "31", "60", "100", "120", "1.8", "1.80", "1mb", "1000kb",
        "1:00",
    ]);
    let quote = |value: &str| format!("\"{}\"", value.replace('"', "\"\""));
    let words = prop_oneof![
        3 => select(&WORDS[..]).prop_map(str::to_owned),
        1 => text().prop_map(move |text| quote(&text)),
    ];
    let whole = prop_oneof![
        of(&SUBJECTS),
        of(&SUBJECTS).prop_map(move |text| quote(&text)),
        of(&["0*", "a*", "*", "none", "ab12", "AB*", "07.asf", "arm", "walk", "run-walk"]),
    ];
    prop_oneof![
        4 => words.clone(),
        2 => (of(&["name:", "folder:", "description:"]), words).prop_map(|(field, words)| field + &words),
        3 => (of(&["subject:", "group:", "tag:", "skeleton:"]), whole).prop_map(|(field, value)| field + &value),
        4 => (number, comparison.clone(), value.clone()).prop_map(|(field, operator, value)| field + &operator + &value),
        1 => (value.clone(), value).prop_map(|(from, to)| format!("duration:{from}..{to}")),
        2 => (comparison, of(&["2004", "2004-05", "2004-05-17", "2004..2005", "..2004", "none"]))
            .prop_map(|(operator, date)| format!("date{operator}{date}")),
        2 => of(&[
            "cleaned:yes", "cleaned:no", "cleaned:unknown", "missing:yes", "broken:yes", "broken:no", "favourite:yes",
            "format:bvh", "rate:none", "frames:none", "description:none", "tag:none", "used:yes", "used:no", "used:none",
            "used:12h", "used:7d", "used:2w", "used:2000w",
        ]),
    ]
}

fn query() -> impl Strategy<Value = String> {
    prop::collection::vec((prop::bool::weighted(0.3), term()), 0..4).prop_map(|terms| {
        terms
            .iter()
            .map(|(is_negated, term)| if *is_negated { format!("-{term} ") } else { format!("{term} ") })
            .collect()
    })
}

fn library_of(clips: &[PlainClip]) -> (tempfile::TempDir, Library) {
    let folder = tempfile::tempdir().expect("a folder for the test");
    let library = Library::open(&folder.path().join("clips.sqlite")).expect("a library");
    let put = |db: &rusqlite::Transaction<'_>| {
        db.execute("INSERT INTO folder (id, path, added_at) VALUES (1, '/clips', 0)", ())?;
        for clip in clips {
            db.execute(
                "INSERT INTO clip (id, folder_id, path, name, folder, size, modified_ns, format, frames, rate_hz, duration_s,
                    joints, markers, skeleton_fingerprint, height_m, skeleton_path, facts_at, facts_by)
                 VALUES (?, 1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, 0, 0)",
                params![
                    clip.id, clip.path, clip.name, clip.folder, clip.size, clip.modified_ns, clip.format, clip.frames,
                    clip.rate_hz, clip.duration_s, clip.joints, clip.markers, clip.skeleton_fingerprint, clip.height_m,
                    clip.skeleton_path
                ],
            )?;
            for tag in &clip.tags {
                db.execute("INSERT INTO tag (name) VALUES (?) ON CONFLICT DO NOTHING", [tag])?;
                db.execute("INSERT INTO clip_tag SELECT ?, id FROM tag WHERE name = ?", params![clip.id, tag])?;
            }
            db.execute(
                "UPDATE clip SET subject = ?, description = ?, session_group = ?, recorded_on = ?, cleaned = ?, rating = ?,
                    is_favourite = ?, is_missing = ?, used_at = ?, error = ? WHERE id = ?",
                params![
                    clip.subject, clip.description, clip.group, clip.recorded_on, clip.cleaned, clip.rating,
                    clip.is_favourite, clip.is_missing, clip.used_at, clip.error, clip.id
                ],
            )?;
        }
        Ok(())
    };
    library.write(put).expect("clips in the library");
    (folder, library)
}

fn sorts() -> impl Strategy<Value = Order> {
    let sorts = Sort::list().split(", ").filter_map(Sort::named).collect::<Vec<_>>();
    (select(sorts), any::<bool>()).prop_map(|(sort, is_descending)| Order { sort, is_descending })
}

/// Tags as the first that used them spelled them, which is how the library keeps them.
fn spelled_alike(clips: &[PlainClip]) -> Vec<PlainClip> {
    let mut known: Vec<String> = Vec::new();
    let mut clips = clips.to_vec();
    for tag in clips.iter_mut().flat_map(|clip| &mut clip.tags) {
        match known.iter().find(|known| known.eq_ignore_ascii_case(tag)) {
            Some(known) => tag.clone_from(known),
            None => known.push(tag.clone()),
        }
    }
    clips
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_search_gives_what_a_plain_filter_gives(
        clips in clips(), queries in prop::collection::vec((query(), sorts()), 12),
    ) {
        let (_folder, library) = library_of(&clips);
        let clips = spelled_alike(&clips);
        for (text, order) in queries {
            let Ok(query) = Query::parse(&text) else { continue };
            let found = library.search(&query, order).expect("an answer");
            prop_assert_eq!(found, plain::search(&clips, &query, order), "{} {:?}", text, order);
        }
    }

    #[test]
    fn written_queries_give_what_a_plain_filter_gives(clips in clips(), order in sorts()) {
        let (_folder, library) = library_of(&clips);
        let clips = spelled_alike(&clips);
        for text in QUERIES.lines() {
            let query = Query::parse(text).expect("a query as people write it");
            let found = library.search(&query, order).expect("an answer");
            prop_assert_eq!(found, plain::search(&clips, &query, order), "{} {:?}", text, order);
        }
    }
}

#[test]
fn a_minus_gives_exactly_the_other_clips() {
    let unknown = PlainClip { id: 1, path: "/a".to_owned(), ..PlainClip::default() };
    let fast = PlainClip { id: 2, path: "/b".to_owned(), rate_hz: Some(120.0), ..PlainClip::default() };
    let (_folder, library) = library_of(&[unknown, fast]);
    let search = |text: &str| library.search(&Query::parse(text).unwrap(), Order::default()).unwrap();
    assert_eq!(search("rate>=100"), [2]);
    assert_eq!(search("rate<100"), [0; 0]);
    assert_eq!(search("-rate>=100"), [1]);
    assert_eq!(search("-rate<100"), [1, 2]);
    assert_eq!(search("rate:none"), [1]);
}

#[test]
fn as_many_terms_as_a_query_may_have_are_answered() {
    let clip = PlainClip { id: 1, path: "/a".to_owned(), name: "walk run".to_owned(), ..PlainClip::default() };
    let (_folder, library) = library_of(&[clip]);
    let search = |text: String| library.search(&Query::parse(&text).unwrap(), Order::default()).unwrap();
    assert_eq!(search("walk ".repeat(100)), [1]);
    assert_eq!(search("walk run -jump -subject:7 -rate>5 ".repeat(20)), [1]);
    assert_eq!(search("a.".repeat(5000)), [0; 0]);
}

#[test]
fn every_example_of_the_document_is_understood() {
    let page = include_str!("../../../../docs/library.md");
    let section = page.split("\n## ").find(|section| section.starts_with("Searching")).expect("a section");
    let firsts = section.lines().filter_map(|line| line.strip_prefix("| `")?.split(" | ").next());
    let examples: Vec<&str> = firsts.flat_map(|cell| cell.trim_end_matches('`').split("` `")).collect();
    assert!(examples.len() > 30, "{examples:?}");
    for example in examples {
        Query::parse(example).expect(example);
    }
}
