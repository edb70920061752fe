//! What a sidecar keeps, finds and changes.

use proptest::prelude::*;

use super::*;

fn values(sidecar: &Sidecar) -> Vec<&str> {
    Field::ALL.into_iter().map(|field| sidecar.get(field).unwrap_or("-")).collect()
}

fn text_of(sidecar: &Sidecar) -> String {
    String::from_utf8(sidecar.to_bytes()).unwrap()
}

#[test]
fn an_empty_one_has_the_eleven_lines() {
    let sidecar = Sidecar::default();
    assert_eq!(
        text_of(&sidecar),
        "Date:\nGroup:\nSubject:\nDuration:\nFramerate:\nCleaned:\nLast changed on:\nModified by:\nUsable segments:\n\
         ASF file:\nComment:\n"
    );
    assert_eq!(values(&sidecar), [""; 11]);
}

#[test]
fn other_labels_another_order_and_missing_lines_are_understood() {
    let by_hand = "\u{FEFF}Akteur: Jo\r\n\r\nWeather: rain\r\nFrame rate :120\r\nDate of last change: 1.6.2004\r\n\
                   Comment: starts at 10:30, ends: never\r\nno colon here\r\nASF-Datei: C:\\takes\\07.asf";
    let sidecar = Sidecar::parse(by_hand.as_bytes());
    let wanted =
        ["-", "-", "Jo", "-", "120", "-", "1.6.2004", "-", "-", "C:\\takes\\07.asf", "starts at 10:30, ends: never"];
    assert_eq!(values(&sidecar), wanted);
    assert_eq!(sidecar.unknown().collect::<Vec<_>>(), ["Weather: rain", "no colon here"]);
    assert_eq!(text_of(&sidecar), by_hand);
}

