//! Frame after frame the values of all channels, as a file of motion has them: from there to the samples of one bone.

/// The values of a motion in rows, one for each frame.
#[derive(Clone, Copy)]
pub(super) struct FrameValues<'a> {
    values: &'a [f64],
    width: usize,
}

impl<'a> FrameValues<'a> {
    /// Takes rows of `width` values.
    pub(super) fn new(values: &'a [f64], width: usize) -> Self {
        Self { values, width: width.max(1) }
    }

    /// Returns the values of each frame.
    pub(super) fn rows(&self) -> std::slice::ChunksExact<'a, f64> {
        self.values.chunks_exact(self.width)
    }

    /// Returns one column.
    pub(super) fn column(&self, column: usize) -> impl ExactSizeIterator<Item = f64> + use<'a> {
        self.rows().map(move |row| row.get(column).copied().unwrap_or_default())
    }

    /// Returns three components of every frame: `columns` say which component is in which column (of two that are the same,
    /// the last counts) and what its values are multiplied by is `scale`; those that have no column are as in `others`.
    pub(super) fn triples(&self, columns: &[(usize, usize)], scale: f64, others: [f64; 3]) -> Vec<[f64; 3]> {
        // No row has a column of that number.
        let mut places = [usize::MAX; 3];
        for (component, column) in columns {
            if let Some(place) = places.get_mut(*component) {
                *place = *column;
            }
        }
        let [x, y, z] = places;
        let triple = |row: &[f64]| {
            let value = |column: usize, other: f64| row.get(column).map_or(other, |value| value * scale);
            [value(x, others[0]), value(y, others[1]), value(z, others[2])]
        };
        self.rows().map(triple).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn components_come_from_their_columns_and_else_stay() {
        let frames = FrameValues::new(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], 3);
        assert_eq!(frames.triples(&[(2, 0), (0, 1)], 2.0, [9.0; 3]), [[4.0, 9.0, 2.0], [10.0, 9.0, 8.0]]);
        assert_eq!(frames.triples(&[(1, 0), (1, 2)], 1.0, [0.0; 3]), [[0.0, 3.0, 0.0], [0.0, 6.0, 0.0]]);
        assert_eq!(frames.column(1).collect::<Vec<_>>(), [2.0, 5.0]);
        assert!(FrameValues::new(&[], 0).triples(&[(0, 0)], 1.0, [0.0; 3]).is_empty());
    }
}
