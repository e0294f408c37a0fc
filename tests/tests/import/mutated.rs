//! Files broken at random: none makes devc panic, or refuse without saying why. `DEVC_MUTATIONS` asks for a longer
//! run, and the seed of what went wrong is in the message.

use devc::import::{Choice, import};

use super::round_trip::compiled;

const DRIVE: &str = include_str!("files/drive.xml");

/// Numbers that look like chance and are the same for the same seed.
struct Dice(u64);

impl Dice {
    fn throw(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % sides.max(1)
    }

    fn one_of<'t>(&mut self, texts: &[&'t str]) -> &'t str {
        texts[self.throw(texts.len())]
    }
}

/// What stands in files where it should not.
const ODD: &[&str] = &[
    "-1",
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
];

/// An element by where it begins and ends, or nothing.
fn element(text: &str, dice: &mut Dice) -> Option<(usize, usize)> {
    let starts: Vec<usize> = text.match_indices('<').map(|(at, _)| at).collect();
    let start = *starts.get(dice.throw(starts.len()))?;
    let rest = &text[start + 1..];
    let name: String = rest.chars().take_while(|char| char.is_alphanumeric()).collect();
    let close = format!("</{name}>");
    let end = start + 1 + rest.find(&close)? + close.len();
    (!name.is_empty()).then_some((start, end))
}

/// The text with one thing changed.
fn mutated(text: &str, dice: &mut Dice) -> String {
    let kind = dice.throw(8);
    let part = element(text, dice);
    match (kind, part) {
        (0, Some((start, end))) => [&text[..start], &text[end..]].concat(),
        (1, Some((start, end))) => [&text[..end], &text[start..]].concat(),
        (2, Some((start, end))) => {
            let deep = dice.throw(80);
            let (open, close) = ("<Sm>".repeat(deep), "</Sm>".repeat(deep));
            [&text[..start], &open, &text[start..end], &close, &text[end..]].concat()
        }
        (3, Some((start, end))) => {
            let other = element(text, dice).map_or("", |(start, end)| &text[start..end]);
            [&text[..start], other, &text[end..]].concat()
        }
        (4, _) => {
            let values: Vec<usize> = text.match_indices(['>', '"']).map(|(at, _)| at + 1).collect();
            let start = values[dice.throw(values.len())];
            let length = text[start..].find(['<', '"']).unwrap_or(0);
            [&text[..start], dice.one_of(ODD), &text[start + length..]].concat()
        }
        (5, _) => {
            let numbers: Vec<usize> = text.match_indices("=\"").map(|(at, _)| at + 2).collect();
            let start = numbers[dice.throw(numbers.len())];
            let filling = dice.one_of(&["9", "x", "&amp;", " ", "é"]);
            [&text[..start], &filling.repeat(dice.throw(20_000)), &text[start..]].concat()
        }
        (6, _) => {
            let end = dice.throw(text.len());
            text.char_indices().filter(|(at, _)| *at < end).map(|(_, char)| char).collect()
        }
        _ => {
            let place = dice.throw(text.chars().count());
            let odd = dice.one_of(ODD);
            let (before, after): (String, String) = {
                let at = text.char_indices().nth(place).map_or(text.len(), |(at, _)| at);
                (text[..at].to_owned(), text[at..].to_owned())
            };
            [before.as_str(), odd, &after].concat()
        }
    }
}

/// The bytes of a text in one of the encodings, or with bytes of none of them.
fn encoded(text: &str, dice: &mut Dice) -> Vec<u8> {
    match dice.throw(8) {
        0 => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        1 => [vec![0xFE, 0xFF], text.encode_utf16().flat_map(u16::to_be_bytes).collect()].concat(),
        2 => text.chars().map(|char| u8::try_from(char).unwrap_or(b'?')).collect(),
        3 => {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=dice.throw(6) {
                let place = dice.throw(bytes.len());
                if let Some(byte) = bytes.get_mut(place) {
                    *byte ^= 1 << dice.throw(8);
                }
            }
            bytes
        }
        _ => text.as_bytes().to_vec(),
    }
}

#[test]
fn what_is_broken_at_random_is_imported_or_refused() {
    let count = std::env::var("DEVC_MUTATIONS").ok().and_then(|count| count.parse().ok()).unwrap_or(60_u64);
    let (mut made, mut refused) = (0, 0);
    for seed in 0..count {
        let mut dice = Dice(seed ^ 0x9E37_79B9_7F4A_7C15);
        let mut text = DRIVE.to_owned();
        for _ in 0..=dice.throw(4) {
            text = mutated(&text, &mut dice);
        }
        let bytes = encoded(&text, &mut dice);
        match import(&bytes, "file.xml", &Choice::default()) {
            Ok(imported) => {
                made += 1;
                // What comes out compiles, whatever it was made of.
                compiled(&imported).unwrap_or_else(|why| panic!("seed {seed}: {why}"));
            }
            Err(refusal) => {
                refused += 1;
                assert!(!refusal.why.is_empty(), "seed {seed}");
                let lines = text.lines().count() + 1;
                let is_inside = |(line, column): (usize, usize)| (1..=lines).contains(&line) && column > 0;
                assert!(refusal.place.is_none_or(is_inside), "seed {seed}: {refusal:?}");
            }
        }
    }
    assert!(made > count / 10 && refused > count / 20, "{made} made and {refused} refused");
}
