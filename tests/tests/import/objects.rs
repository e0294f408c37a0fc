//! The facts of the dictionary: types and objects brought together.

use std::collections::BTreeMap;

use super::facts::{Collector, Lines, Node, all, content, find, lines, name, number, text_in};
use super::texts::in_languages;

type Types<'a, 'd> = BTreeMap<String, Node<'a, 'd>>;

pub(crate) fn dictionary(device: Node<'_, '_>, facts: &mut Collector) {
    for profile in all(device, "Profile") {
        let Some(dictionary) = find(profile, "Dictionary") else { continue };
        let mut types = Types::new();
        for node in find(dictionary, "DataTypes").into_iter().flat_map(|it| all(it, "DataType")) {
            types.entry(text_in(node, "Name").unwrap_or_default()).or_insert(node);
        }
        for node in find(dictionary, "Objects").into_iter().flat_map(|it| all(it, "Object")) {
            object(node, &types, facts);
        }
    }
}

fn object(node: Node<'_, '_>, types: &Types<'_, '_>, facts: &mut Collector) {
    let Some(index) = text_in(node, "Index").and_then(|it| number(&it)) else { return };
    if facts.facts.contains_key(&format!("object/{index:04X}:00/access")) {
        return;
    }
    let type_name = text_in(node, "Type").unwrap_or_default();
    let declared = types.get(&type_name).copied();
    let mut at = vec![lines(node)];
    at.extend(declared.map(lines));
    facts.text(&format!("object/{index:04X}/name"), name(node, "Name"), &at);
    in_languages(node, "Name", &format!("object/{index:04X}/name"), facts);
    let flags = find(node, "Flags");
    let items: Vec<Node<'_, '_>> = declared.into_iter().flat_map(|it| all(it, "SubItem")).collect();
    if items.is_empty() {
        let bits = text_in(node, "BitSize");
        return value(
            &format!("object/{index:04X}:00"),
            (&type_name, bits),
            (flags, find(node, "Info")),
            types,
            &at,
            facts,
        );
    }
    let mut places: Vec<Member<'_, '_>> = Vec::new();
    for item in items {
        let kind = text_in(item, "Type").unwrap_or_default();
        let own = find(item, "Flags").or(flags);
        let array = types.get(&kind).and_then(|it| Some((*it, find(*it, "ArrayInfo")?)));
        match (text_in(item, "SubIdx").and_then(|it| number(&it)), array) {
            (None, Some((array, info))) => {
                at.push(lines(array));
                let part = |tag| text_in(info, tag).and_then(|it| number(&it));
                let (first, count) = (part("LBound").unwrap_or(1), part("Elements").unwrap_or(0));
                let base = text_in(array, "BaseType").unwrap_or_default();
                places.extend((first..first + count.min(255)).map(|it| (it, None, base.clone(), None, own)));
            }
            (subindex, _) => {
                let subindex = subindex.unwrap_or(places.len() as i64);
                in_languages(item, "DisplayName", &format!("object/{index:04X}:{subindex:02X}/name"), facts);
                places.push((subindex, name(item, "Name"), kind, text_in(item, "BitSize"), own));
            }
        }
    }
    let parts: Vec<Node<'_, '_>> = find(node, "Info").into_iter().flat_map(|it| all(it, "SubItem")).collect();
    let names: Vec<Option<String>> = parts.iter().map(|part| name(*part, "Name")).collect();
    let members: Vec<&Option<String>> = places.iter().map(|place| &place.1).collect();
    let unique = members.iter().enumerate().all(|(i, it)| it.is_some() && !members[..i].contains(it));
    let by_name = unique && names.iter().all(|name| members.contains(&name));
    let mut seen = Vec::new();
    for (order, (subindex, own_name, kind, bits, flags)) in places.iter().enumerate() {
        if seen.contains(subindex) {
            continue;
        }
        seen.push(*subindex);
        let place = if by_name { names.iter().position(|name| name == own_name) } else { Some(order) };
        let part = place.and_then(|place| parts.get(place)).and_then(|part| find(*part, "Info"));
        let key = format!("object/{index:04X}:{subindex:02X}");
        value(&key, (kind, bits.clone()), (*flags, part), types, &at, facts);
        let said = own_name.clone().or_else(|| place.and_then(|place| names.get(place).cloned().flatten()));
        let derived = matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1C13);
        let says = |name: &String| !name.to_lowercase().starts_with("subindex") && name != "Elements";
        if *subindex > 0 && !derived {
            facts.text(&format!("{key}/name"), said.filter(says), &at);
        }
    }
}

/// A value of an object: its subindex, name, type, width and flags.
type Member<'a, 'i> = (i64, Option<String>, String, Option<String>, Option<Node<'a, 'i>>);

