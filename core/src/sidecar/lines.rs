//! A text as lines that keep what they are.

/// One line and how it ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Line {
    /// The line without its end.
    pub(super) text: String,
    /// `\n`, `\r\n`, `\r`, or nothing at the end of the file.
    pub(super) end: &'static str,
}

impl Line {
    /// Returns what stands before the first colon.
    pub(super) fn label(&self) -> Option<&str> {
        self.text.split_once(':').map(|(label, _)| label).filter(|label| !label.trim().is_empty())
    }

    /// Returns what stands behind the first colon, without outer blanks.
    pub(super) fn value(&self) -> &str {
        self.text.split_once(':').map_or("", |(_, value)| value.trim())
    }

    /// Replaces the value; the label and the blanks between the two stay.
    pub(super) fn set_value(&mut self, value: &str) {
        let (label, rest) = self.text.split_once(':').unwrap_or((&self.text, ""));
        let blanks = rest.len() - rest.trim_start().len();
        let gap = rest.get(..blanks).filter(|gap| !gap.is_empty()).unwrap_or(" ");
        let gap = if value.is_empty() { "" } else { gap };
        self.text = format!("{label}:{gap}{value}");
    }
}

/// Splits a text into lines: together they are the text.
pub(super) fn split(text: &str) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let (line, tail) = rest.split_at(rest.find(['\n', '\r']).unwrap_or(rest.len()));
        let end = ["\r\n", "\n", "\r"].into_iter().find(|end| tail.starts_with(end)).unwrap_or("");
        lines.push(Line { text: line.to_owned(), end });
        rest = tail.get(end.len()..).unwrap_or_default();
    }
    lines
}

/// Returns the end that most lines have; `\n` where there is none.
pub(super) fn usual_end(lines: &[Line]) -> &'static str {
    let count = |end: &&str| lines.iter().filter(|line| line.end == *end).count();
    let most = ["\r", "\r\n", "\n"].into_iter().max_by_key(count);
    most.unwrap_or("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_keep_their_ends() {
        let text = "a\r\nb\n\nc\rd";
        let lines = split(text);
        let ends: Vec<_> = lines.iter().map(|line| line.end).collect();
        assert_eq!(ends, ["\r\n", "\n", "\n", "\r", ""]);
        assert_eq!(lines.iter().map(|line| format!("{}{}", line.text, line.end)).collect::<String>(), text);
        assert_eq!((usual_end(&lines), usual_end(&[]), usual_end(&split("a\r\nb"))), ("\n", "\n", "\r\n"));
    }

    #[test]
    fn an_edit_keeps_label_and_blanks() {
        let edited = |text: &str, value: &str| {
            let mut line = Line { text: text.to_owned(), end: "" };
            line.set_value(value);
            line.text
        };
        assert_eq!(edited("Subject :\t07  ", "08"), "Subject :\t08");
        assert_eq!(edited("Subject:", "08"), "Subject: 08");
        assert_eq!(edited("Comment: at 10:30", ""), "Comment:");
    }
}
