//! Bytes <-> text, so that text which was not changed becomes the same bytes.

/// How the characters of a file are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Encoding {
    /// UTF-8; ASCII too.
    #[default]
    Utf8,
    /// UTF-8 behind a byte-order mark.
    Utf8Marked,
    /// UTF-16 behind a byte-order mark, the lower byte first.
    Utf16Le,
    /// UTF-16 behind a byte-order mark, the higher byte first.
    Utf16Be,
    /// A byte per character, as what cannot be any of the others is taken.
    Latin1,
}

const UTF8_MARK: &[u8] = &[0xEF, 0xBB, 0xBF];
const UTF16_LE_MARK: &[u8] = &[0xFF, 0xFE];
const UTF16_BE_MARK: &[u8] = &[0xFE, 0xFF];

/// Returns the text of any bytes, and how they were written: [`encode`] gives the same bytes again.
pub(super) fn decode(bytes: &[u8]) -> (String, Encoding) {
    let utf8 = |bytes: &[u8]| std::str::from_utf8(bytes).ok().map(str::to_owned);
    let marked = |mark: &[u8], read: &dyn Fn(&[u8]) -> Option<String>| read(bytes.strip_prefix(mark)?);
    let le = |bytes: &[u8]| utf16(bytes, u16::from_le_bytes);
    let be = |bytes: &[u8]| utf16(bytes, u16::from_be_bytes);
    None.or_else(|| Some((marked(UTF8_MARK, &utf8)?, Encoding::Utf8Marked)))
        .or_else(|| Some((marked(UTF16_LE_MARK, &le)?, Encoding::Utf16Le)))
        .or_else(|| Some((marked(UTF16_BE_MARK, &be)?, Encoding::Utf16Be)))
        .or_else(|| Some((utf8(bytes)?, Encoding::Utf8)))
        .unwrap_or_else(|| (bytes.iter().map(|&byte| char::from(byte)).collect(), Encoding::Latin1))
}

/// Returns the bytes of a text; `None` where it has a character that cannot be written so.
pub(super) fn encode(text: &str, encoding: Encoding) -> Option<Vec<u8>> {
    match encoding {
        Encoding::Utf8 => Some(text.as_bytes().to_vec()),
        Encoding::Utf8Marked => Some([UTF8_MARK, text.as_bytes()].concat()),
        Encoding::Utf16Le => Some([UTF16_LE_MARK.to_vec(), units(text, u16::to_le_bytes)].concat()),
        Encoding::Utf16Be => Some([UTF16_BE_MARK.to_vec(), units(text, u16::to_be_bytes)].concat()),
        Encoding::Latin1 => text.chars().map(|character| u8::try_from(character).ok()).collect(),
    }
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    String::from_utf16(&units).ok().filter(|_| rest.is_empty())
}

fn units(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    text.encode_utf16().flat_map(bytes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_encoding_is_recognised_and_written_again() {
        let table: [(&[u8], &str, Encoding); 7] = [
            (b"Ja", "Ja", Encoding::Utf8),
            ("Müller".as_bytes(), "Müller", Encoding::Utf8),
            (b"\xEF\xBB\xBFM\xC3\xBC", "Mü", Encoding::Utf8Marked),
            (b"M\xFCller", "Müller", Encoding::Latin1),
            (b"\xFF\xFEM\0\xFC\0", "Mü", Encoding::Utf16Le),
            (b"\xFE\xFF\0M\0\xFC", "Mü", Encoding::Utf16Be),
            (b"\xFF\xFEM", "ÿþM", Encoding::Latin1),
        ];
        for (bytes, text, encoding) in table {
            assert_eq!(decode(bytes), (text.to_owned(), encoding));
            assert_eq!(encode(text, encoding).as_deref(), Some(bytes));
        }
        assert_eq!(encode("10 €", Encoding::Latin1), None);
    }
}
