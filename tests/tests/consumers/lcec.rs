//! Configurations of LinuxCNC-EtherCAT, by a reader made from its documentation: which elements and attributes there are,
//! which numbers are hexadecimal, what a pin can be. What it reads is what the JSON model says.

use std::collections::BTreeSet;

use devc::emit::lcec::Lcec;
use roxmltree::{Document, Node};
use serde_json::Value as Json;

use crate::expected::bytes;
use crate::model::{list, number, text, word};
use crate::ways::{each_file, step};

/// An element with what it must have, what it may have, and what may be in it.
type Known = (&'static str, &'static [&'static str], &'static [&'static str], &'static [&'static str]);

/// Elements with their attributes, those that have to be there first, and what may be in them.
const ELEMENTS: &[Known] = &[
    ("masters", &[], &[], &["master"]),
    ("master", &["idx", "appTimePeriod"], &["refClockSyncCycles", "name"], &["slave"]),
    (
        "slave",
        &["idx", "type", "vid", "pid"],
        &["name", "configPdos"],
        &["dcConf", "sdoConfig", "syncManager"],
    ),
    ("dcConf", &["assignActivate"], &["sync0Cycle", "sync0Shift", "sync1Cycle", "sync1Shift"], &[]),
    ("sdoConfig", &["idx", "subIdx"], &[], &["sdoDataRaw"]),
    ("sdoDataRaw", &["data"], &[], &[]),
    ("syncManager", &["idx", "dir"], &[], &["pdo"]),
    ("pdo", &["idx"], &[], &["pdoEntry"]),
    ("pdoEntry", &["idx", "subIdx", "bitLen"], &["halPin", "halType", "scale", "offset"], &[]),
];

/// Types of pins that need no other elements.
const TYPES: &[&str] = &["bit", "s32", "u32", "float", "float-unsigned", "float-ieee", "float-double-ieee"];

fn hexadecimal(node: Node<'_, '_>, attribute: &str) -> usize {
    let digits = node.attribute(attribute).unwrap();
    assert!(digits.bytes().all(|byte| byte.is_ascii_hexdigit()), "{attribute} {digits}");
    usize::from_str_radix(digits, 16).unwrap()
}

fn decimal(node: Node<'_, '_>, attribute: &str) -> usize {
    node.attribute(attribute).unwrap().parse().unwrap()
}

/// That everything is known, and each pin can be.
fn read(document: &Document<'_>) {
    let mut pins = BTreeSet::new();
    for node in document.descendants().filter(Node::is_element) {
        let tag = node.tag_name().name();
        let (_, needed, possible, inner) = ELEMENTS.iter().find(|(name, ..)| *name == tag).expect(tag);
        assert!(needed.iter().all(|name| node.has_attribute(*name)), "{tag} lacks one of {needed:?}");
        for attribute in node.attributes() {
            let known = needed.contains(&attribute.name()) || possible.contains(&attribute.name());
            assert!(known, "{tag} has no {}", attribute.name());
        }
        for child in node.children().filter(Node::is_element) {
            assert!(inner.contains(&child.tag_name().name()), "{:?} in {tag}", child.tag_name());
        }
        if let Some(pin) = node.attribute("halPin") {
            // `lcec.<master>.<slave>.` stands before it, and 47 characters are a name of HAL
            assert!(pin.len() + "lcec.0.10.".len() <= 47, "{pin} is too long");
            assert!(pins.insert(pin.to_owned()), "{pin} is there twice");
            let hal_type = node.attribute("halType").expect("a type");
            assert!(TYPES.contains(&hal_type), "{hal_type}");
            assert!(!node.has_attribute("scale") || hal_type.starts_with("float"), "{pin} has a scale");
            assert!(hal_type != "bit" || decimal(node, "bitLen") == 1, "{pin}");
        }
    }
    assert!(!pins.is_empty(), "there are pins");
}

fn inner<'a, 'i>(node: Node<'a, 'i>, tag: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |child| child.has_tag_name(tag))
}

#[test]
fn configurations_are_what_the_model_says() {
    each_file(&Lcec, |file, content, member, configuration| {
        let content = std::str::from_utf8(content).unwrap();
        let document = Document::parse(content).unwrap_or_else(|error| panic!("{file}: {error}"));
        read(&document);
        compare(file, member, configuration, &document);
    });
}

fn compare(file: &str, member: &Json, configuration: Option<&Json>, document: &Document<'_>) {
    let find = |tag| document.descendants().find(|node| node.has_tag_name(tag));
    let (master, slave) = (find("master").unwrap(), find("slave").unwrap());
    let cycle = configuration.and_then(|it| it["cycle_ns"].as_u64()).unwrap_or(1_000_000);
    assert_eq!(decimal(master, "appTimePeriod") as u64, cycle, "{file}");
    let identity = &member["identity"];
    assert_eq!(hexadecimal(slave, "vid"), number(identity, "vendor_id"), "{file}");
    assert_eq!(hexadecimal(slave, "pid"), number(identity, "product_code"), "{file}");
    clocks(file, member, find("dcConf"));
    sdos(file, configuration, slave);
    let carrying = list(member, "sync_managers").iter().filter_map(|manager| {
        let (role, key) =
            (text(manager, "role"), if manager["role"] == "outputs" { "outputs" } else { "inputs" });
        let chosen = configuration.and_then(|it| it[key].as_array().map(Vec::as_slice));
        let pdos = chosen.unwrap_or(list(manager, "pdos"));
        (!role.starts_with("mailbox") && !pdos.is_empty()).then_some((manager, pdos))
    });
    let carrying: Vec<_> = carrying.collect();
    let managers: Vec<_> = inner(slave, "syncManager").collect();
    assert_eq!(managers.len(), carrying.len(), "{file}");
    for (node, (manager, pdos)) in managers.into_iter().zip(carrying) {
        assert_eq!(decimal(node, "idx"), number(manager, "number"), "{file}");
        let way = if manager["role"] == "outputs" { "out" } else { "in" };
        assert_eq!(node.attribute("dir"), Some(way), "{file}");
        let found: Vec<usize> = inner(node, "pdo").map(|pdo| hexadecimal(pdo, "idx")).collect();
        let wanted: Vec<usize> = pdos.iter().map(|index| index.as_u64().unwrap() as usize).collect();
        assert_eq!(found, wanted, "{file}");
        for pdo in inner(node, "pdo") {
            let mapped = configuration.into_iter().flat_map(|it| list(it, "mapping"));
            let mut known = mapped.chain(list(member, "pdos"));
            let described = known.find(|it| number(it, "index") == hexadecimal(pdo, "idx")).unwrap();
            entries(file, member, described, pdo);
        }
    }
}

/// The first of the ways to keep time is the default.
fn clocks(file: &str, member: &Json, node: Option<Node<'_, '_>>) {
    let mode = list(member, "sync_modes").iter().find(|mode| mode["assign_activate"] != 0);
    assert_eq!(node.is_some(), mode.is_some(), "{file}");
    let (Some(node), true) = (node, mode.is_some()) else { return };
    let mode = &list(member, "sync_modes")[0];
    assert_eq!(hexadecimal(node, "assignActivate"), number(mode, "assign_activate"), "{file}");
    for signal in ["sync0", "sync1"] {
        let (cycle, shift) = (format!("{signal}Cycle"), format!("{signal}Shift"));
        assert_eq!(node.has_attribute(&*cycle), !mode[signal].is_null(), "{file}");
        if let (Some(found), true) = (node.attribute(&*cycle), mode[signal]["cycles"].as_i64() > Some(0)) {
            assert_eq!(found, format!("*{}", mode[signal]["cycles"]), "{file}");
            assert_eq!(node.attribute(&*shift), Some(&*mode[signal]["shift_ns"].to_string()), "{file}");
        }
    }
}

/// Assignment and mapping are lcec's own, and it writes in Pre-Operational only.
fn sdos(file: &str, configuration: Option<&Json>, slave: Node<'_, '_>) {
    let found = inner(slave, "sdoConfig").map(|sdo| {
        let data = inner(sdo, "sdoDataRaw").next().unwrap().attribute("data").unwrap();
        let data = data.split(' ').map(|byte| {
            assert_eq!(byte.len(), 2, "two digits each");
            u8::from_str_radix(byte, 16).unwrap()
        });
        (hexadecimal(sdo, "idx"), hexadecimal(sdo, "subIdx"), data.collect::<Vec<u8>>())
    });
    let is_own = |write: &&Json| {
        let index = number(&write["address"], "index");
        let assigns = matches!(index, 0x1C12 | 0x1C13 | 0x1600..=0x17FF | 0x1A00..=0x1BFF);
        !assigns && ["IP", "PS"].contains(&text(write, "transition"))
    };
    let writes = configuration.into_iter().flat_map(|it| list(it, "startup")).filter(is_own);
    let wanted = writes.map(|write| {
        let address = &write["address"];
        (number(address, "index"), number(address, "subindex"), bytes(&write["data"]))
    });
    assert_eq!(found.collect::<Vec<_>>(), wanted.collect::<Vec<_>>(), "{file}");
}

fn entries(file: &str, member: &Json, described: &Json, pdo: Node<'_, '_>) {
    let found: Vec<_> = inner(pdo, "pdoEntry").collect();
    assert_eq!(found.len(), list(described, "entries").len(), "{file}");
    for (node, mapped) in found.into_iter().zip(list(described, "entries")) {
        let part = |key: &str| mapped["address"][key].as_u64().unwrap_or(0) as usize;
        let address = (hexadecimal(node, "idx"), hexadecimal(node, "subIdx"));
        assert_eq!(address, (part("index"), part("subindex")), "{file}");
        assert_eq!(decimal(node, "bitLen"), number(mapped, "bits"), "{file}");
        let what = format!("{file}, {}", text(mapped, "name"));
        match hal_type(member, mapped) {
            None => assert!(!node.has_attribute("halPin"), "{what}"),
            Some((hal_type, scale)) => {
                assert!(node.has_attribute("halPin"), "{what}");
                assert_eq!(node.attribute("halType"), Some(&*hal_type), "{what}");
                let found = node.attribute("scale").map(|scale| scale.parse::<f64>().unwrap());
                let same = match (found, scale) {
                    (Some(one), Some(two)) => (one - two).abs() <= two * 1e-12,
                    (one, two) => one == two,
                };
                assert!(same, "{what}: {found:?}, not {scale:?}");
            }
        }
    }
}

/// The type of the pin, and the units of LinuxCNC for one raw step; none for gaps and for what no pin holds.
fn hal_type(member: &Json, mapped: &Json) -> Option<(String, Option<f64>)> {
    if mapped["address"].is_null() {
        return None;
    }
    let (bits, scale) = (number(mapped, "bits"), scale(member, mapped));
    let is_word = word(member, &mapped["address"]).is_some();
    Some(match mapped["data_type"].as_str().unwrap_or("UINT") {
        "REAL32" => ("float-ieee".to_owned(), None),
        "REAL64" => ("float-double-ieee".to_owned(), None),
        data_type if data_type.contains("STRING") || bits > 32 => return None,
        _ if bits == 1 => ("bit".to_owned(), None),
        data_type => match (data_type.starts_with("INT") && !is_word, scale) {
            (true, Some(scale)) => ("float".to_owned(), Some(scale)),
            (false, Some(scale)) => ("float-unsigned".to_owned(), Some(scale)),
            (true, None) => ("s32".to_owned(), None),
            (false, None) => ("u32".to_owned(), None),
        },
    })
}

/// Millimetres, degrees, and these in a second.
fn scale(member: &Json, mapped: &Json) -> Option<f64> {
    let (symbol, ratio) = step(member, mapped)?;
    let own = match symbol {
        "mm" | "mm/s" | "deg" | "deg/s" | "°" | "°/s" => 1.0,
        "µm" | "µm/s" | "mdeg" | "mdeg/s" => 0.001,
        "nm" => 1e-6,
        "m" | "m/s" => 1000.0,
        "rpm" => 6.0,
        "rev" => 360.0,
        _ => return None,
    };
    Some(own * ratio)
}
