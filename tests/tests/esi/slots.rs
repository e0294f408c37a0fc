//! The two forms of an ESI for several axes: in slots, with what each axis has in modules, and flat. A reader that puts
//! each module where its slot is has to find the same device in both.

use std::collections::BTreeMap;

use roxmltree::{Document, Node};

use crate::subjects::{compiled, xml};

const SLOTTED: &str = include_str!("slotted.toml");

fn esi(text: &str) -> String {
    let compilation = compiled(text);
    assert!(compilation.diagnostics.is_empty(), "{:#?}", compilation.diagnostics);
    xml(&compilation.family.unwrap())
}

fn flat() -> String {
    let (before, rest) = SLOTTED.split_once("[modules]").unwrap();
    let (_, behind) = rest.split_once("[objects]").unwrap();
    esi(&format!("{before}[objects]{behind}"))
}

fn number(text: &str) -> u32 {
    match text.strip_prefix("#x") {
        Some(digits) => u32::from_str_radix(digits, 16).unwrap(),
        None => text.parse().unwrap(),
    }
}

fn named<'a, 'd: 'a>(node: Node<'a, 'd>, name: &'a str) -> impl Iterator<Item = Node<'a, 'd>> {
    node.children().filter(move |child| child.has_tag_name(name))
}

fn text<'a>(node: Node<'a, '_>, name: &'a str) -> &'a str {
    named(node, name).next().and_then(|child| child.text()).unwrap_or_default()
}

/// How far a slot moves the indices of objects and of PDOs.
#[derive(Clone, Copy, Default)]
struct Moved {
    objects: u32,
    pdos: u32,
}

fn index(node: Node<'_, '_>, by: u32) -> u32 {
    let index = named(node, "Index").next().unwrap();
    let depends = index.attribute("DependOnSlot").is_some_and(|depends| depends == "1" || depends == "true");
    number(index.text().unwrap()) + if depends { by } else { 0 }
}

/// What a master needs to know of all that is in a device, by index.
type Content = BTreeMap<u32, String>;

fn gather(node: Node<'_, '_>, moved: Moved, content: &mut Content) {
    for pdo in node.children().filter(|it| it.has_tag_name("RxPdo") || it.has_tag_name("TxPdo")) {
        let mut told = format!("{:?} {:?}", pdo.attribute("Sm"), pdo.attribute("Fixed"));
        for entry in named(pdo, "Entry") {
            let index = index(entry, moved.objects);
            let rest = ["SubIndex", "BitLen", "DataType"].map(|name| text(entry, name));
            told += &format!(" {index:04X} {rest:?}");
        }
        // PDOs have the numbers of their mapping objects.
        assert_eq!(content.insert(index(pdo, moved.pdos) << 16, told), None);
    }
    for object in node.descendants().filter(|node| node.has_tag_name("Object")) {
        let flags = named(object, "Flags").next().unwrap();
        let values = object
            .descendants()
            .filter(|node| ["MinData", "MaxData", "DefaultData"].iter().any(|name| node.has_tag_name(*name)));
        let values: Vec<_> = values.filter_map(|value| value.text()).collect();
        let told = format!("{} {} {values:?}", text(object, "BitSize"), text(flags, "Access"));
        assert_eq!(content.insert(index(object, moved.objects), told), None);
    }
}

/// All that is in a device and in the modules of its slots.
fn content(xml: &str) -> Content {
    let document = Document::parse(xml).unwrap();
    let device = document.descendants().find(|node| node.has_tag_name("Device")).unwrap();
    let mut content = Content::new();
    gather(device, Moved::default(), &mut content);
    let Some(slots) = named(device, "Slots").next() else { return content };
    let step = |name| number(slots.attribute(name).unwrap());
    for (place, slot) in (0..).zip(named(slots, "Slot")) {
        let ident = number(text(slot, "ModuleIdent"));
        let module = document.descendants().filter(|node| node.has_tag_name("Module")).find(|module| {
            let kind = named(*module, "Type").next().unwrap();
            number(kind.attribute("ModuleIdent").unwrap()) == ident
        });
        let moved =
            Moved { objects: place * step("SlotIndexIncrement"), pdos: place * step("SlotPdoIncrement") };
        gather(module.unwrap(), moved, &mut content);
    }
    content
}

#[test]
fn a_device_in_slots_is_the_device_without() {
    let mut slotted = content(&esi(SLOTTED));
    let mut flat = content(&flat());
    assert!(flat.len() > 30 && slotted.len() == flat.len());
    // What tells the slots themselves is known only where there are some.
    for index in [0xF000, 0xF010, 0xF050] {
        assert_ne!(slotted.remove(&index), flat.remove(&index));
    }
    assert_eq!(slotted, flat);
}

#[test]
fn what_axes_share_stands_once() {
    let count = |xml: &str, what: &str| xml.matches(what).count();
    let (slotted, flat) = (esi(SLOTTED), flat());
    assert_eq!((count(&slotted, "<Module>"), count(&slotted, "<Slot ")), (2, 3));
    assert_eq!((count(&flat, "<Module>"), count(&flat, "<Slot ")), (0, 0));
    let mapped = |xml: &str| count(xml, "<Name LcId=\"1033\">Controlword");
    // An object and an entry of a PDO: in each of two modules, or on each of three axes.
    assert_eq!((mapped(&slotted), mapped(&flat)), (4, 6));
}

#[test]
fn objects_tell_the_slots() {
    let slotted = content(&esi(SLOTTED));
    // ETG.5001: index distance and number of slots, the profile of each, the modules that are there.
    let values = |index: u32| slotted[&index].split_once('[').unwrap().1.to_owned();
    assert_eq!(values(0xF000), r#""02", "0008", "0300"]"#);
    assert_eq!(values(0xF010), r#""03", "92010000", "92010000", "92010000"]"#);
    assert_eq!(values(0xF050), r#""03", "10000000", "10000000", "20000000"]"#);
}
