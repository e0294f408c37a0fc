//! Where a fact stands in the reference, by what its place is called in the lists of JSON.

use serde_json::Value;

use super::text::Line;

/// Where a fact stands: the chapter, and the words that stand there.
#[derive(Debug, Default)]
pub(super) struct Place {
    chapters: Vec<&'static str>,
    words: Vec<String>,
}

/// The chapter of each section, and what it calls its things by; nothing for a section that is about the device.
const SECTIONS: &[(&str, &[&str], &str)] = &[
    ("device", &["Device"], ""),
    ("identity", &["Device"], ""),
    ("eeprom", &["Device"], ""),
    ("limits", &["Device"], "name"),
    ("axes", &["Axes"], ""),
    ("modules", &["Axes"], "name"),
    ("slots", &["Axes"], "name"),
    ("leds", &["Connections and lights"], "name"),
    ("connectors", &["Connections and lights"], "name"),
    ("sync-managers", &["Communication"], "number"),
    ("mailbox", &["Communication"], ""),
    ("timeouts", &["Communication"], ""),
    ("communication-states", &["Communication"], "name"),
    ("communication-transitions", &["Communication"], "id"),
    ("al-status-codes", &["Communication"], "name"),
    ("abort-codes", &["Communication"], "name"),
    ("sync-modes", &["Synchronisation"], "name"),
    ("cycle-times", &["Synchronisation"], "name"),
    ("dead-time", &["Synchronisation"], ""),
    ("configurations", &["Start-up configurations"], "name"),
    ("words", &["Words"], "name"),
    ("states", &["Drive states"], "name"),
    ("commands", &["Drive states"], "name"),
    ("transitions", &["Drive states"], "number"),
    ("device-control", &["Drive states", "Modes of operation"], ""),
    ("modes", &["Modes of operation"], "name"),
    ("mode-changes", &["Modes of operation"], ""),
    ("homing-methods", &["Homing methods"], "name"),
    ("stop-options", &["Stopping"], ""),
    ("errors", &["Errors"], "name"),
    ("vendor-codes", &["Errors"], "code"),
    ("diagnosis", &["Errors"], "text"),
    ("units", &["Units and scaling"], "quantity"),
    ("coordinates", &["Numbering of parameters"], ""),
    ("areas", &["Object dictionary"], "name"),
    ("registers", &["Registers and messages"], "name"),
    ("telegrams", &["Registers and messages"], "name"),
    ("master-settings", &["Settings and procedures"], "name"),
    ("parameters", &["Settings and procedures"], "name"),
    ("procedures", &["Settings and procedures"], "name"),
    ("documents", &["Sources"], "title"),
];

impl Place {
    /// The place of what is listed under these words.
    pub(super) fn read(at: &str, member: &Value) -> Self {
        if at.starts_with("0x") {
            return Self::of_index(at, member);
        }
        let (section, _) = at.split_once('.').unwrap_or((at, ""));
        let (_, chapters, called) = SECTIONS
            .iter()
            .find(|(name, ..)| *name == section)
            .unwrap_or_else(|| panic!("no chapter of {at}"));
        let words = match (*called, things(at, member).as_slice()) {
            ("", _) => Vec::new(),
            (called, [thing]) => {
                let word = &thing[called];
                vec![
                    word.as_str()
                        .map_or_else(|| format!("| {}", word.as_i64().unwrap_or_default()), str::to_owned),
                ]
            }
            (_, many) => panic!("{} things at {at}", many.len()),
        };
        Self { chapters: chapters.to_vec(), words }
    }

    /// The place of an object, or of a PDO.
    fn of_index(at: &str, member: &Value) -> Self {
        let (index, subindex, _) = address(at);
        let [thing] = things(at, member)[..] else { panic!("several things at {at}") };
        let leading = format!("0x{:04X}", thing["leading"].as_u64().unwrap());
        if !is_pdo(index) {
            let subindex =
                subindex.filter(|_| thing["kind"] != "var").map(|(first, _)| format!(":{first:02X}"));
            return Self {
                chapters: vec!["Object dictionary"],
                words: [leading].into_iter().chain(subindex).collect(),
            };
        }
        let mapped = subindex.map(|(place, _)| {
            let mapped = &thing["entries"][usize::from(place) - 1];
            mapped["name"].as_str().unwrap().to_owned()
        });
        Self { chapters: vec!["Process data"], words: [leading].into_iter().chain(mapped).collect() }
    }

    /// Whether a line is about what stands here.
    pub(super) fn is_told_by(&self, line: &Line<'_>) -> bool {
        let all = line.all();
        // rows of numbers are told apart by how they begin
        let has = |word: &String| {
            all.contains(word.as_str()) || word.starts_with("| ") && all.contains(&word.replace("| ", "| **"))
        };
        self.chapters.contains(&line.chapter) && self.words.iter().all(has)
    }
}

/// The index, the first and the last subindex, and the key in `0x2054:01..=10.name`.
fn address(at: &str) -> (u64, Option<(u8, u8)>, &str) {
    let hexadecimal = |text: &str| u8::from_str_radix(text, 16).expect("a subindex");
    let index = u64::from_str_radix(&at[2..6], 16).expect("an index");
    let Some(rest) = at[6..].strip_prefix(':') else { return (index, None, at[6..].trim_start_matches('.')) };
    let first = hexadecimal(&rest[..2]);
    match rest[2..].strip_prefix("..=") {
        Some(rest) => (index, Some((first, hexadecimal(&rest[..2]))), rest[2..].trim_start_matches('.')),
        None => (index, Some((first, first)), rest[2..].trim_start_matches('.')),
    }
}

fn is_pdo(index: u64) -> bool {
    matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF)
}

/// The parts of the JSON that a place is about.
pub(super) fn things<'j>(at: &str, member: &'j Value) -> Vec<&'j Value> {
    if at.starts_with("0x") {
        let (index, ..) = address(at);
        let list = if is_pdo(index) { "pdos" } else { "objects" };
        return member[list].as_array().unwrap().iter().filter(|thing| thing["index"] == index).collect();
    }
    let (section, path) = at.split_once('.').unwrap_or((at, ""));
    let part = match section {
        "device" => member,
        "axes" => &member["arrangement"],
        _ => &member[section.replace('-', "_")],
    };
    let Some(items) = part.as_array() else { return vec![part] };
    let key = path.split("..=").next().unwrap_or_default();
    let keys = [path.split('.').next().unwrap_or_default(), key];
    let is_meant = |item: &&Value| {
        let fields = ["id", "code", "number", "first", "address", "text_id", "ident", "letter", "name"];
        fields.iter().any(|field| keys.iter().any(|key| is(&item[field], key)))
    };
    let found: Vec<_> = items.iter().filter(is_meant).collect();
    // the rows of some lists have no name of their own
    let is_row = keys[0].parse::<usize>().is_ok() && !items.iter().any(|item| item["id"].is_string());
    if path.is_empty() || found.is_empty() && is_row { items.iter().collect() } else { found }
}

/// Whether a value is what a key stands for.
fn is(value: &Value, key: &str) -> bool {
    let number = match key.strip_prefix("0x") {
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => key.parse().ok(),
    };
    value.as_str() == Some(key) || value.is_i64() && value.as_i64() == number
}
