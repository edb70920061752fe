//! Rules of the format, a line or two each, and the messages for files that break them.

use super::*;
use crate::error::Position;
use crate::read::Format;
use glam::DVec3;

const SMALL: &str = ":version 1.10\n:name small\n:units\n mass 1\n length 0.45\n angle deg\n:documentation\n  two bones\n\
    :root\n order TX TY TZ RX RY RZ\n axis XYZ\n position 0 1 0\n orientation 0 0 0\n:bonedata\n begin\n  id 1\n  name thigh\n\
    direction 0 -1 0\n  length 7\n  axis 0 0 20 XYZ\n  dof rx ry rz\n  limits (-160 20)\n   (-70 70)\n   (-60 70)\n end\n\
    begin\n  id 2\n  name shin\n  direction 0 -1 0\n  length 6\n  axis 0 0 20 XYZ\n  dof rx\n  limits (-10 170)\n end\n\
    :hierarchy\n begin\n  root thigh\n  thigh shin\n end\n";

fn parsed(text: &str) -> Asf {
    Asf::parse(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in\n{text}"))
}

/// A skeleton of one bone `a` with these fields in place of its direction and length.
fn one_bone(fields: &str) -> String {
    format!(":bonedata\nbegin\nname a\n{fields}\nend\n:hierarchy\nroot a\n")
}

fn bone_with(fields: &str) -> AsfBone {
    parsed(&one_bone(&format!("direction 0 1 0\nlength 2\n{fields}"))).bones.remove(0)
}

#[test]
fn every_section_is_read() {
    let asf = parsed(SMALL);
    assert_eq!((asf.version.as_deref(), asf.name.as_deref()), (Some("1.10"), Some("small")));
    assert_eq!((asf.units.mass, asf.units.length, asf.angle_unit()), (Some(1.0), Some(0.45), AngleUnit::Degrees));
    assert_eq!(asf.documentation, Some(vec!["  two bones".to_owned()]));
    assert_eq!((asf.root.position, asf.root.axis), ([0.0, 1.0, 0.0], EulerOrder::Xyz));
    assert_eq!(dof_words(&asf.root.order), "tx ty tz rx ry rz");
    let thigh = &asf.bones[0];
    assert_eq!(
        (thigh.id, thigh.name.as_str(), thigh.direction, thigh.length),
        (Some(1), "thigh", [0.0, -1.0, 0.0], 7.0)
    );
    assert_eq!((thigh.axis, dof_words(&thigh.dofs).as_str()), ([0.0, 0.0, 20.0], "rx ry rz"));
    assert_eq!(thigh.limits, [(-160.0, 20.0), (-70.0, 70.0), (-60.0, 70.0)]);
    assert_eq!(asf.hierarchy[1], Family { parent: "thigh".to_owned(), children: vec!["shin".to_owned()] });
}

#[test]
fn a_colon_begins_a_section_only_at_the_beginning_of_a_line() {
    let asf = parsed(&SMALL.replace(":documentation\n", ":documentation :note\n"));
    assert_eq!(asf.documentation, Some(vec![":note".to_owned(), "  two bones".to_owned()]));
    assert_eq!(Asf::parse(&asf.to_bytes()), Ok(asf));
    let error = Asf::parse(SMALL.replace(":units\n", ":units :note\n").as_bytes()).unwrap_err();
    assert_eq!((error.position, error.found.as_str()), (Position::Text { line: 3, column: 8 }, "`:note`"));
}

#[test]
fn layout_does_not_matter() {
    let wanted = parsed(SMALL);
    let layouts = [
        SMALL.replace('\n', "\r\n"),
        SMALL.replace('\n', "\r"),
        SMALL.replace(' ', "  ").replace("    two  bones", "  two bones"),
        SMALL.replace(" axis", "\taxis\t").replace("   (", "("),
        SMALL.trim_end().to_owned(),
        format!("\u{FEFF}{SMALL}"),
        format!("# made by hand\n\n{}", SMALL.replace(" begin\n  id", " begin # a bone\n# its number\n\n  id")),
        SMALL.replace("dof rx", "DOF RX").replace(":root", ":ROOT").replace("axis", "Axis").replace("XYZ", "xyz"),
        SMALL.replace("(-160 20)\n   (-70 70)\n   (-60 70)", "-160 20 -70 70\n -60 70"),
        SMALL.replace("(-160 20)\n   (-70 70)", "( -160,20 ) (-70 70)"),
    ];
    for layout in layouts {
        assert_eq!(parsed(&layout), wanted, "{layout}");
    }
}

#[test]
fn fields_and_sections_may_come_in_any_order() {
    let asf = parsed(
        ":hierarchy\nroot a\n:bonedata\nbegin\ndof rz\nlength 2\naxis 1 2 3 ZYX\nname a\ndirection 1 0 0\nend\n",
    );
    let bone = &asf.bones[0];
    assert_eq!((bone.axis_order, bone.length, bone.name.as_str()), (EulerOrder::Zyx, 2.0, "a"));
}

#[test]
fn what_has_no_meaning_here_is_kept() {
    let text = SMALL
        .replace(":root\n", ":root\n glow  red # no\n")
        .replace("  id 2\n", "  id 2\n  colour 1  2\n  bodymass 3\n  cofmass 0.5\n");
    let text = text.replace(" mass 1\n", " mass 1\n force 2\n") + ":skin body.obj\n  a b\n\n # c\n";
    let asf = parsed(&text);
    assert_eq!(
        (asf.root.others.as_slice(), asf.units.others.as_slice()),
        (&["glow  red".to_owned()][..], &["force 2".to_owned()][..])
    );
    assert_eq!((asf.bones[1].others[0].as_str(), asf.bones[1].body_mass), ("colour 1  2", Some(3.0)));
    assert_eq!(asf.bones[1].centre_of_mass, [0.5]);
    assert_eq!((asf.others[0].name.as_str(), asf.others[0].value.as_str()), (":skin", "body.obj"));
    assert_eq!(asf.others[0].lines, ["  a b", "", " # c"]);
    assert_eq!(parsed(&String::from_utf8_lossy(&asf.to_bytes())), asf);
}

#[test]
fn limits_may_be_infinite() {
    let bone = bone_with("dof rx l\nlimits (-inf inf)\n (-1 INF)");
    assert_eq!(bone.limits, [(f64::NEG_INFINITY, f64::INFINITY), (-1.0, f64::INFINITY)]);
}

#[test]
fn limits_without_a_degree_of_freedom_are_left_out_with_a_notice() {
    let asf = parsed(&one_bone("direction 0 1 0\nlength 2\ndof rx\nlimits (-1 1) (-2 2)"));
    assert_eq!(asf.bones[0].limits.len(), 2);
    assert!(asf.skeleton().bones[1].limits.is_empty());
    assert_eq!(asf.notices(), ["Limits left out where they are not one pair per degree of freedom: a"]);
}

#[test]
fn latin_1_text_is_read_as_such() {
    let text: Vec<u8> =
        one_bone("direction 0 1 0\nlength 2").replace(" a\n", " \u{FF}\n").chars().map(|c| c as u8).collect();
    assert_eq!(Asf::parse(&text).unwrap().bones[0].name, "\u{FF}");
}

#[test]
fn a_bone_ends_where_its_children_start() {
    let skeleton = parsed(SMALL).skeleton();
    assert_eq!(skeleton.rest_heads(), [DVec3::Y, DVec3::Y, DVec3::new(0.0, -6.0, 0.0)]);
    assert_eq!(skeleton.bones[2].tail, DVec3::new(0.0, -6.0, 0.0));
    assert_eq!(skeleton.bones.iter().map(|bone| bone.parent).collect::<Vec<_>>(), [None, Some(0), Some(1)]);
    let (low, high) = skeleton.bones[2].limits[0];
    assert_eq!((low, high), ((-10.0_f64).to_radians(), 170.0_f64.to_radians()));
}

#[test]
fn parents_come_first_whatever_the_order_of_the_file() {
    let bone = |name: &str| format!("begin\nname {name}\ndirection 0 1 0\nlength 1\nend\n");
    let bones: String = ["tip", "mid", "base", "side"].map(bone).concat();
    let skeleton = parsed(&format!(":bonedata\n{bones}:hierarchy\nmid tip\nroot base side\nbase mid\n")).skeleton();
    let names: Vec<_> = skeleton.bones.iter().map(|bone| bone.name.as_str()).collect();
    assert_eq!(names, ["root", "base", "mid", "tip", "side"]);
    assert_eq!(skeleton.rest_heads()[3], DVec3::new(0.0, 2.0, 0.0));
}

#[test]
fn an_axis_is_applied_in_its_order_in_the_unit_of_the_file() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let units = format!(
        ":units\nangle rad\n{}",
        one_bone(&format!("direction 0 1 0\nlength 2\naxis {quarter} {quarter} 0 YXZ"))
    );
    // Y first: X goes to -Z; then X: -Z goes to Y.
    let turned = parsed(&units).skeleton().bones[1].axes * DVec3::X;
    assert!(turned.distance(DVec3::Y) < 1e-15, "{turned}");
}

