//! How long the unit of an ASF is: the format does not say, a person's height does.

use super::Units;
use crate::skeleton::LengthUnit;

/// Heights of a rest pose that can be a person's, in metres.
const PERSON_M: std::ops::RangeInclusive<f64> = 1.0..=2.2;

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
    let metres_of = |(metres, is_divided, _): &(f64, bool, &str)| if *is_divided { metres / divisor } else { *metres };
    let is_plausible = |reading: &&(f64, bool, &str)| PERSON_M.contains(&(height * metres_of(reading)));
    let mut plausible = READINGS.iter().filter(is_plausible);
    let first = plausible.next();
    let reading = first.unwrap_or(&READINGS[0]);
    let metres = metres_of(reading);
    // Centimetres / 0.01 and metres are the same: only readings that differ make a choice doubtful.
    let others: Vec<_> =
        plausible.filter(|other| (metres_of(other) / metres - 1.0).abs() > 1e-9).map(|r| r.2).collect();
    let name = match reading {
        (_, true, name) if divisor != 1.0 => format!("{name} / {divisor}"),
        (_, _, name) => (*name).to_owned(),
    };
    let doubt = match (first, others.first()) {
        (None, _) => "; in no known unit is it a person of 1.0 to 2.2 m".to_owned(),
        (_, Some(other)) => format!("; {other} would be plausible too"),
        _ => String::new(),
    };
    let reason = format!("{name}: the rest pose is {:.2} m tall{doubt}", height * metres);
    LengthUnit { metres, reason, is_certain: first.is_some() && others.is_empty() }
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
