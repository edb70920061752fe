//! [`Asf`] -> bytes.

use super::{dof_words, Asf, AsfBone, ORDER_WORDS};
use crate::formats::AngleUnit;
use crate::number;
use crate::skeleton::EulerOrder;

impl Asf {
    /// Returns the file anew: reading it gives an equal `Asf`.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Writer(Vec::new());
        for (section, text) in [(":version", &self.version), (":name", &self.name)] {
            if let Some(text) = text {
                out.line(0, &[section, text]);
            }
        }
        self.write_units(&mut out);
        if let Some(lines) = &self.documentation {
            // On a line of its own, a text that begins with a colon would be the next section.
            let inline = lines.first().filter(|line| line.trim_start().starts_with(':'));
            out.line(0, &[":documentation", inline.map_or("", String::as_str)]);
            for line in lines.iter().skip(usize::from(inline.is_some())) {
                out.raw(line);
            }
        }
        self.write_root(&mut out);
        out.line(0, &[":bonedata"]);
        for bone in &self.bones {
            write_bone(bone, &mut out);
        }
        out.line(0, &[":hierarchy"]);
        out.line(1, &["begin"]);
        for family in &self.hierarchy {
            let words: Vec<_> = std::iter::once(&family.parent).chain(&family.children).map(String::as_str).collect();
            out.line(2, &words);
        }
        out.line(1, &["end"]);
        for section in &self.others {
            out.line(0, &[&section.name, &section.value]);
            for line in &section.lines {
                out.raw(line);
            }
        }
        out.0
    }

    fn write_units(&self, out: &mut Writer) {
        out.line(0, &[":units"]);
        for (field, value) in [("mass", self.units.mass), ("length", self.units.length)] {
            if let Some(value) = value {
                out.numbers(1, field, &[value], "");
            }
        }
        match self.units.angle {
            Some(AngleUnit::Degrees) => out.line(1, &["angle", "deg"]),
            Some(AngleUnit::Radians) => out.line(1, &["angle", "rad"]),
            None => {}
        }
        for line in &self.units.others {
            out.line(1, &[line]);
        }
    }

    fn write_root(&self, out: &mut Writer) {
        out.line(0, &[":root"]);
        out.line(1, &["order", &dof_words(&self.root.order).to_ascii_uppercase()]);
        out.line(1, &["axis", order_word(self.root.axis)]);
        out.numbers(1, "position", &self.root.position, "");
        out.numbers(1, "orientation", &self.root.orientation, "");
        for line in &self.root.others {
            out.line(1, &[line]);
        }
    }
}

fn write_bone(bone: &AsfBone, out: &mut Writer) {
    out.line(1, &["begin"]);
    if let Some(id) = bone.id {
        out.line(2, &["id", &id.to_string()]);
    }
    out.line(2, &["name", &bone.name]);
    out.numbers(2, "direction", &bone.direction, "");
    out.numbers(2, "length", &[bone.length], "");
    out.numbers(2, "axis", &bone.axis, order_word(bone.axis_order));
    if !bone.dofs.is_empty() {
        out.line(2, &["dof", &dof_words(&bone.dofs)]);
    }
    for (index, (low, high)) in bone.limits.iter().enumerate() {
        out.limit(if index == 0 { "limits" } else { "      " }, *low, *high);
    }
    if let Some(mass) = bone.body_mass {
        out.numbers(2, "bodymass", &[mass], "");
    }
    if !bone.centre_of_mass.is_empty() {
        out.numbers(2, "cofmass", &bone.centre_of_mass, "");
    }
    for line in &bone.others {
        out.line(2, &[line]);
    }
    out.line(1, &["end"]);
}

fn order_word(order: EulerOrder) -> &'static str {
    ORDER_WORDS.iter().find(|(_, known)| *known == order).map_or("XYZ", |(word, _)| word)
}

/// The file as far as it is written.
struct Writer(Vec<u8>);

impl Writer {
    /// Writes words that are not empty as one line.
    fn line(&mut self, depth: usize, words: &[&str]) {
        self.indent(depth);
        let words = words.iter().filter(|word| !word.is_empty());
        self.raw(&words.copied().collect::<Vec<_>>().join(" "));
    }

    /// Writes a line as it is.
    fn raw(&mut self, line: &str) {
        self.0.extend_from_slice(line.as_bytes());
        self.0.push(b'\n');
    }

    /// Writes a field of numbers, and a word behind them.
    fn numbers(&mut self, depth: usize, field: &str, values: &[f64], last: &str) {
        self.indent(depth);
        self.0.extend_from_slice(field.as_bytes());
        for value in values {
            self.0.push(b' ');
            number::write(*value, &mut self.0);
        }
        if !last.is_empty() {
            self.0.push(b' ');
        }
        self.raw(last);
    }

    fn limit(&mut self, field: &str, low: f64, high: f64) {
        self.indent(2);
        self.0.extend_from_slice(field.as_bytes());
        self.0.extend_from_slice(b" (");
        number::write(low, &mut self.0);
        self.0.push(b' ');
        number::write(high, &mut self.0);
        self.raw(")");
    }

    fn indent(&mut self, depth: usize) {
        self.0.extend(std::iter::repeat_n(b' ', 2 * depth));
    }
}
