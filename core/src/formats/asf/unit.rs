//! How long the unit of an ASF is: the format does not say, a person's height does.

use super::Units;
use crate::infer::{Answer, Reading};
use crate::skeleton::LengthUnit;

/// The readings, likely ones first: metres per unit, whether values are divided by `length` first, words.
const READINGS: [(f64, bool, &str); 6] = [
    (0.0254, true, "inches"),
    (0.01, true, "centimetres"),
    (1.0, false, "metres"),
    (0.001, false, "millimetres"),
    (0.01, false, "centimetres"),
    (0.0254, false, "inches"),
];

/// Returns the first reading in which `height` is a person's. If there is none, that of the bones is taken, which may be
/// an unusual one, and without a person the first of all.
pub(super) fn infer_unit(units: &Units, height: f64, of_bones: &Answer<f64>) -> LengthUnit {
    let readings = readings(units);
    let Some((reading, other)) = Reading::plausible(&readings, height) else {
        let is_person = Reading::plausible(&[Reading::new(of_bones.value, "")], height).is_some();
        let Answer { value, reason, is_certain } = of_bones.clone();
        let of_bones = LengthUnit { metres: value, reason, is_certain };
        return if is_person { of_bones } else { assumed_unit(units, height) };
    };
    let doubt = other.map_or_else(String::new, |other| format!("; {} would be plausible too", other.name));
    LengthUnit {
        metres: reading.metres,
        reason: format!("{}{doubt}", tall(reading, height)),
        is_certain: other.is_none(),
    }
}

/// Returns the first reading, as a guess.
pub(super) fn assumed_unit(units: &Units, height: f64) -> LengthUnit {
    let [reading, ..] = readings(units);
    let reason = format!("{}; in no known unit is it a person of 1.0 to 2.2 m", tall(&reading, height));
    LengthUnit { metres: reading.metres, reason, is_certain: false }
}

fn readings(units: &Units) -> [Reading; READINGS.len()] {
    let divisor = units.length.unwrap_or(1.0);
    READINGS.map(|(metres, is_divided, name)| {
        if is_divided && divisor != 1.0 {
            Reading::new(metres / divisor, format!("{name} / {divisor}"))
        } else {
            Reading::new(metres, name)
        }
    })
}

fn tall(reading: &Reading, height: f64) -> String {
    format!("{}: the rest pose is {:.2} m tall", reading.name, height * reading.metres)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is inferred where there is no body.
    fn nobody() -> Answer<f64> {
        Answer { value: 0.01, reason: String::new(), is_certain: false }
    }

    #[test]
    fn the_first_reading_that_makes_a_person_is_taken() {
        let table = [
            (Some(0.45), 30.0, 0.0254 / 0.45, true, "inches / 0.45: the rest pose is 1.69 m tall"),
            (Some(0.01), 1.7, 1.0, true, "centimetres / 0.01: the rest pose is 1.70 m tall"),
            (Some(1.0), 68.0, 0.0254, true, "inches: the rest pose is 1.73 m tall"),
            (None, 170.0, 0.01, true, "centimetres: the rest pose is 1.70 m tall"),
            (Some(0.45), 1.7, 1.0, true, "metres: the rest pose is 1.70 m tall"),
            (None, 1700.0, 0.001, true, "millimetres: the rest pose is 1.70 m tall"),
            (
                Some(0.6),
                49.0,
                0.0254 / 0.6,
                false,
                "inches / 0.6: the rest pose is 2.07 m tall; inches would be plausible too",
            ),
            (
                Some(0.45),
                0.0,
                0.0254 / 0.45,
                false,
                "inches / 0.45: the rest pose is 0.00 m tall; in no known unit is it a person of 1.0 to 2.2 m",
            ),
        ];
        for (length, height, metres, is_certain, reason) in table {
            let unit = infer_unit(&Units { length, ..Units::default() }, height, &nobody());
            assert_eq!((unit.metres, unit.is_certain, unit.reason.as_str()), (metres, is_certain, reason));
        }
    }

    #[test]
    fn where_no_reading_makes_a_person_the_bones_are_asked() {
        let units = Units { length: Some(0.45), ..Units::default() };
        let of_bones = Answer { value: 0.1, reason: "decimetres".to_owned(), is_certain: true };
        let unit = infer_unit(&units, 17.0, &of_bones);
        assert_eq!((unit.metres, unit.is_certain, unit.reason.as_str()), (0.1, true, "decimetres"));
        assert_eq!(infer_unit(&units, 300.0, &of_bones).metres, 0.0254 / 0.45);
    }
}
