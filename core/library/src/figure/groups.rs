//! Points that hang together.

/// Groups of points: each point has one nearer to the one that stands for its whole group.
pub(crate) struct Groups(Vec<usize>);

impl Groups {
    /// Begins with each point by itself.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// Returns the point that stands for a point's group.
    pub(crate) fn of(&mut self, point: usize) -> usize {
        let mut at = point;
        while let Some(next) = self.0.get(at).copied().filter(|next| *next != at) {
            // Half of the way is saved for the next time.
            let beyond = self.0.get(next).copied().unwrap_or(next);
            if let Some(own) = self.0.get_mut(at) {
                *own = beyond;
            }
            at = next;
        }
        at
    }

    /// Makes one group of two points' groups; returns false where it was one.
    pub(crate) fn join(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.of(a), self.of(b));
        if let Some(own) = self.0.get_mut(a) {
            *own = b;
        }
        a != b
    }
}
