//! What a query may ask for by name.

/// A text whose words are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TextField {
    /// The name of the file.
    Name,
    /// The path of the folder that it lies in.
    Folder,
    /// What somebody says of it.
    Description,
}

/// A text that is compared as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WholeField {
    /// Who was recorded.
    Subject,
    /// What it was recorded with.
    Group,
    /// Any of the clip's tags.
    Tag,
    /// The file of the skeleton, or the fingerprint of its joints.
    Skeleton,
}

/// Yes or no.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlagField {
    /// Whether somebody went over the motion; may be unknown.
    Cleaned,
    /// Whether the file is gone.
    Missing,
    /// Whether the file cannot be read.
    Broken,
    /// Whether the user likes it.
    Favourite,
}

/// A number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberField {
    /// Frames per second.
    Rate,
    /// How long it lasts, in seconds.
    Duration,
    /// How many frames.
    Frames,
    /// How tall the rest pose is, in metres.
    Height,
    /// Stars: 0, none, to 5.
    Rating,
    /// Bytes of the file.
    Size,
    /// How many joints.
    Joints,
    /// How many markers.
    Markers,
}

/// Anything that may stand before an operator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// Words of a text.
    Text(TextField),
    /// A text as a whole.
    Whole(WholeField),
    /// Yes or no.
    Flag(FlagField),
    /// A number.
    Number(NumberField),
    /// The day of the recording.
    Date,
    /// When the user last used it.
    Used,
    /// The kind of file.
    Format,
}

/// Every field by its name, with an example of its use.
const FIELDS: [(&str, Field, &str); 22] = [
    ("subject", Field::Whole(WholeField::Subject), "subject:07"),
    ("format", Field::Format, "format:bvh"),
    ("tag", Field::Whole(WholeField::Tag), "tag:walk"),
    ("folder", Field::Text(TextField::Folder), "folder:studio"),
    ("name", Field::Text(TextField::Name), "name:walk"),
    ("group", Field::Whole(WholeField::Group), "group:session2"),
    ("description", Field::Text(TextField::Description), "description:jump"),
    ("skeleton", Field::Whole(WholeField::Skeleton), "skeleton:07.asf"),
    ("date", Field::Date, "date:2004-05"),
    ("rate", Field::Number(NumberField::Rate), "rate>=100"),
    ("duration", Field::Number(NumberField::Duration), "duration<10"),
    ("frames", Field::Number(NumberField::Frames), "frames>500"),
    ("height", Field::Number(NumberField::Height), "height>1.5"),
    ("rating", Field::Number(NumberField::Rating), "rating>=3"),
    ("size", Field::Number(NumberField::Size), "size<1mb"),
    ("joints", Field::Number(NumberField::Joints), "joints:31"),
    ("markers", Field::Number(NumberField::Markers), "markers>=40"),
    ("cleaned", Field::Flag(FlagField::Cleaned), "cleaned:yes"),
    ("missing", Field::Flag(FlagField::Missing), "missing:yes"),
    ("broken", Field::Flag(FlagField::Broken), "broken:no"),
    ("favourite", Field::Flag(FlagField::Favourite), "favourite:yes"),
    ("used", Field::Used, "used:7d"),
];

impl Field {
    /// Returns the field of a name, in either case.
    pub(super) fn named(name: &str) -> Option<Self> {
        let is_name = |known: &str| known.eq_ignore_ascii_case(name);
        FIELDS.iter().find(|(known, ..)| is_name(known)).map(|(_, field, _)| *field)
    }

    /// Returns a term with this field that means something.
    pub(super) fn example(self) -> &'static str {
        FIELDS.iter().find(|(_, field, _)| *field == self).map_or("", |(.., example)| example)
    }

    /// Returns whether a clip may lack it; only such a field can be `none`.
    pub(super) fn may_be_unknown(self) -> bool {
        match self {
            Self::Text(field) => field == TextField::Description,
            Self::Flag(field) => field == FlagField::Cleaned,
            Self::Number(field) => !matches!(field, NumberField::Rating | NumberField::Size),
            Self::Whole(_) | Self::Date | Self::Used => true,
            Self::Format => false,
        }
    }

    /// Returns the names of all fields: "subject, format, tag".
    pub(super) fn list() -> String {
        FIELDS.map(|(name, ..)| name).join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_has_a_name_and_an_example_that_is_understood() {
        for (name, field, example) in FIELDS {
            assert_eq!(Field::named(&name.to_uppercase()), Some(field));
            assert_eq!(field.example(), example);
            assert!(crate::query::Query::parse(example).is_ok(), "{example}");
        }
    }
}
