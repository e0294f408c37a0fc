//! What an ESI file says of a device, as facts that can be compared one by one. It reads what files in use have: any
//! order, missing elements, numbers in several spellings.

use std::collections::BTreeMap;

pub(crate) use roxmltree::Node;

use super::texts::{in_languages, messages};

/// Lines of the file, the first and the last.
pub(crate) type Lines = (usize, usize);

/// A fact with the parts of the file that it is in.
#[derive(Debug, Clone)]
pub(crate) struct Fact {
    pub(crate) value: String,
    pub(crate) lines: Vec<Lines>,
}

pub(crate) type Facts = BTreeMap<String, Fact>;

/// The text of a file; one that is not UTF-8 is ISO-8859-1.
pub(crate) fn text(bytes: &[u8]) -> String {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    String::from_utf8(bytes.to_vec()).unwrap_or_else(|_| bytes.iter().map(|byte| char::from(*byte)).collect())
}

/// The elements of the devices.
pub(crate) fn devices<'a, 'd>(document: &'a roxmltree::Document<'d>) -> Vec<Node<'a, 'd>> {
    let devices = find(document.root_element(), "Descriptions").and_then(|it| find(it, "Devices"));
    devices.map(|devices| all(devices, "Device").collect()).unwrap_or_default()
}

/// All facts of a device.
pub(crate) fn of(device: Node<'_, '_>) -> Facts {
    let mut facts = Collector { facts: Facts::new() };
    let whole = vec![lines(device)];
    let vendor = find(device.document().root_element(), "Vendor").expect("a vendor");
    facts.number("vendor", text_in(vendor, "Id"), &whole);
    facts.text("name", name(device, "Name"), &whole);
    let kind = find(device, "Type").expect("a type");
    in_languages(device, "Name", "name", &mut facts);
    facts.text("url", name(device, "URL"), &whole);
    in_languages(device, "URL", "url", &mut facts);
    let electrical = find(device, "Info").and_then(|it| find(it, "Electrical"));
    facts.number("e-bus", electrical.and_then(|it| text_in(it, "EBusCurrent")), &whole);
    for said in ["IdentificationAdo", "IdentificationReg134"] {
        facts.text(said, find(device, "Info").and_then(|it| text_in(it, said)), &whole);
    }
    facts.text("UseLrdLwr", kind.attribute("UseLrdLwr").map(str::to_owned), &whole);
    facts.text("type", Some(content(kind)), &whole);
    facts.number("product", kind.attribute("ProductCode").map(str::to_owned), &whole);
    facts.number("revision", kind.attribute("RevisionNo").map(str::to_owned), &whole);
    facts.text("physics", device.attribute("Physics").map(|it| it.trim().to_owned()), &whole);
    let picture = text_in(device, "ImageData16x14").filter(|it| !it.is_empty());
    facts.text("picture", picture.map(|it| it.to_uppercase()), &whole);
    facts.text("group", text_in(device, "GroupType").filter(|it| !it.is_empty()), &whole);
    if let Some(profile) = find(device, "Profile") {
        facts.number("profile", text_in(profile, "ProfileNo"), &whole);
    }
    for hidden in all(device, "HideType") {
        let revision = hidden.attribute("RevisionNo").and_then(number);
        let key = format!("replaces/{}", revision.unwrap_or_default());
        facts.text(&key, revision.map(|_| String::new()), &[lines(hidden)]);
    }
    timeouts(device, &mut facts);
    sync_managers(device, &mut facts);
    sync_units(device, &mut facts);
    for (tag, way) in [("RxPdo", "rx"), ("TxPdo", "tx")] {
        all(device, tag).for_each(|node| pdo(node, way, &mut facts));
    }
    mailbox(device, &mut facts);
    clocks(device, &mut facts);
    if let Some(eeprom) = find(device, "Eeprom") {
        let at = vec![lines(eeprom)];
        facts.number("eeprom/size", text_in(eeprom, "ByteSize"), &at);
        let config = text_in(eeprom, "ConfigData").map(|it| it.to_uppercase());
        facts.text("eeprom/config", config.filter(|it| !it.is_empty()), &at);
        let boot = text_in(eeprom, "BootStrap").map(|it| it.to_uppercase());
        facts.text("eeprom/bootstrap", boot.filter(|it| !it.is_empty()), &at);
    }
    super::objects::dictionary(device, &mut facts);
    messages(device, &mut facts);
    facts.facts
}

pub(crate) struct Collector {
    pub(crate) facts: Facts,
}

impl Collector {
    pub(crate) fn text(&mut self, key: &str, value: Option<String>, lines: &[Lines]) {
        if let Some(value) = value {
            let fact = Fact { value, lines: lines.to_vec() };
            // Of two of one name the first counts.
            self.facts.entry(key.to_owned()).or_insert(fact);
        }
    }

