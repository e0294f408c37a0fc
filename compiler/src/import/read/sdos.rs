//! A dictionary as `ethercat sdos` of IgH's master prints it: what a device tells of its objects by SDO information.

use super::element::{At, Unread};
use super::esi::{Device, Esi, Flags, Head, Object, Shape, Value};
use super::{basic_types, default_image};

/// What a list says of a device: the device, the number of facts, and the lines that nobody can read.
pub(crate) struct List {
    pub(crate) vendor: Esi,
    pub(crate) device: Device,
    pub(crate) facts: usize,
    pub(crate) unread: Vec<Unread>,
    /// The first entry of which nobody says who may read and write it.
    pub(crate) without_rights: Option<At>,
}

/// Whether a text is such a list: its first line that says something names an object.
pub(crate) fn is_list(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !is_heading(line));
    lines.next().is_some_and(|line| head(line).is_some())
}

/// Above the list of each of several devices, `=== Master 0, Slave 0 ===`.
fn is_heading(line: &str) -> bool {
    line.starts_with("===")
}

/// Reads the list of one device, or says where that of the next one begins.
pub(crate) fn list(text: &str) -> Result<List, (At, String)> {
    let mut objects: Vec<Object> = Vec::new();
    let (mut facts, mut unread, mut without_rights) = (0, Vec::new(), None);
    let mut start = 0;
    for whole in text.split_inclusive('\n') {
        let at = At(start);
        start += whole.len();
        let line = whole.trim();
        if is_heading(line) && !objects.is_empty() {
            return Err((at, "here begins the list of another device; import one at a time".to_owned()));
        }
        if line.is_empty() || is_heading(line) {
            continue;
        }
        if let Some((index, name)) = head(line) {
            objects.push(Object { at, index, name, ..Object::default() });
            facts += 2;
        } else if let Some((index, value)) = entry(line, at)
            && let Some(object) = objects.last_mut().filter(|object| object.index == index)
        {
            if value.flags.access.is_none() {
                without_rights = without_rights.or(Some(at));
            }
            object.values.push(value);
            facts += 5;
        } else {
            facts += 1;
            unread.push(Unread { path: "a line".to_owned(), at, value: line.to_owned(), facts: 1 });
        }
    }
    for object in &mut objects {
        object.shape = if object.values.len() > 1 { Shape::Record } else { Shape::Var };
    }
    let mut device = default_image::device(objects);
    device.mailbox.iter_mut().for_each(|mailbox| mailbox.sdo_info = true);
    device.head = Head::default();
    device.hides_mapping = true;
    Ok(List { vendor: Esi::default(), device, facts, unread, without_rights })
}

/// `SDO 0x1018, "Identity"`.
fn head(line: &str) -> Option<(u16, Option<String>)> {
    let (index, name) = line.strip_prefix("SDO 0x")?.split_once(',')?;
    Some((u16::from_str_radix(index, 16).ok()?, quoted(name)))
}

/// `0x1018:01, r-r-r-, uint32, 32 bit, "Vendor ID"`; the rights are missing in what older masters print.
fn entry(line: &str, at: At) -> Option<(u16, Value)> {
    let (address, rest) = line.strip_prefix("0x")?.split_once(',')?;
    let (index, subindex) = address.split_once(':')?;
    let (said, name) = rest.split_once('"').map_or((rest, None), |(said, name)| (said, Some(name)));
    let parts: Vec<&str> = said.split(',').map(str::trim).filter(|part| !part.is_empty()).collect();
    let (rights, kind, width) = match *parts.as_slice() {
        [rights, kind, width] => (Some(rights), kind, width),
        [kind, width] => (None, kind, width),
        _ => return None,
    };
    let bits: u32 = width.strip_suffix("bit")?.trim().parse().ok()?;
    let name =
        name.and_then(|name| name.strip_suffix('"')).map(str::to_owned).filter(|name| !name.is_empty());
    let value = Value {
        at,
        subindex: u8::from_str_radix(subindex, 16).ok()?,
        name,
        type_name: basic_types::sized(basic_types::of_word(kind), Some(bits)),
        bits: Some(bits),
        flags: rights.map(flags).unwrap_or_default(),
        ..Value::default()
    };
    Some((u16::from_str_radix(index, 16).ok()?, value))
}

fn quoted(text: &str) -> Option<String> {
    let name = text.trim().strip_prefix('"')?.strip_suffix('"')?;
    (!name.is_empty()).then(|| name.to_owned())
}

/// Reading and writing in Pre-Operational, Safe-Operational and Operational, a letter or a line each: `rwrwrw`, `r-r-r-`.
fn flags(rights: &str) -> Flags {
    let letters: Vec<char> = rights.chars().collect();
    let has = |letter: char| letters.contains(&letter);
    let access = match (has('r'), has('w')) {
        (true, true) => "rw",
        (false, true) => "wo",
        _ => "ro",
    };
    let written: Vec<&str> = ["PreOP", "SafeOP", "OP"]
        .into_iter()
        .enumerate()
        .filter(|(state, _)| letters.get(2 * state + 1) == Some(&'w'))
        .map(|(_, name)| name)
        .collect();
    let is_restricted = has('w') && written.len() < 3;
    Flags {
        access: Some(access.to_owned()),
        write_restrictions: is_restricted.then(|| written.join("_")),
        ..Flags::default()
    }
}