fn value(
    key: &str,
    (kind, own_bits): (&str, Option<String>),
    (flags, info): (Option<Node<'_, '_>>, Option<Node<'_, '_>>),
    types: &Types<'_, '_>,
    at: &[Lines],
    facts: &mut Collector,
) {
    let declared = types.get(kind).copied();
    let declared_bits = declared.and_then(|it| text_in(it, "BitSize"));
    let bits = own_bits.or(declared_bits).and_then(|it| number(&it)).filter(|bits| *bits > 0);
    // An array without a subindex for each element is one value.
    let single = declared.filter(|it| find(*it, "ArrayInfo").is_none());
    let base = single.and_then(|it| text_in(it, "BaseType")).filter(|it| !it.is_empty());
    let count = key.ends_with(":00") && !key.contains("/6");
    facts.text(&format!("{key}/bits"), bits.map(|bits| bits.to_string()), at);
    let kind = canonical(base.as_deref().unwrap_or(kind), bits);
    facts.text(&format!("{key}/type"), Some(kind.clone()), at);
    let flag = |tag| flags.and_then(|it| text_in(it, tag)).filter(|it| !it.is_empty());
    facts.text(&format!("{key}/access"), Some(flag("Access").unwrap_or("ro".to_owned()).to_lowercase()), at);
    let mut mapping: Vec<char> = flag("PdoMapping").unwrap_or_default().to_lowercase().chars().collect();
    mapping.sort_unstable();
    facts.text(&format!("{key}/mapping"), Some(mapping.into_iter().collect()), at);
    if !count && !key.ends_with(":00") {
        facts.text(&format!("{key}/category"), flag("Category").map(|it| it.to_lowercase()), at);
    }
    let restriction =
        flags.and_then(|it| find(it, "Access")).and_then(|it| it.attribute("WriteRestrictions"));
    facts.text(&format!("{key}/written"), restriction.map(str::to_lowercase), at);
    for kept in ["Backup", "Setting"] {
        let is_so = matches!(flag(kept).as_deref(), Some("1" | "true"));
        facts.text(&format!("{key}/{}", kept.to_lowercase()), is_so.then(String::new), at);
    }
    for what in ["Default", "Min", "Max"] {
        let bytes = info.and_then(|info| bytes(info, what, &kind, bits));
        // A limit that the type has anyway says nothing.
        let bytes = bytes.filter(|bytes| !is_bound(what, bytes, &kind));
        facts.text(&format!("{key}/{}", what.to_lowercase()), bytes, at);
    }
    facts.number(&format!("{key}/unit"), info.and_then(|info| text_in(info, "Unit")), at);
    let choices = declared.into_iter().flat_map(|it| all(it, "EnumInfo"));
    let choices: Vec<_> =
        choices.filter_map(|it| Some((number(&text_in(it, "Enum")?)?, name(it, "Text")?, it))).collect();
    if choices.len() > 1 {
        for (number, name, node) in choices {
            facts.text(&format!("{key}/choice/{number}"), Some(name), at);
            in_languages(node, "Text", &format!("{key}/choice/{number}"), facts);
        }
    }
}

/// Whether a limit is the least or the greatest value of an integer type.
fn is_bound(what: &str, bytes: &str, kind: &str) -> bool {
    let (signed, width) = match kind {
        "SINT" => (true, 1),
        "INT" => (true, 2),
        "DINT" => (true, 4),
        "LINT" => (true, 8),
        "USINT" | "BYTE" => (false, 1),
        "UINT" | "WORD" => (false, 2),
        "UDINT" | "DWORD" => (false, 4),
        "ULINT" => (false, 8),
        "BOOL" => return what == "Min" && bytes.is_empty() || what == "Max" && bytes == "01",
        _ => match kind.strip_prefix("BIT").and_then(|bits| bits.parse::<u32>().ok()) {
            Some(bits @ 1..=8) if what == "Max" => return bytes == format!("{:02X}", (1_u32 << bits) - 1),
            Some(1..=8) => return what == "Min" && bytes.is_empty(),
            _ => return false,
        },
    };
    let (least, greatest) = if signed { ("80", "7F") } else { ("", "FF") };
    match what {
        "Min" if !signed => bytes.is_empty(),
        "Min" => bytes == "00".repeat(width - 1) + least,
        "Max" => bytes == "FF".repeat(width - 1) + greatest,
        _ => false,
    }
}

/// A value as little-endian bytes without the zeros at its end.
fn bytes(info: Node<'_, '_>, what: &str, kind: &str, bits: Option<i64>) -> Option<String> {
    let trimmed = |hex: String| {
        let mut hex = hex.to_uppercase();
        while hex.ends_with("00") && hex.len().is_multiple_of(2) {
            hex.truncate(hex.len() - 2);
        }
        hex
    };
    if let Some(data) = text_in(info, &format!("{what}Data")) {
        return Some(data).filter(|it| !it.is_empty()).map(trimmed);
    }
    let hex = |bytes: &[u8]| trimmed(bytes.iter().map(|byte| format!("{byte:02X}")).collect());
    if let Some(node) = find(info, &format!("{what}String")) {
        return Some(hex(content(node).as_bytes()));
    }
    let text = text_in(info, &format!("{what}Value")).filter(|it| !it.is_empty())?;
    let Some(value) = number(&text) else { return Some(format!("not a number: {text}")) };
    if kind == "REAL" && value.abs() <= 1 << 24 {
        return Some(hex(&(value as f32).to_le_bytes()));
    }
    let width = usize::try_from(bits.unwrap_or(64) + 7).unwrap_or(64) / 8;
    Some(hex(&value.to_le_bytes()[..width.min(8)]))
}

/// The one name of a basic type.
pub(crate) fn canonical(name: &str, bits: Option<i64>) -> String {
    let upper = name.trim().to_uppercase();
    let known = match upper.as_str() {
        "BOOLEAN" | "BIT" => "BOOL",
        "INT8" => "SINT",
        "INT16" => "INT",
        "INT32" => "DINT",
        "INT64" => "LINT",
        "UINT8" => "USINT",
        "UINT16" => "UINT",
        "UINT32" => "UDINT",
        "UINT64" => "ULINT",
        "REAL32" => "REAL",
        "REAL64" => "LREAL",
        // An enumeration of some bits is based on bytes by its name.
        "USINT" if bits.is_some_and(|bits| bits < 8) => return format!("BIT{}", bits.unwrap_or(0)),
        _ if upper.starts_with("ARRAY") => return upper.split_whitespace().collect::<Vec<_>>().join(" "),
        _ if upper.starts_with("STRING") || upper.starts_with("VISIBLE_STRING") => "STRING",
        _ => upper.as_str(),
    };
    known.to_owned()
}
