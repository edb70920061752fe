//! What is inferred of every real file, and of copies that are scaled, turned and played at other rates: it may be unsure,
//! but where it is certain it is right. `cargo run --example inference_table` prints the table.

mod truths;

use truths::{folder, markers, rates, skeletons, sum, Counts, Tally};

/// Between which heights a person comes out, in metres, from the lowest joint to the highest.
const PERSON_M: std::ops::RangeInclusive<f64> = 1.0..=2.2;

const NOTHING: [String; 0] = [];

/// People who stand along another axis than their files state.
const STATED_WRONG: [&str; 3] =
    ["c3d/c3dorg_13/Dance.c3d", "c3d/c3dorg_13/golfswing.c3d", "c3d/c3dorg_37/ART-Human_hands_real_no6dof.c3d"];

fn assert_right(tallies: &[Tally], enough: [usize; 3]) {
    let counts: [Counts; 3] = [sum(tallies, |t| &t.unit), sum(tallies, |t| &t.up), sum(tallies, |t| &t.facing)];
    for (counts, enough) in counts.iter().zip(enough) {
        assert_eq!(counts.faults, NOTHING);
        // Nobody is helped by a reader that is never certain.
        assert!(counts.right >= enough, "{} of {enough}", counts.right);
    }
    for tally in tallies {
        assert!(
            tally.heights_m.iter().all(|height| PERSON_M.contains(height)),
            "{}: {:?}",
            tally.file,
            tally.heights_m
        );
    }
}

#[test]
fn certain_answers_about_bvh_files_and_their_copies_are_right() {
    let Some(folder) = folder() else { return };
    assert_right(&skeletons::bvh_copies(&folder), [150, 500, 400]);
}

#[test]
fn certain_answers_about_acclaim_files_and_their_copies_are_right() {
    let Some(folder) = folder() else { return };
    assert_right(&skeletons::acclaim_copies(&folder), [5, 24, 20]);
}

#[test]
fn certain_answers_about_markers_of_which_nothing_is_stated_are_right() {
    let Some(folder) = folder() else { return };
    assert_right(&markers::silent_copies(&folder), [200, 700, 0]);
}

#[test]
fn people_have_their_size_and_stand_up() {
    let Some(folder) = folder() else { return };
    for file in markers::PEOPLE {
        let (found, (_, unit_m, up)) = (markers::read(&folder, file), markers::truth(file));
        assert!(found.unit.is_certain && Some(found.unit.metres) == unit_m, "{file}: {}", found.unit.reason);
        assert!(found.up.is_certain && Some(found.up.axis) == up, "{file}: {}", found.up.reason);
    }
}

#[test]
fn an_axis_that_the_people_contradict_is_not_believed() {
    let Some(folder) = folder() else { return };
    for file in STATED_WRONG {
        let (found, (.., up)) = (markers::read(&folder, file), markers::truth(file));
        assert_eq!((Some(found.up.axis), found.up.is_certain), (up, false), "{file}: {}", found.up.reason);
    }
}

#[test]
fn what_is_certain_of_people_about_whom_a_file_lies_is_right() {
    let Some(folder) = folder() else { return };
    let tallies = markers::lying_copies(&folder);
    let (unit, up) = (sum(&tallies, |tally| &tally.unit), sum(&tallies, |tally| &tally.up));
    assert_eq!([unit.faults, up.faults].concat(), NOTHING);
    // Scaled copies state a wrong unit, and some cannot be known.
    assert!(unit.right * 6 >= unit.right + unit.unsure && up.right * 3 >= up.right + up.unsure);
}

#[test]
fn certain_rates_are_right_whatever_the_rounding() {
    let counts = rates::rounded_frame_times();
    assert_eq!(counts.faults, NOTHING);
    assert!(counts.right > 80, "{}", counts.right);
}
