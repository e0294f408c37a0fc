//! Units, in the codes of CiA 303-2, and what an object says of itself that has no more than a count.

use crate::subjects::{self, compiled};

const DESCRIPTION: &str = r#"
[device]
name = "Units"
vendor = "Example"

[identity]
vendor-id = 1
product-code = 1
revision = 1

[units]
voltage  = { quantity = "voltage", symbol = "V", raw-per-unit = 10 }
length   = { quantity = "length", symbol = "mm", raw-per-unit = 1000 }
speed    = { quantity = "velocity", symbol = "rpm" }
ramp     = { quantity = "acceleration", symbol = "mm/s²" }
time     = { quantity = "time", symbol = "ms" }
turns    = { quantity = "angle", symbol = "rev", raw-per-unit = 1000 }
counts   = { quantity = "angle", symbol = "deg", raw-per-unit = "1048576/360" }
own      = { quantity = "position", symbol = "inc" }

[objects]
0x2001 = { name = "A", type = "INT16", unit = "voltage" }
0x2002 = { name = "B", type = "INT32", unit = "length" }
0x2003 = { name = "C", type = "INT32", unit = "speed", default = 1 }
0x2004 = { name = "D", type = "UINT32", unit = "ramp" }
0x2005 = { name = "E", type = "UINT32", unit = "time" }
0x2006 = { name = "F", type = "INT32", unit = "turns" }
0x2007 = { name = "G", type = "INT32", unit = "counts" }
0x2008 = { name = "H", type = "INT32", unit = "own" }
0x2009 = { name = "I", kind = "array", type = "UINT16", unit = "time", entries = { "1..=2" = { name = "J" } } }
0x200A = { name = "K", kind = "array", type = "UINT16", entries = { 0 = { access = "rw", default = 3 } } }
0x200B = { name = "L", type = "ARRAY_OF_INT16(4)" }
0x200C = { name = "M", type = "ARRAY_OF_INT8(8)" }
"#;

/// The text of an element within an object.
fn found(xml: &str, index: &str, tag: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(xml).expect("it is XML");
    let is_it = |node: &roxmltree::Node<'_, '_>| {
        node.has_tag_name("Object")
            && node.children().any(|it| it.has_tag_name("Index") && it.text() == Some(index))
    };
    let object = document.descendants().find(is_it).expect("there is the object");
    let inside = object.descendants().filter(|node| node.has_tag_name(tag));
    inside.filter_map(|node| node.text()).map(str::to_owned).collect()
}

fn xml() -> String {
    let compilation = compiled(DESCRIPTION);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.clone()).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{messages:#?}"));
    subjects::xml(&family)
}

/// The codes of CiA 303-2: a tenth of a volt is 0xFF260000, as public files have it, and a revolution a minute 0x00B44700.
#[test]
fn units_have_their_codes() {
    let xml = xml();
    for (index, units) in [
        ("#x2001", &["#xFF260000"][..]),
        ("#x2002", &["#xFA010000"]),
        ("#x2003", &["#x00B44700"]),
        ("#x2004", &["#xFD015700"]),
        ("#x2005", &["#xFD030000"]),
        ("#x2006", &["#xFDB40000"]),
        ("#x2007", &[]),
        ("#x2008", &[]),
        ("#x2009", &["#xFD030000"; 2]),
    ] {
        assert_eq!(found(&xml, index, "Unit"), units, "{index}");
    }
}

/// ETG.1020, base data types: arrays of numbers are one value.
#[test]
fn arrays_of_numbers_have_their_names() {
    let xml = xml();
    assert_eq!(found(&xml, "#x200B", "Type"), ["ARRAY [0..3] OF INT"]);
    assert_eq!(found(&xml, "#x200C", "Type"), ["ARRAY [0..7] OF SINT"]);
    for (name, base) in [("ARRAY [0..3] OF INT", "INT"), ("ARRAY [0..7] OF SINT", "SINT")] {
        let document = roxmltree::Document::parse(&xml).expect("it is XML");
        let types = document.descendants().filter(|node| node.has_tag_name("DataType"));
        let texts = types.map(|node| node.children().filter_map(|it| it.text()).collect::<Vec<_>>());
        let declared = texts.filter(|texts| texts.contains(&name)).collect::<Vec<_>>();
        assert!(declared.len() == 1 && declared[0].contains(&base), "{name}: {declared:?}");
    }
}

#[test]
fn an_object_with_a_count_alone_keeps_its_access() {
    assert_eq!(found(&xml(), "#x200A", "Access"), ["rw"]);
}
