//! Frame times as files round them.

use super::{answer, Counts};
use motion_theater_core::rate::rate_of_frame_time;

/// What every file is played at, as a rate is written in it.
pub const RERATED_HZ: [f64; 6] = [24.0 / 1.001, 25.0, 30.0 / 1.001, 60.0 / 1.001, 120.0 / 1.001, 240.0];

const RATES_HZ: [f64; 16] =
    [23.976, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0, 59.94, 60.0, 90.0, 100.0, 119.88, 120.0, 125.0, 200.0, 240.0];

/// Counts the answer to which rate a copy has that was written at `hz`. Some formats have 32 bits for it.
pub fn count(counts: &mut Counts, file: &str, hz: f64, found: Option<f64>, is_certain: bool) {
    let is_right = found.is_some_and(|found| (found / hz - 1.0).abs() < 1e-7);
    counts.add(&format!("{file} at {hz} Hz"), &answer(&format!("{found:?}"), is_certain), is_right);
}

/// Asks which rate each frame time stands for, written with four to nine decimals.
pub fn rounded_frame_times() -> Counts {
    let mut counts = Counts::default();
    for named in RATES_HZ {
        let truth = if (named - f64::round(named)).abs() > 1e-9 { f64::round(named) / 1.001 } else { named };
        for decimals in 4..10 {
            let written: f64 = format!("{:.decimals$}", 1.0 / truth).parse().unwrap();
            let rate = rate_of_frame_time(written).unwrap();
            let found = answer(&format!("{rate:?}"), rate.doubt.is_none());
            counts.add(&format!("{truth} Hz as {written}"), &found, (rate.hz - truth).abs() < 1e-9);
        }
    }
    counts
}
