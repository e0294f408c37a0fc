//! Edits of a file of XML.

use bolero::TypeGenerator;

/// An edit somewhere in a file.
#[derive(Debug, TypeGenerator)]
pub(crate) enum Edit {
    Remove(u16),
    Double(u16),
    /// An element deep inside others.
    Deep(u16, u8),
    /// An element becomes another of the same file.
    Exchange(u16, u16),
    /// A text or an attribute has another value.
    Value(u16, Odd),
    /// A text or an attribute is long.
    Long(u16, u8, u16),
    /// A name is another name of the same file.
    Name(u16, u16),
    End(u16),
    Insert(u16, Odd),
}

/// What stands in files where it should not, or a number.
#[derive(Debug, TypeGenerator)]
pub(crate) enum Odd {
    Number(i32),
    Hex(u32),
    Text(u8),
}

const ODD: &[&str] = &[
    "#xFFFFFFFFFFFFFFFFFF",
    "4294967296",
    "#x",
    "1e309",
    "NaN",
    "&lol;",
    "&#0;",
    "&#x10FFFF;",
    "\u{202E}",
    "\u{0}",
    "]]>",
    "<![CDATA[",
    "<!--",
    "\"'",
    "{}",
    "..=",
    "0x6040:00",
    "true",
    "",
    "DINT",
    "ARRAY [0..4000000000] OF BYTE",
    "STRING(99999)",
    "<?xml version=\"1.1\"?>",
    "<a b='c'/>",
];

/// Fillings of what is long.
const LONG: &[&str] = &["9", "x", "&amp;", " ", "é"];

impl Odd {
    fn text(&self) -> String {
        match self {
            Self::Number(number) => number.to_string(),
            Self::Hex(number) => format!("#x{number:X}"),
            Self::Text(text) => ODD[usize::from(*text) % ODD.len()].to_owned(),
        }
    }
}

/// The text after these edits.
pub(crate) fn edited(text: &str, edits: &[Edit]) -> String {
    edits.iter().fold(text.to_owned(), |text, edit| edit.apply(&text).unwrap_or(text))
}

/// The bytes of a text in one of the encodings, or with bytes of none of them.
pub(crate) fn encoded(text: &str, encoding: u8) -> Vec<u8> {
    match encoding % 16 {
        0 => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        1 => [vec![0xFE, 0xFF], text.encode_utf16().flat_map(u16::to_be_bytes).collect()].concat(),
        2 => text.chars().map(|char| u8::try_from(char).unwrap_or(b'?')).collect(),
        3 => [&[0xEF, 0xBB, 0xBF], text.as_bytes()].concat(),
        4 => {
            let mut bytes = text.as_bytes().to_vec();
            bytes.iter_mut().step_by(997).for_each(|byte| *byte ^= encoding);
            bytes
        }
        _ => text.as_bytes().to_vec(),
    }
}

impl Edit {
    fn apply(&self, text: &str) -> Option<String> {
        let put = |start: usize, what: &str, end: usize| Some([&text[..start], what, &text[end..]].concat());
        match self {
            Self::Remove(number) => {
                let (start, end) = element(text, *number)?;
                put(start, "", end)
            }
            Self::Double(number) => {
                let (start, end) = element(text, *number)?;
                put(end, &text[start..end], end)
            }
            Self::Deep(number, depth) => {
                let (start, end) = element(text, *number)?;
                let (open, close) = ("<Sm>".repeat((*depth).into()), "</Sm>".repeat((*depth).into()));
                put(start, &[&open, &text[start..end], &close].concat(), end)
            }
            Self::Exchange(number, other) => {
                let ((start, end), (from, to)) = (element(text, *number)?, element(text, *other)?);
                put(start, &text[from..to], end)
            }
            Self::Value(number, odd) => {
                let (start, end) = value(text, *number)?;
                put(start, &odd.text(), end)
            }
            Self::Long(number, filling, count) => {
                let (start, _) = value(text, *number)?;
                put(start, &LONG[usize::from(*filling) % LONG.len()].repeat((*count).into()), start)
            }
            Self::Name(number, other) => {
                let ((start, end), (from, to)) = (name(text, *number)?, name(text, *other)?);
                let rest = text[end..].replacen(
                    &format!("</{}>", &text[start..end]),
                    &format!("</{}>", &text[from..to]),
                    1,
                );
                Some([&text[..start], &text[from..to], &rest].concat())
            }
            Self::End(place) => Some(text[..any(text, *place)].to_owned()),
            Self::Insert(place, odd) => put(any(text, *place), &odd.text(), any(text, *place)),
        }
    }
}

/// Any place between two characters.
fn any(text: &str, place: u16) -> usize {
    let start = usize::from(place) * text.len() / usize::from(u16::MAX);
    (start..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len())
}

/// One of so many places that are found.
fn one(mut places: impl Iterator<Item = usize> + Clone, number: u16) -> Option<usize> {
    let count = places.clone().count();
    places.nth(usize::from(number) % count.max(1))
}

/// Where the name of an element begins and ends.
fn name(text: &str, number: u16) -> Option<(usize, usize)> {
    let starts = text.match_indices('<').map(|(at, _)| at + 1);
    let start = one(starts.filter(|at| text[*at..].starts_with(char::is_alphabetic)), number)?;
    let length = text[start..].find(|char: char| !char.is_alphanumeric())?;
    Some((start, start + length))
}

/// Where an element begins and ends.
fn element(text: &str, number: u16) -> Option<(usize, usize)> {
    let (start, end) = name(text, number)?;
    let close = format!("</{}>", &text[start..end]);
    let rest = text[end..].find(&close)?;
    Some((start - 1, end + rest + close.len()))
}

/// Where a text or an attribute begins and ends.
fn value(text: &str, number: u16) -> Option<(usize, usize)> {
    let start = one(text.match_indices(['>', '"']).map(|(at, _)| at + 1), number)?;
    let length = text[start..].find(['<', '"']).unwrap_or(0);
    Some((start, start + length))
}