    pub(crate) fn number(&mut self, key: &str, value: Option<String>, lines: &[Lines]) {
        let value = value.filter(|value| !value.is_empty());
        let value = value.map(|text| number(&text).map_or(text, |number| number.to_string()));
        self.text(key, value, lines);
    }
}

/// How long a master waits, in milliseconds.
fn timeouts(device: Node<'_, '_>, facts: &mut Collector) {
    for part in ["StateMachine", "Mailbox"] {
        let timeout = find(device, "Info").and_then(|it| find(it, part)).and_then(|it| find(it, "Timeout"));
        for node in timeout.into_iter().flat_map(|it| it.children()).filter(Node::is_element) {
            let key = format!("timeout/{}", node.tag_name().name());
            facts.number(&key, Some(content(node)), &[lines(node)]);
        }
    }
}

/// Which PDOs are of one sync unit; its number says nothing else.
fn sync_units(device: Node<'_, '_>, facts: &mut Collector) {
    let mut first: BTreeMap<i64, String> = BTreeMap::new();
    for tag in ["RxPdo", "TxPdo"] {
        let mut pdos: Vec<(i64, i64, Node<'_, '_>)> = Vec::new();
        for node in all(device, tag) {
            let index = text_in(node, "Index").and_then(|it| number(&it)).unwrap_or(0);
            pdos.extend(node.attribute("Su").and_then(number).map(|unit| (index, unit, node)));
        }
        pdos.sort_by_key(|(index, ..)| *index);
        for (index, unit, node) in pdos {
            let of = first.entry(unit).or_insert_with(|| format!("{tag} {index:04X}")).clone();
            facts.text(&format!("pdo/{tag}/{index:04X}/unit"), Some(of), &[lines(node)]);
        }
    }
}

fn sync_managers(device: Node<'_, '_>, facts: &mut Collector) {
    for (place, node) in all(device, "Fmmu").enumerate() {
        facts.number(&format!("fmmu/{place}/su"), node.attribute("Su").map(str::to_owned), &[lines(node)]);
    }
    for (place, node) in all(device, "Sm").enumerate() {
        let at = vec![lines(node)];
        facts.text(
            &format!("sm/{place}/role"),
            Some(content(node).to_lowercase()).filter(|it| !it.is_empty()),
            &at,
        );
        for attribute in ["StartAddress", "ControlByte", "MinSize", "MaxSize", "DefaultSize"] {
            let value = node.attribute(attribute).map(str::to_owned);
            facts.number(&format!("sm/{place}/{attribute}"), value, &at);
        }
        let enable = node.attribute("Enable").map(|it| (number(it).unwrap_or(1) & 1).to_string());
        facts.text(&format!("sm/{place}/Enable"), enable, &at);
        let op_only = truth(node.attribute("OpOnly"));
        facts.text(&format!("sm/{place}/OpOnly"), op_only.then(String::new), &at);
    }
}

fn pdo(node: Node<'_, '_>, way: &str, facts: &mut Collector) {
    let at = vec![lines(node)];
    let Some(index) = text_in(node, "Index").and_then(|it| number(&it)) else { return };
    let key = format!("pdo/{way}/{index:04X}");
    if facts.facts.contains_key(&format!("{key}/fixed")) {
        return;
    }
    facts.text(&format!("{key}/name"), name(node, "Name"), &at);
    in_languages(node, "Name", &format!("{key}/name"), facts);
    for attribute in ["Fixed", "Mandatory"] {
        let value = truth(node.attribute(attribute)).to_string();
        facts.text(&format!("{key}/{}", attribute.to_lowercase()), Some(value), &at);
    }
    facts.number(&format!("{key}/sm"), node.attribute("Sm").map(str::to_owned), &at);
    for exclude in all(node, "Exclude") {
        let index = number(&content(exclude)).unwrap_or(0);
        facts.text(&format!("{key}/exclude/{index:04X}"), Some(String::new()), &at);
    }
    for (place, entry) in all(node, "Entry").enumerate() {
        let part = |tag| text_in(entry, tag).and_then(|it| number(&it)).unwrap_or(0);
        let (index, subindex, bits) = (part("Index"), part("SubIndex"), part("BitLen"));
        let subindex = if index == 0 { 0 } else { subindex };
        let key = format!("{key}/entry/{place}");
        facts.text(&key, Some(format!("{index:04X}:{subindex:02X} {bits}")), &at);
        if index > 0 {
            facts.text(&format!("{key}/name"), name(entry, "Name"), &at);
            in_languages(entry, "Name", &format!("{key}/name"), facts);
            let kind = text_in(entry, "DataType").filter(|it| !it.is_empty());
            facts.text(
                &format!("{key}/type"),
                kind.map(|it| super::objects::canonical(&it, Some(bits))),
                &at,
            );
        }
    }
}

