//! How long the unit of an ASF is: the format does not say, a person's height does.

use super::Units;
use crate::infer::Reading;
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

/// Returns the first reading in which `height` is a person's; the first of all, as a guess, if there is none.
pub(super) fn infer_unit(units: &Units, height: f64) -> LengthUnit {
    let divisor = units.length.unwrap_or(1.0);
    let readings = READINGS.map(|(metres, is_divided, name)| {
        if is_divided && divisor != 1.0 {
            Reading::new(metres / divisor, format!("{name} / {divisor}"))
        } else {
            Reading::new(metres, name)
        }
    });
    let plausible = Reading::plausible(&readings, height);
    let (reading, other) = plausible.unwrap_or((&readings[0], None));
    let doubt = match (plausible, other) {
        (None, _) => "; in no known unit is it a person of 1.0 to 2.2 m".to_owned(),
        (_, Some(other)) => format!("; {} would be plausible too", other.name),
        _ => String::new(),
    };
    let metres = reading.metres;
    let reason = format!("{}: the rest pose is {:.2} m tall{doubt}", reading.name, height * metres);
    LengthUnit { metres, reason, is_certain: plausible.is_some() && other.is_none() }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let unit = infer_unit(&Units { length, ..Units::default() }, height);
            assert_eq!((unit.metres, unit.is_certain, unit.reason.as_str()), (metres, is_certain, reason));
        }
    }
}
