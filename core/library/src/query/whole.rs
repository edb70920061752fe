//! Texts that are compared as a whole: subjects, groups, tags, skeletons.

use unicode_normalization::char::is_combining_mark;
use unicode_normalization::UnicodeNormalization;

/// A text to compare with; neither case nor accents matter, nor blanks around it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WholeValue {
    /// Digits alone, without leading zeros: `7` is `07`.
    Number(String),
    /// The whole text.
    Text(String),
    /// How the text begins.
    Beginning(String),
}

impl WholeValue {
    /// Understands a value; a star behind one that stood in no quotes makes it a beginning.
    pub(super) fn new(value: &str, is_quoted: bool) -> Self {
        match value.strip_suffix('*').filter(|_| !is_quoted) {
            Some(beginning) => Self::Beginning(folded(beginning)),
            None => {
                without_zeros(value.trim()).map_or_else(|| Self::Text(folded(value)), |n| Self::Number(n.to_owned()))
            }
        }
    }

    /// Returns whether `text` is what was asked for; a blank one never is, for it says nothing.
    pub(super) fn is_met_by(&self, text: &str) -> bool {
        if text.trim().is_empty() {
            return false;
        }
        match self {
            Self::Number(digits) => without_zeros(text.trim()) == Some(digits),
            Self::Text(whole) => folded(text) == *whole,
            Self::Beginning(beginning) => folded(text).starts_with(beginning.as_str()),
        }
    }

    /// Returns whether a skeleton is what was asked for: its fingerprint, its file, or that without the extension.
    pub(super) fn is_met_by_skeleton(&self, fingerprint: Option<&str>, path: Option<&str>) -> bool {
        let file = path.map(|path| path.rsplit(['/', '\\']).next().unwrap_or(path));
        let stem = file.map(|file| file.rsplit_once('.').map_or(file, |(stem, _)| stem));
        [fingerprint, file, stem].into_iter().flatten().any(|text| self.is_met_by(text))
    }
}

/// Returns a text as it is compared: small letters, no accents, no blanks around it.
fn folded(text: &str) -> String {
    if text.is_ascii() {
        return text.trim().to_ascii_lowercase();
    }
    text.trim().to_lowercase().nfd().filter(|character| !is_combining_mark(*character)).collect()
}

/// Returns digits without leading zeros; `None` for everything but digits.
fn without_zeros(text: &str) -> Option<&str> {
    let is_number = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| text.trim_start_matches('0'))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_met(value: &str, text: &str) -> bool {
        WholeValue::new(value, false).is_met_by(text)
    }

    #[test]
    fn case_and_accents_do_not_matter() {
        assert!(is_met("josé", " Jose"));
        assert!(is_met("ANNA smith", "Änna Smith"));
        assert!(is_met("müller", "mu\u{308}ller"));
        assert!(!is_met("anna", "Anna Smith"));
    }

    #[test]
    fn digits_alone_are_compared_as_numbers() {
        assert!(is_met("7", "07") && is_met("007", "7") && is_met("0", "000"));
        assert!(!is_met("7", "70") && !is_met("7", "7a") && !is_met("07a", "7a") && !is_met("0", ""));
    }

    #[test]
    fn a_star_asks_for_a_beginning() {
        assert!(is_met("ann*", "Anna") && is_met("*", "anything") && is_met("0*", "07"));
        assert!(!is_met("ann*", "Hanna") && !is_met("*", " "));
        assert!(WholeValue::new("a*", true).is_met_by("A*") && !WholeValue::new("a*", true).is_met_by("ab"));
    }

    #[test]
    fn a_skeleton_goes_by_its_file_or_its_fingerprint() {
        let skeleton = |value: &str, path| WholeValue::new(value, false).is_met_by_skeleton(Some("ab12"), path);
        for value in ["7.asf", "07.ASF", "07", "7", "AB12", "ab*"] {
            assert_eq!(skeleton(value, Some("/clips/07/07.asf")), value != "7.asf", "{value}");
        }
        assert!(skeleton("07.asf", Some(r"C:\clips\07.asf")) && skeleton("human", Some("human")));
        assert!(!skeleton("07.asf", None));
    }
}