#[test]
fn the_order_of_rotations_is_the_order_of_the_list() {
    let table =
        [("rx ry rz", "XYZ"), ("rz ry rx", "ZYX"), ("tx rz l rx", "YZX"), ("rx rz", "XYZ"), ("ry", "XYZ"), ("", "XYZ")];
    for (dofs, order) in table {
        let bone = bone_with(&format!("dof {dofs}"));
        let found = ORDER_WORDS.iter().find(|(_, known)| *known == rotation_order(&bone.dofs)).unwrap().0;
        assert_eq!(found, order, "{dofs}");
    }
}

#[test]
fn z_is_up_only_where_the_rest_pose_clearly_says_so() {
    let up = |direction: &str| parsed(&one_bone(&format!("direction {direction}\nlength 2"))).skeleton().up;
    assert_eq!([up("0 1 0"), up("1 0 0"), up("0 0.6 0.8"), up("0 0.1 0.9")], [DVec3::Y, DVec3::Y, DVec3::Y, DVec3::Z]);
}

#[test]
fn wrong_files_are_refused_in_words() {
    let bones = ":bonedata\nbegin\nname a\ndirection 0 1 0\nlength 1\nend\n";
    let table = [
        (String::new(), "line 1, column 1: expected an Acclaim skeleton (.asf), found an empty file"),
        ("\n# nothing\n".to_owned(), "line 3, column 1: expected the section `:bonedata`, found the end of the file"),
        ("hello".to_owned(), "line 1, column 1: expected a section such as `:bonedata`, found `hello`"),
        (bones.to_owned(), "line 7, column 1: expected the section `:hierarchy`, found the end of the file"),
        (":DEGREES\n1\nroot 1\n".to_owned(), "line 1, column 1: expected an Acclaim skeleton (.asf), found an Acclaim motion (.amc)"),
        (":units\n length 0\n".to_owned(), "line 2, column 9: expected a number from 1e-9 to 1e9 for the unit `length`, found `0`"),
        (":units\n angle grad\n".to_owned(), "line 2, column 8: expected `deg` or `rad`, found `grad`"),
        (":units\n mass 1 2\n".to_owned(), "line 2, column 9: expected the end of the line, found `2`"),
        (":name a\n:name b\n".to_owned(), "line 2, column 1: expected `:name` only once, found it again"),
        (":root\n order TX TQ\n".to_owned(), "line 2, column 11: expected one of tx ty tz rx ry rz l, found `TQ`"),
        (":root\n axis XYX\n".to_owned(), "line 2, column 7: expected an order such as XYZ, found `XYX`"),
        (":root\n position 0 nan 0\n".to_owned(), "line 2, column 13: expected a number for `position` of the root, a finite number, found `nan`"),
        (":root\n position 0 1\n".to_owned(), "line 2, column 14: expected a number for `position` of the root, found the end of the line"),
        (one_bone("length 1"), "line 5, column 1: expected `direction` of bone `a`, found `end`"),
        (one_bone("direction 0 1e999 0"), "line 4, column 13: expected a number for `direction` of bone `a`, a finite number, found `1e999`"),
        (one_bone("length 1e300"), "line 4, column 8: expected a number for `length` of bone `a` between -1e15 and 1e15, found `1e300`"),
        (one_bone("length seven"), "line 4, column 8: expected a number for `length` of bone `a`, found `seven`"),
        (one_bone("dof rx rx"), "line 4, column 8: expected each degree of freedom only once, found `rx` again"),
        (one_bone("limits (-1 nan)"), "line 4, column 12: expected a number for `limits` of bone `a`, found `nan`"),
        (one_bone("limits (-1 1) (2"), "line 5, column 1: expected the upper limit of bone `a`, found `end`"),
        (one_bone("length 7.1\n578"), "line 5, column 1: expected a field of bone `a`, found `578`"),
        (one_bone("id one"), "line 4, column 4: expected a whole number for `id`, found `one`"),
        (one_bone("begin"), "line 4, column 1: expected `end` of bone `a`, found `begin`"),
        (":bonedata\nbegin\nname a\n:hierarchy\n".to_owned(), "line 4, column 1: expected `end` of bone `a`, found `:hierarchy`"),
        (":bonedata\nname a\n".to_owned(), "line 2, column 1: expected `begin`, a section or the end of the file, found `name`"),
        (bones.to_owned() + ":hierarchy\nbegin\nroot a\n", "line 10, column 1: expected `end` of the hierarchy, found the end of the file"),
        (bones.to_owned() + ":hierarchy\nroot b\n", "line 8, column 6: expected the name of a bone of `:bonedata`, found `b`"),
        (bones.to_owned() + ":hierarchy\na root\n", "line 8, column 3: expected a bone, for nothing is above `root`, found `root`"),
        (bones.to_owned() + ":hierarchy\nroot a a\n", "line 8, column 8: expected a bone that has no parent yet, found `a`"),
        (bones.to_owned() + ":hierarchy\n", "line 2, column 1: expected bone `a` to be connected with `root` by `:hierarchy`, found no line that has it as a child"),
        (bones.to_owned() + ":hierarchy\na a\n", "line 2, column 1: expected bone `a` to be connected with `root` by `:hierarchy`, found that its parents lead in a circle"),
        (bones.replace("end\n", "end\nbegin\nname a\ndirection 0 1 0\nlength 1\nend\n"), "line 7, column 1: expected a bone with a name of its own, found a second `a`"),
        (one_bone("direction 0 1 0\nlength 1").replace(" a", " ROOT"), "line 2, column 1: expected a bone with a name of its own, found a second `ROOT`"),
    ];
    for (text, message) in table {
        let text = if message.contains("name of its own") && !text.contains(":hierarchy") {
            text + ":hierarchy\n"
        } else {
            text
        };
        let error = Asf::parse(text.as_bytes()).map(|_| ()).expect_err(&text);
        assert_eq!(error.to_string(), message, "{text}");
    }
    assert_eq!(Format::Asf.extension(), "asf");
}
