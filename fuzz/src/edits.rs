//! Edits of a description: such as people make, and such as nobody would.

use bolero::TypeGenerator;
use bolero::generator::{ValueGenerator, produce};

use crate::subjects::{Files, WORDS, subject};

/// An edit somewhere in a file.
#[derive(Debug, Clone, TypeGenerator)]
pub(crate) struct Edit {
    file: u8,
    line: u16,
    what: What,
}

#[derive(Debug, Clone, TypeGenerator)]
enum What {
    Remove,
    Double,
    Swap,
    /// A line ends early.
    Cut(u8),
    /// A file ends here.
    End,
    /// What stands behind the equals sign is something else.
    Value(Text),
    /// A word becomes another.
    Word(u8, Text),
    /// Something stands in the middle of a line.
    Insert(u8, Text),
    /// A line as others begin.
    Line(Text, Text),
    /// Lines of another description.
    Splice {
        from: u16,
        line: u16,
        count: u8,
    },
    Lay(Layout),
}

/// Some edits: more than a few leave nothing that goes beyond the parser.
pub(crate) fn few() -> impl ValueGenerator<Output = Vec<Edit>> {
    produce::<Vec<Edit>>().with().len(0_usize..=5)
}

/// An edit that changes how a description is written, and not what it says.
#[derive(Debug, Clone, TypeGenerator)]
pub(crate) enum Layout {
    Blank,
    Comment,
    Indent,
    Close,
    Behind,
    Small,
    Broken,
    Spread,
}

/// A word of some description, or what stands in none.
#[derive(Debug, Clone, TypeGenerator)]
enum Text {
    Known(u16),
    Number(i64),
    Odd(u8),
}

const ODD: &[&str] = &[
    "0",
    "-1",
    "0xFFFF",
    "0x1_0000",
    "0xFFFFFFFF",
    "18446744073709551615",
    "340282366920938463463374607431768211456",
    "-0.0",
    "1e400",
    "nan",
    "true",
    "\"\"",
    "[]",
    "[[]]",
    "{}",
    "{ a.b = 1 }",
    "[\"0x6040\", 1]",
    "\"0x2000..=0xFFFF\"",
    "\"1..=0\"",
    "\"0x6040:00\"",
    "\"\"\"\n\"\"\"",
    "'''",
    "1979-05-27",
    "\"\\u202E\"",
    "\"\\U0010FFFF\"",
    "\u{1B}[31m",
    "é\u{301}",
    "\"|`*<&>\\\\ {} %s\"",
    "\"..\"",
    "include = [\"device.toml\"]",
    "=",
    "]",
    "[",
    "\"",
    "#",
    "\r",
];

impl Text {
    fn text(&self) -> String {
        match self {
            Self::Known(word) => WORDS[usize::from(*word) % WORDS.len()].to_owned(),
            Self::Number(number) => number.to_string(),
            Self::Odd(odd) => ODD[usize::from(*odd) % ODD.len()].to_owned(),
        }
    }
}

/// The files after these edits.
pub(crate) fn edited(files: &Files, edits: &[Edit]) -> Files {
    let mut files = files.clone();
    for edit in edits {
        let number = usize::from(edit.file) % files.len();
        let text = files.values_mut().nth(number).expect("a file");
        let mut lines: Vec<String> = text.split('\n').map(str::to_owned).collect();
        let line = usize::from(edit.line) % lines.len();
        edit.what.apply(&mut lines, line);
        *text = lines.join("\n");
    }
    files
}

/// The files after changes of their layout alone.
pub(crate) fn laid(files: &Files, edits: &[(u8, u16, Layout)]) -> Files {
    let edit = |(file, line, layout): &(u8, u16, Layout)| Edit {
        file: *file,
        line: *line,
        what: What::Lay(layout.clone()),
    };
    edited(files, &edits.iter().map(edit).collect::<Vec<_>>())
}

impl What {
    fn apply(&self, lines: &mut Vec<String>, line: usize) {
        let next = (line + 1) % lines.len();
        match self {
            Self::Remove if lines.len() > 1 => _ = lines.remove(line),
            Self::Remove => lines[line].clear(),
            Self::Double => lines.insert(line, lines[line].clone()),
            Self::Swap => lines.swap(line, next),
            Self::Cut(at) => {
                let at = place(&lines[line], *at);
                lines[line].truncate(at);
            }
            Self::End => lines.truncate(line + 1),
            Self::Value(text) => {
                if let Some((key, _)) = lines[line].split_once('=') {
                    lines[line] = format!("{key}= {}", text.text());
                }
            }
            Self::Word(word, text) => lines[line] = with_word(&lines[line], *word, &text.text()),
            Self::Insert(at, text) => {
                let at = place(&lines[line], *at);
                lines[line].insert_str(at, &text.text());
            }
            Self::Line(key, value) => lines.insert(line, format!("{} = {}", key.text(), value.text())),
            Self::Splice { from, line: first, count } => {
                let texts: Vec<&str> = subject(*from).values().flat_map(|text| text.lines()).collect();
                let first = usize::from(*first) % texts.len().max(1);
                let some = texts.iter().skip(first).take(usize::from(*count % 32));
                let some: Vec<String> = some.map(|line| (*line).to_owned()).collect();
                lines.splice(line..line, some);
            }
            Self::Lay(layout) => layout.apply(lines, line),
        }
    }
}

impl Layout {
    fn apply(&self, lines: &mut Vec<String>, line: usize) {
        match self {
            Self::Blank => lines.insert(line, String::new()),
            Self::Comment => lines.insert(line, "   # a comment = 1".to_owned()),
            Self::Indent => lines[line].insert_str(0, "\t  "),
            Self::Close => lines[line] = lines[line].replacen(" = ", "=", 1),
            Self::Behind => lines[line].push_str("   # behind"),
            Self::Small => lines[line] = small(&lines[line]),
            Self::Broken => lines[line] = lines[line].replace(", ", ",\n  "),
            Self::Spread => {
                let spread = lines[line].replace("{ ", "{").replace("[\"", "[\n\n# x\n\"");
                lines[line] = spread.replace("\"]", "\" , ]");
            }
        }
    }
}

/// A byte of a line at which a character begins.
fn place(line: &str, at: u8) -> usize {
    let places: Vec<usize> = line.char_indices().map(|(at, _)| at).chain([line.len()]).collect();
    places[usize::from(at) % places.len()]
}

/// A line with one of its words exchanged.
fn with_word(line: &str, number: u8, word: &str) -> String {
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
    let mut words: Vec<(usize, usize)> = Vec::new();
    for (at, c) in line.char_indices().filter(|(_, c)| is_part(*c)) {
        match words.last_mut() {
            Some((_, end)) if *end == at => *end = at + c.len_utf8(),
            _ => words.push((at, at + c.len_utf8())),
        }
    }
    let Some((start, end)) = words.get(usize::from(number) % words.len().max(1)) else {
        return line.to_owned();
    };
    [&line[..*start], word, &line[*end..]].concat()
}

/// A line with its hexadecimal numbers in small letters.
fn small(line: &str) -> String {
    let parts = line.split("0x").enumerate();
    let lower = parts.map(|(number, part)| {
        let digits = part.len() - part.trim_start_matches(|c: char| c.is_ascii_hexdigit()).len();
        let (digits, rest) = part.split_at(if number == 0 { 0 } else { digits });
        digits.to_lowercase() + rest
    });
    lower.collect::<Vec<_>>().join("0x")
}
