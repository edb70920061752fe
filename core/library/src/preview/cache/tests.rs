use super::*;

fn hash(number: u8) -> ContentHash {
    [number; 32]
}

fn preview(bytes: usize) -> Preview {
    let strip = vec![7; bytes];
    let (still, frame) = (vec![1, 2, 3], 42);
    Preview { frame, width: 8, height: 9, still, strip, strip_frames: 5, strip_rate_hz: 12.5 }
}

fn set_used_at(cache: &PreviewCache, number: u8, used_at: i64) {
    let sql = "UPDATE preview SET used_at = ? WHERE content_hash = ?";
    cache.with_connection(|db| Ok(db.execute(sql, (used_at, hash(number)))?)).unwrap();
}

#[test]
fn what_is_put_is_got_by_the_content_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let cache = PreviewCache::beside(&folder.path().join("clips.sqlite")).unwrap();
    cache.put(&hash(1), &preview(10)).unwrap();
    assert!(folder.path().join("clips-previews.sqlite").is_file());
    assert_eq!(cache.get(&hash(1)).unwrap(), Some(preview(10)));
    assert_eq!(cache.still(&hash(1)).unwrap(), Some(vec![1, 2, 3]));
    assert_eq!(cache.get(&hash(2)).unwrap(), None);
    assert_eq!(cache.missing(&[hash(1), hash(2)]).unwrap(), [hash(2)]);
}

#[test]
fn what_was_not_used_for_longest_goes_first() {
    let folder = tempfile::tempdir().unwrap();
    let cache = PreviewCache::open(&folder.path().join("p.sqlite"), 4000).unwrap();
    for number in 1..=4 {
        cache.put(&hash(number), &preview(997)).unwrap();
        set_used_at(&cache, number, i64::from(number));
    }
    // The first is looked at, and counts as used now.
    assert!(cache.get(&hash(1)).unwrap().is_some());
    cache.put(&hash(5), &preview(1997)).unwrap();
    let missing = cache.missing(&[1, 2, 3, 4, 5].map(hash)).unwrap();
    assert_eq!(missing, [hash(2), hash(3)]);
}

#[test]
fn previews_of_another_version_are_none_and_go_before_all_others() {
    let folder = tempfile::tempdir().unwrap();
    let cache = PreviewCache::open(&folder.path().join("p.sqlite"), 2000).unwrap();
    cache.put(&hash(1), &preview(997)).unwrap();
    cache.put(&hash(2), &preview(997)).unwrap();
    let sql = "UPDATE preview SET made_by = made_by + 1 WHERE content_hash = ?";
    cache.with_connection(|db| Ok(db.execute(sql, [hash(2)])?)).unwrap();
    assert_eq!(cache.still(&hash(2)).unwrap(), None);
    cache.put(&hash(3), &preview(997)).unwrap();
    let count = |db: &mut Connection| Ok(db.query_row("SELECT count(*) FROM preview", (), |row| row.get(0))?);
    assert_eq!(cache.with_connection::<i64>(count).unwrap(), 2);
    assert_eq!(cache.missing(&[hash(1), hash(3)]).unwrap(), [] as [ContentHash; 0]);
}

#[test]
fn a_cache_that_turns_out_to_be_damaged_is_empty_the_next_time() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.sqlite");
    let cache = PreviewCache::open(&path, MOST_BYTES).unwrap();
    cache.put(&hash(1), &preview(50_000)).unwrap();
    drop(cache);
    let mut bytes = std::fs::read(&path).unwrap();
    bytes[4096..].fill(0xAA);
    std::fs::write(&path, bytes).unwrap();
    let cache = PreviewCache::open(&path, MOST_BYTES).unwrap();
    assert!(matches!(cache.get(&hash(1)), Err(LibraryError::Damaged(_))));
    assert_eq!(cache.get(&hash(1)).unwrap(), None);
    cache.put(&hash(1), &preview(5)).unwrap();
    assert_eq!(cache.get(&hash(1)).unwrap(), Some(preview(5)));
}

#[test]
fn a_damaged_cache_is_made_anew_and_a_foreign_file_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.sqlite");
    PreviewCache::open(&path, MOST_BYTES).unwrap().put(&hash(1), &preview(5000)).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    bytes[100..4096].fill(0xAA);
    std::fs::write(&path, bytes).unwrap();
    let cache = PreviewCache::open(&path, MOST_BYTES).unwrap();
    assert_eq!(cache.missing(&[hash(1)]).unwrap(), [hash(1)]);
    cache.put(&hash(1), &preview(5)).unwrap();
    let foreign = folder.path().join("text.sqlite");
    std::fs::write(&foreign, "somebody's notes, which are long enough to be taken for a header of a database file")
        .unwrap();
    assert!(matches!(PreviewCache::open(&foreign, MOST_BYTES), Err(LibraryError::NotALibrary { .. })));
    assert!(std::fs::read_to_string(&foreign).unwrap().starts_with("somebody's notes"));
}
