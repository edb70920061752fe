//! The filters in the fewest words: what the fast versions are compared with.

use super::{Depth, FilterKind};

/// Filters one channel, one window after the other, each by the definition.
pub(super) fn filter_values(values: &[f64], kind: FilterKind, depth: Depth) -> Vec<f64> {
    let windows = (0..values.len()).map(|frame| {
        let reach = frame.min(values.len() - 1 - frame).min(depth.get() / 2);
        &values[frame - reach..=frame + reach]
    });
    windows.map(|window| of_window(window, kind)).collect()
}

fn of_window(window: &[f64], kind: FilterKind) -> f64 {
    match kind {
        FilterKind::Median => {
            let mut sorted = window.to_vec();
            sorted.sort_by(f64::total_cmp);
            sorted[window.len() / 2]
        }
        FilterKind::Average => window.iter().sum::<f64>() / window.len() as f64,
        FilterKind::Weighted => pascal_row(window.len()).iter().zip(window).map(|(weight, value)| weight * value).sum(),
    }
}

/// The row of Pascal's triangle with so many entries, over its sum: each row from the one above, halved as it grows.
pub(super) fn pascal_row(entries: usize) -> Vec<f64> {
    let mut row = vec![1.0];
    while row.len() < entries {
        let left = row.iter().chain([&0.0]);
        let right = [&0.0].into_iter().chain(&row);
        row = left.zip(right).map(|(a, b)| (a + b) / 2.0).collect();
    }
    row
}
