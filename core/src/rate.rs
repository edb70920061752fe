//! Frame rates as they are meant.

/// Relative distance within which a written rate means a usual one: `0.0083333` s is 120 Hz, `29.97` is 30/1.001.
const ROUNDING: f64 = 1e-4;

/// Returns the usual rate (a whole number, or a whole number over 1.001) that `hz` stands for, or `hz` itself.
pub fn usual_rate(hz: f64) -> f64 {
    let candidates = [hz.round(), (hz * 1.001).round() / 1.001];
    let distance = |candidate: f64| ((candidate - hz) / hz).abs();
    candidates
        .into_iter()
        .filter(|&candidate| candidate >= 1.0 && distance(candidate) < ROUNDING)
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
        .unwrap_or(hz)
}

#[cfg(test)]
mod tests {
    use super::usual_rate;

    #[test]
    fn rounded_rates_are_what_they_stand_for() {
        for (written, meant) in [
            (1.0 / 0.008_333_3, 120.0),
            (1.0 / 0.033_333, 30.0),
            (29.97, 30.0 / 1.001),
            (59.94, 60.0 / 1.001),
            (23.976, 24.0 / 1.001),
            (119.88, 120.0 / 1.001),
            (24.0, 24.0),
            (99.7, 99.7),
            (107.527, 107.527),
            (0.3, 0.3),
        ] {
            assert_eq!(usual_rate(written), meant, "{written}");
        }
        assert!(usual_rate(f64::NAN).is_nan());
    }
}
