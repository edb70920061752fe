//! Which points are the head's: a round head is what makes lines a person.

/// A head is this wide, in heights of the figure.
pub(super) const WIDTH: f32 = 0.125;

/// What the names of markers on a head end with, on either side, in front and behind.
const MARKER_ENDS: [&str; 5] = ["fhd", "bhd", "head", "thd", "mhd"];

/// Returns the points of the head: joints that are called so, or markers around it; none where no name says so.
pub(super) fn points(names: &[String]) -> Vec<usize> {
    let is_of_head = |name: &str| {
        let own = name.rsplit(':').next().unwrap_or(name).to_lowercase();
        let own = own.trim_end_matches(|c: char| !c.is_alphabetic());
        own.starts_with("head") || own.ends_with("head_end") || MARKER_ENDS.iter().any(|end| own.ends_with(end))
    };
    (0..names.len()).filter(|point| names.get(*point).is_some_and(|name| is_of_head(name))).collect()
}
