//! What is inferred of every real file, and of copies that are scaled, turned and played at other rates: it may be unsure,
//! but where it is certain it is right. `cargo run --example inference_table` prints the table.

mod truths;

use truths::{folder, markers, rates, skeletons, sum, Counts, Tally};

/// How tall markers of people come out, in metres: they do not always reach from the floor to the top of the head.
const MARKERS_M: std::ops::RangeInclusive<f64> = 0.88..=2.2;

const NOTHING: [String; 0] = [];

/// People who stand along another axis than their files state.
const STATED_WRONG: [&str; 3] =
    ["c3d/c3dorg_13/Dance.c3d", "c3d/c3dorg_13/golfswing.c3d", "c3d/c3dorg_37/ART-Human_hands_real_no6dof.c3d"];

/// `enough` are units, axes up, facings and rates.
fn assert_right(tallies: &[Tally], enough: [usize; 4]) {
    let counts: [Counts; 4] =
        [sum(tallies, |t| &t.unit), sum(tallies, |t| &t.up), sum(tallies, |t| &t.facing), sum(tallies, |t| &t.rate)];
    for (counts, enough) in counts.iter().zip(enough) {
        assert_eq!(counts.faults, NOTHING);
        // Nobody is helped by a reader that is never certain.
        assert!(counts.right >= enough, "{} of {enough}", counts.right);
    }
}

fn assert_people(tallies: &[Tally]) {
    for tally in tallies {
        assert_eq!(tally.outside(), 0, "{}: {:?}", tally.file, tally.heights_m);
    }
}

#[test]
fn certain_answers_about_bvh_files_and_their_copies_are_right() {
    let Some(folder) = folder() else { return };
    let tallies = skeletons::bvh_copies(&folder);
    assert_right(&tallies, [260, 560, 460, 234]);
    assert_people(&tallies);
}

#[test]
fn certain_answers_about_acclaim_files_and_their_copies_are_right() {
    let Some(folder) = folder() else { return };
    let tallies = skeletons::acclaim_copies(&folder);
    assert_right(&tallies, [18, 90, 90, 30]);
    assert_people(&tallies);
}

#[test]
fn certain_answers_about_markers_of_which_nothing_is_stated_are_right() {
    let Some(folder) = folder() else { return };
    let tallies = markers::silent_copies(&folder);
    assert_right(&tallies, [250, 780, 600, 972]);
    for tally in tallies {
        assert!(tally.heights_m.iter().all(|m| MARKERS_M.contains(m)), "{}: {:?}", tally.file, tally.heights_m);
    }
}

#[test]
fn markers_that_certainly_face_an_axis_do() {
    let Some(folder) = folder() else { return };
    let counts = markers::facing_as_read(&folder);
    assert_eq!(counts.faults, NOTHING);
    assert!(counts.right >= 36, "{}", counts.right);
}

#[test]
fn people_have_their_size_and_stand_up() {
    let Some(folder) = folder() else { return };
    for file in markers::PEOPLE {
        let (found, (_, unit_m, up, _)) = (markers::read(&folder, file), markers::truth(file));
        assert!(found.unit.is_certain && Some(found.unit.metres) == unit_m, "{file}: {}", found.unit.reason);
        assert!(found.up.is_certain && Some(found.up.axis) == up, "{file}: {}", found.up.reason);
    }
}

#[test]
fn an_axis_that_the_people_contradict_is_not_believed() {
    let Some(folder) = folder() else { return };
    for file in STATED_WRONG {
        let (found, (_, _, up, _)) = (markers::read(&folder, file), markers::truth(file));
        assert_eq!((Some(found.up.axis), found.up.is_certain), (up, false), "{file}: {}", found.up.reason);
    }
}

#[test]
fn what_is_certain_of_people_about_whom_a_file_lies_is_right() {
    let Some(folder) = folder() else { return };
    for tallies in [markers::lying_copies(&folder), markers::csm_copies(&folder)] {
        let counts = [sum(&tallies, |tally| &tally.unit), sum(&tallies, |tally| &tally.up)];
        let [unit, up] = counts.each_ref().map(|counts| (counts.right, counts.right + counts.unsure));
        let facing = sum(&tallies, |tally| &tally.facing);
        for counts in counts.iter().chain([&facing]) {
            assert_eq!(counts.faults, NOTHING);
        }
        // Scaled copies state a wrong unit, and some cannot be known.
        assert!(unit.0 * 9 >= unit.1 && up.0 * 3 >= up.1 && facing.right > 0, "{unit:?} {up:?} {facing:?}");
    }
}

#[test]
fn certain_rates_are_right_whatever_the_rounding() {
    let counts = rates::rounded_frame_times();
    assert_eq!(counts.faults, NOTHING);
    assert!(counts.right > 80, "{}", counts.right);
}