fn mailbox(device: Node<'_, '_>, facts: &mut Collector) {
    let Some(mailbox) = find(device, "Mailbox") else { return };
    let at = vec![lines(mailbox)];
    for protocol in mailbox.children().filter(Node::is_element) {
        let tag = protocol.tag_name().name();
        facts.text(&format!("mailbox/{tag}"), Some(String::new()), &at);
        if tag == "CoE" {
            for flag in ["SdoInfo", "PdoAssign", "PdoConfig", "CompleteAccess", "SegmentedSdo"] {
                let value = truth(protocol.attribute(flag)).to_string();
                facts.text(&format!("mailbox/CoE/{flag}"), Some(value), &at);
            }
        }
        if tag == "EoE" {
            for flag in ["IP", "MAC"] {
                let value = protocol.attribute(flag).map(|it| truth(Some(it)).to_string());
                facts.text(&format!("mailbox/EoE/{flag}"), value, &at);
            }
        }
        for command in all(protocol, "InitCmd") {
            let part = |tag| text_in(command, tag).and_then(|it| number(&it)).unwrap_or(0);
            let (index, subindex) = (part("Index"), part("SubIndex"));
            for transition in all(command, "Transition") {
                let key = format!("mailbox/command/{index:04X}:{subindex:02X}/{}", content(transition));
                facts.text(&key, text_in(command, "Data").map(|it| it.to_uppercase()), &[lines(command)]);
            }
        }
    }
}

fn clocks(device: Node<'_, '_>, facts: &mut Collector) {
    let modes: Vec<Node<'_, '_>> = find(device, "Dc").into_iter().flat_map(|dc| all(dc, "OpMode")).collect();
    for (place, mode) in modes.iter().enumerate() {
        let at = vec![lines(*mode)];
        let name = text_in(*mode, "Name").unwrap_or_default();
        facts.text(&format!("dc/{name}/place"), Some(place.to_string()), &at);
        facts.number(&format!("dc/{name}/activate"), text_in(*mode, "AssignActivate"), &at);
        for signal in ["Sync0", "Sync1"] {
            let cycle = find(*mode, &format!("CycleTime{signal}"));
            let factor = cycle.and_then(|it| it.attribute("Factor")).map(str::to_owned);
            facts.number(&format!("dc/{name}/{signal}/factor"), factor, &at);
            facts.number(&format!("dc/{name}/{signal}/cycle"), cycle.map(content), &at);
            let shift = find(*mode, &format!("ShiftTime{signal}"));
            facts.number(&format!("dc/{name}/{signal}/shift"), shift.map(content), &at);
            let factor = shift.and_then(|it| it.attribute("Factor")).and_then(number).filter(|it| *it != 0);
            facts.text(&format!("dc/{name}/{signal}/shift factor"), factor.map(|it| it.to_string()), &at);
            let of_inputs = truth(shift.and_then(|it| it.attribute("Input")));
            facts.text(&format!("dc/{name}/{signal}/inputs"), of_inputs.then(String::new), &at);
        }
    }
}

pub(crate) fn all<'a, 'd: 'a>(
    node: Node<'a, 'd>,
    tag: &'a str,
) -> impl Iterator<Item = Node<'a, 'd>> + use<'a, 'd> {
    node.children().filter(move |child| child.has_tag_name(tag))
}

pub(crate) fn find<'a, 'd: 'a>(node: Node<'a, 'd>, tag: &str) -> Option<Node<'a, 'd>> {
    node.children().find(|child| child.has_tag_name(tag))
}

/// The text in an element, in as many pieces as it comes.
pub(crate) fn content(node: Node<'_, '_>) -> String {
    let pieces = node.children().filter(Node::is_text).filter_map(|piece| piece.text());
    pieces.collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

pub(crate) fn text_in(node: Node<'_, '_>, tag: &str) -> Option<String> {
    find(node, tag).map(content)
}

/// The name that people read: English, else without a language, else the first.
pub(crate) fn name(node: Node<'_, '_>, tag: &str) -> Option<String> {
    let named: Vec<_> = all(node, tag).filter(|it| !content(*it).is_empty()).collect();
    let english = named.iter().find(|it| it.attribute("LcId").map(str::trim) == Some("1033"));
    let plain = named.iter().find(|it| it.attribute("LcId").is_none());
    english.or(plain).or(named.first()).map(|it| content(*it))
}

pub(crate) fn number(text: &str) -> Option<i64> {
    let text = text.trim().to_lowercase();
    let (sign, digits) = text.strip_prefix('-').map_or((1, text.as_str()), |rest| (-1, rest));
    let hex = digits
        .strip_prefix("#x0x")
        .or_else(|| digits.strip_prefix("#x"))
        .or_else(|| digits.strip_prefix("0x"));
    let value = hex.map_or_else(|| digits.parse().ok(), |hex| i64::from_str_radix(hex, 16).ok());
    value.map(|value| sign * value)
}

pub(crate) fn truth(text: Option<&str>) -> bool {
    matches!(text.map(str::trim), Some("1" | "true"))
}

pub(crate) fn lines(node: Node<'_, '_>) -> Lines {
    let line = |place| node.document().text_pos_at(place).row as usize;
    (line(node.range().start), line(node.range().end))
}