#[test]
fn eleven_lines_in_the_usual_order_need_no_label_that_is_known() {
    let labels =
        ["Tag", "Reihe", "Wer", "Wie lang", "Framerate", "Sauber", "x y z", "Wer war es", "Gut", "Gestell", "Sonst"];
    let text: String = labels.iter().enumerate().map(|(index, label)| format!("{label}: {index}\n")).collect();
    let sidecar = Sidecar::parse(text.as_bytes());
    assert_eq!(values(&sidecar), ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10"]);
    // A known label in the place of another field shows that the order is not the usual one.
    let swapped = text.replace("Framerate", "Tempo").replace("Tag", "Framerate");
    assert_eq!(values(&Sidecar::parse(swapped.as_bytes())), ["-", "-", "-", "-", "0", "-", "-", "-", "-", "-", "-"]);
}

#[test]
fn of_two_lines_that_mean_a_field_the_clearer_one_is_it() {
    let sidecar = Sidecar::parse(b"Note: see page 7\nKommentar: gut\nComment: good\nComment: twice\n");
    assert_eq!(sidecar.get(Field::Comment), Some("good"));
    assert_eq!(sidecar.unknown().collect::<Vec<_>>(), ["Note: see page 7", "Kommentar: gut", "Comment: twice"]);
}

#[test]
fn an_edit_changes_its_own_line_and_no_other_byte() {
    let before = "Note to self\r\nSubject:  07\r\nGroup : old\r\nsubject: a second one\r\n";
    let mut sidecar = Sidecar::parse(before.as_bytes());
    sidecar.set(Field::Subject, "08").unwrap();
    assert_eq!(text_of(&sidecar), before.replace("  07", "  08"));
    sidecar.set(Field::Subject, " 07 ").unwrap();
    assert_eq!(text_of(&sidecar), before);
}

#[test]
fn a_missing_line_is_put_where_it_stands_in_order_and_ends_as_the_others_do() {
    let mut sidecar = Sidecar::parse(b"Subject: 07\r\n# mine\r\nComment: x");
    sidecar.set(Field::Duration, "2.5").unwrap();
    sidecar.set(Field::Date, "2004-05-31").unwrap();
    sidecar.set(Field::AsfFile, "07.asf").unwrap();
    sidecar.set(Field::Cleaned, "").unwrap();
    let wanted = "Date: 2004-05-31\r\nSubject: 07\r\nDuration: 2.5\r\nASF file: 07.asf\r\n# mine\r\nComment: x";
    assert_eq!(text_of(&sidecar), wanted);
    let mut empty = Sidecar::parse(b"no label");
    empty.set(Field::Comment, "new").unwrap();
    assert_eq!(text_of(&empty), "no label\nComment: new\n");
}

#[test]
fn latin_1_stays_latin_1_as_long_as_it_can_say_everything() {
    let mut sidecar = Sidecar::parse(b"Subject: J\xF6rg\nComment: gr\xFC\xDFt\n");
    assert_eq!(sidecar.get(Field::Subject), Some("Jörg"));
    sidecar.set(Field::Subject, "Käthe").unwrap();
    assert_eq!(sidecar.to_bytes(), b"Subject: K\xE4the\nComment: gr\xFC\xDFt\n");
    sidecar.set(Field::Comment, "grüßt für 5 €").unwrap();
    assert_eq!(text_of(&sidecar), "Subject: Käthe\nComment: grüßt für 5 €\n");
}

#[test]
fn what_a_field_cannot_hold_is_refused_and_changes_nothing() {
    let mut sidecar = Sidecar::default();
    let before = sidecar.clone();
    assert!(sidecar.set(Field::Cleaned, "maybe").is_err());
    assert_eq!(sidecar.set(Field::Comment, "a\nb").unwrap_err().to_string(), "Comment is one line of text");
    assert_eq!(sidecar, before);
    // What somebody wrote by hand is told of, and kept.
    let by_hand = Sidecar::parse(b"Cleaned: perhaps\n");
    assert_eq!(by_hand.get(Field::Cleaned), Some("perhaps"));
    assert_eq!(by_hand.faults(), ["Cleaned is empty or one of J, Ja, Y, Yes, N, Nein, No, not “perhaps”"]);
}

/// Bytes of which many look like a sidecar.
fn some_bytes() -> impl Strategy<Value = Vec<u8>> {
    let part = prop_oneof![
        proptest::collection::vec(any::<u8>(), 0..12),
        proptest::sample::select(vec![
            "Date: ",
            "Cleaned:",
            "asf file :x",
            "Comment: a:b",
            "\r\n",
            "\n",
            "\r",
            "\u{FEFF}",
            "ü",
            ":",
            "\u{0}",
        ])
        .prop_map(|text| text.as_bytes().to_vec()),
        Just(vec![0xFF, 0xFE]),
        Just(vec![0xFE, 0xFF]),
        Just(vec![0xEF, 0xBB, 0xBF]),
    ];
    proptest::collection::vec(part, 0..24).prop_map(|parts| parts.concat())
}

proptest! {
    #[test]
    fn any_bytes_that_nobody_edits_stay_what_they_are(bytes in some_bytes()) {
        prop_assert_eq!(Sidecar::parse(&bytes).to_bytes(), bytes);
    }

    #[test]
    fn an_edit_of_anything_is_found_again_and_loses_no_other_value(
        bytes in some_bytes(),
        field in proptest::sample::select(Field::ALL.to_vec()),
        value in "[ -~äöü€:]{0,12}",
    ) {
        let before = Sidecar::parse(&bytes);
        let mut sidecar = before.clone();
        prop_assume!(sidecar.set(field, &value).is_ok());
        let again = Sidecar::parse(&sidecar.to_bytes());
        prop_assert_eq!(again.get(field).unwrap_or_default(), value.trim());
        for other in Field::ALL.into_iter().filter(|other| *other != field) {
            if let Some(kept) = before.get(other) {
                prop_assert_eq!(again.get(other), Some(kept));
            }
        }
    }
}
