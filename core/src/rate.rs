//! Frame rates as they are meant.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

/// Relative distance within which a written rate means a usual one: `0.0083333` s is 120 Hz, `29.97` is 30/1.001.
const ROUNDING: f64 = 1e-4;

/// Returns the usual rate (a whole number, or a whole number over 1.001) that `hz` stands for, or `hz` itself.
pub fn usual_rate(hz: f64) -> f64 {
    usual_rate_near(hz).unwrap_or(hz)
}

fn usual_rate_near(hz: f64) -> Option<f64> {
    let candidates = [hz.round(), (hz * 1.001).round() / 1.001];
    let distance = |candidate: f64| ((candidate - hz) / hz).abs();
    candidates
        .into_iter()
        .filter(|&candidate| candidate >= 1.0 && distance(candidate) < ROUNDING)
        .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
}

/// Rates at which motion is captured and played: what a rounded frame time can stand for.
const COMMON_RATES_HZ: [f64; 27] = [
    10.0,
    12.0,
    15.0,
    20.0,
    24.0,
    24.0 / 1.001,
    25.0,
    30.0,
    30.0 / 1.001,
    48.0,
    50.0,
    60.0,
    60.0 / 1.001,
    72.0,
    75.0,
    90.0,
    100.0,
    120.0,
    120.0 / 1.001,
    125.0,
    150.0,
    180.0,
    200.0,
    240.0,
    250.0,
    300.0,
    500.0,
];

/// Nobody captures motion slower than this: a longer frame time is one that was written for a rate.
const LONGEST_FRAME_S: f64 = 10.0;

/// Rates outside these are damage. They are the same for every format, so that what one can say all others can.
pub(crate) const RATES_HZ: RangeInclusive<f64> = 1e-3..=1e6;

/// A rate that was worked out from a frame time.
#[derive(Debug, Clone, PartialEq)]
pub struct FrameRate {
    /// Frames per second.
    pub hz: f64,
    /// Why it could be another one, in words; `None` where it could not.
    pub doubt: Option<String>,
}

/// Returns the rate that a frame time in seconds stands for; `None` where it is not above 0, or so small or large that
/// it is damage.
///
/// Files round: `0.0083333` is 120 Hz, and so is `0.0083`. What is nearer to a usual rate than [`usual_rate`] asks for is
/// that one. Else the digits say how far off the time may be, and a common rate within that is taken, with doubt
/// where several are.
pub fn rate_of_frame_time(seconds: f64) -> Option<FrameRate> {
    if seconds.is_nan() || seconds <= 0.0 {
        return None;
    }
    if seconds >= LONGEST_FRAME_S {
        if !RATES_HZ.contains(&seconds) {
            return None;
        }
        let doubt = format!("A frame time of {seconds} s is taken as {seconds} frames per second");
        return Some(FrameRate { hz: usual_rate(seconds), doubt: Some(doubt) });
    }
    let hz = 1.0 / seconds;
    if !RATES_HZ.contains(&hz) {
        return None;
    }
    if let Some(hz) = usual_rate_near(hz) {
        return Some(FrameRate { hz, doubt: None });
    }
    let half_digit = 0.5 * last_digit(seconds) * (1.0 + 1e-9);
    let meant = COMMON_RATES_HZ.into_iter().filter(|rate| (1.0 / rate - seconds).abs() <= half_digit);
    // Whole rates stand before their neighbours over 1.001, which are rarer.
    let nearest =
        |a: &f64, b: &f64| (a.fract() != 0.0, (a - hz).abs()).partial_cmp(&(b.fract() != 0.0, (b - hz).abs()));
    let meant: Vec<f64> = meant.collect();
    let Some(hz) = meant.iter().copied().min_by(|a, b| nearest(a, b).unwrap_or(Ordering::Equal)) else {
        return Some(FrameRate { hz, doubt: None });
    };
    let others: Vec<_> = meant.iter().filter(|rate| **rate != hz).map(|rate| format!("{rate:.2}")).collect();
    let doubt = (!others.is_empty()).then(|| {
        format!(
            "A frame time of {seconds} s is taken as {hz:.2} frames per second; {} would round to it too",
            others.join(", ")
        )
    });
    Some(FrameRate { hz, doubt })
}

/// Returns what one more in the last digit of a number is worth, in the fewest digits that say it.
fn last_digit(value: f64) -> f64 {
    let text = format!("{value}");
    let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    10_f64.powi(-i32::try_from(decimals).unwrap_or(i32::MAX))
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
