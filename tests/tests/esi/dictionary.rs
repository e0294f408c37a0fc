//! The object dictionary: every entry of the model, and nothing else.

use devc::model::{
    Access, Category, DataType, Device, Entry, Mappable, Object, Value as ModelValue, WriteWindow,
};
use devc_tests::esi_reader::{self, Flags, Value};

use crate::subjects::{corners, is_named, subjects};

/// Objects of the model with what the file says of them.
fn objects<'a>(
    model: &'a Device,
    read: &'a esi_reader::Device,
) -> impl Iterator<Item = (&'a Object, &'a esi_reader::Object, Vec<Value>)> {
    assert_eq!(read.dictionary.objects.len(), model.objects.len());
    model.objects.iter().zip(&read.dictionary.objects).map(|(model, object)| {
        let values = read.dictionary.values(object).unwrap_or_else(|error| panic!("{error}"));
        (model, object, values)
    })
}

#[test]
fn objects_are_those_of_the_model_by_index() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (object, read, values) in objects(model, read) {
                assert_eq!(read.index, object.index.0);
                assert!(is_named(model, &read.name, &object.name, object.axis), "{}", object.index);
                assert_eq!(values.len(), object.entries.len(), "{}", object.index);
            }
            assert!(read.dictionary.objects.is_sorted_by(|one, next| one.index < next.index));
        }
    }
}

#[test]
fn values_are_those_of_the_model_by_subindex() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (object, _, values) in objects(model, read) {
                for (entry, value) in object.entries.iter().zip(&values) {
                    compare(object, entry, value);
                }
            }
        }
    }
}

fn compare(object: &Object, entry: &Entry, value: &Value) {
    let at = entry.address;
    let alone = object.entries.len() == 1;
    let data_type = if alone || at.subindex > 0 { entry.data_type } else { DataType::Uint(8) };
    assert_eq!(value.subindex, at.subindex, "{at}");
    let name = if alone { &object.name } else { &entry.name };
    // The axis or the subindex, in parentheses.
    let suffixed = value.name.strip_prefix(name.as_str()).is_some_and(|suffix| suffix.starts_with(" ("));
    assert!(value.name == *name || suffixed, "{at}: {} is not {name}", value.name);
    assert_eq!(value.basic_type, spelled(data_type), "{at}");
    assert_eq!(value.bits, data_type.bits(), "{at}");
    assert_eq!(value.flags, flags(entry, if alone { object.category } else { entry.category }), "{at}");
    assert_eq!(value.info.default, entry.default.as_ref().map(|it| bytes(it, data_type)), "{at}");
    assert_eq!(value.info.min, entry.min.as_ref().map(|it| bytes(it, data_type)), "{at}");
    assert_eq!(value.info.max, entry.max.as_ref().map(|it| bytes(it, data_type)), "{at}");
    let choices: Vec<_> = entry.values.iter().map(|it| (it.value, it.name.clone())).collect();
    // ETG.2000 lets these be enumerations.
    let may = ["BOOL", "USINT", "UINT", "UDINT"].contains(&value.basic_type.as_str());
    let expected = if may && choices.len() > 1 { choices } else { Vec::new() };
    assert_eq!(value.choices, expected, "{at}");
}

fn flags(entry: &Entry, category: Category) -> Flags {
    let access = match entry.access {
        Access::Ro | Access::Const => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
    };
    let category = match category {
        Category::Mandatory => "m",
        Category::Optional => "o",
        Category::Conditional => "c",
    };
    let pdo_mapping = match entry.pdo {
        Mappable::None => None,
        Mappable::Rx => Some("R"),
        Mappable::Tx => Some("T"),
        Mappable::RxTx => Some("TR"),
    };
    Flags {
        access: access.to_owned(),
        // The words of the schema, EtherCATBase.xsd.
        write_restrictions: entry.written.map(|window| match window {
            WriteWindow::PreOp => "PreOP".to_owned(),
            WriteWindow::PreOpSafeOp => "PreOP_SafeOP".to_owned(),
            WriteWindow::PreOpOp => "PreOP_OP".to_owned(),
            WriteWindow::SafeOp => "SafeOP".to_owned(),
            WriteWindow::SafeOpOp => "SafeOP_OP".to_owned(),
            WriteWindow::Op => "OP".to_owned(),
        }),
        category: Some(category.to_owned()),
        pdo_mapping: pdo_mapping.map(str::to_owned),
        kept: (entry.backup.then_some(1), entry.setting.then_some(1)),
    }
}

/// The type in the words of IEC 61131-3.
fn spelled(data_type: DataType) -> String {
    let table = [
        ("INT8", "SINT"),
        ("INT16", "INT"),
        ("INT32", "DINT"),
        ("INT64", "LINT"),
        ("UINT8", "USINT"),
        ("UINT16", "UINT"),
        ("UINT32", "UDINT"),
        ("UINT64", "ULINT"),
        ("REAL32", "REAL"),
        ("REAL64", "LREAL"),
    ];
    // Arrays without subindices: the type of an element.
    let data_type = match data_type {
        DataType::Array(item, _) => item.data_type(),
        other => other,
    };
    match data_type {
        DataType::Octets(_) => return "BYTE".to_owned(),
        DataType::Unicode(_) => return "UINT".to_owned(),
        _ => {}
    }
    let written = data_type.to_string();
    table
        .iter()
        .find(|(ours, _)| *ours == written)
        .map_or(written.clone(), |(_, theirs)| (*theirs).to_owned())
}

/// A value as it travels, worked out byte by byte.
fn bytes(value: &ModelValue, data_type: DataType) -> Vec<u8> {
    let width = data_type.bits().div_ceil(8) as usize;
    if let ModelValue::Text(text) = value {
        let wide = matches!(data_type, DataType::Unicode(_));
        let units = text.encode_utf16().flat_map(u16::to_le_bytes);
        let mut bytes = if wide { units.collect() } else { text.clone().into_bytes() };
        bytes.resize(width, 0);
        return bytes;
    }
    let bits = match (value, data_type) {
        (ModelValue::Real(value), DataType::Real32) => u64::from((*value as f32).to_bits()),
        (ModelValue::Real(value), _) => value.to_bits(),
        _ => value.integer().unwrap() as u64,
    };
    (0..width).map(|byte| (bits >> (8 * byte)) as u8).collect()
}

#[test]
fn an_object_allows_what_any_of_its_values_allows() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (object, read, values) in objects(model, read) {
                let own: Vec<_> = values.iter().filter(|it| values.len() == 1 || it.subindex > 0).collect();
                let readable = own.iter().any(|it| it.flags.access != "wo");
                let writable = own.iter().any(|it| it.flags.access != "ro");
                assert_eq!(read.flags.access != "ro", writable, "{}", object.index);
                assert_eq!(read.flags.access == "wo", writable && !readable, "{}", object.index);
                for direction in ["R", "T"] {
                    let mapped =
                        |flags: &Flags| flags.pdo_mapping.as_ref().is_some_and(|it| it.contains(direction));
                    let any = own.iter().any(|it| mapped(&it.flags));
                    assert_eq!(mapped(&read.flags), any, "{} {direction}", object.index);
                }
            }
        }
    }
}

#[test]
fn names_that_repeat_are_told_apart_by_subindex() {
    let subject = corners();
    let dictionary = &subject.esi.devices[0].dictionary;
    let object = dictionary.objects.iter().find(|object| object.index == 0x2001).unwrap();
    let names: Vec<_> = dictionary.values(object).unwrap().into_iter().map(|value| value.name).collect();
    assert_eq!(names[1..], ["Reserved", "Level", "Reserved (3)", "Reserved (4)", "Switch", "Lamp", "Label"]);
}

#[test]
fn what_people_should_know_is_in_the_comments() {
    let line = |text: &String| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for subject in subjects() {
        for (model, read) in subject.devices() {
            for (object, read, _) in objects(model, read) {
                let comment = read.comment.clone().unwrap_or_default();
                let known = object.about.iter().chain(&object.note).map(line);
                known.for_each(|text| assert!(comment.contains(&text), "{}: {comment}", object.index));
                assert_eq!(comment.contains("Without function"), !object.functional, "{}", object.index);
            }
        }
    }
}

#[test]
fn values_that_no_type_can_tell_are_in_the_comments() {
    let subject = corners();
    let objects = &subject.esi.devices[0].dictionary.objects;
    let comment = |index| objects.iter().find(|it| it.index == index).unwrap().comment.clone();
    let values = "Values: -1 = Backward; 0 = Still; 1 = Forward.";
    assert_eq!(comment(0x2004).as_deref(), Some(values), "an INT8 is no enumeration");
    assert_eq!(comment(0x2006).as_deref(), Some("Values: 0 = Still."), "one value is no choice");
    assert_eq!(comment(0x2009), None, "the type has them");
    let spoken = "Part 1: The first. Part 3: The last. Values: -1 = Left; 1 = Right.";
    assert_eq!(comment(0x200B).as_deref(), Some(spoken), "the elements of an array share their type");
}

#[test]
fn members_have_comments_of_their_own() {
    let subject = corners();
    let members = &subject.esi.devices[0].dictionary.types["DT6802"].items;
    assert_eq!(members[1].comment.as_deref(), Some("does nothing here"));
    assert_eq!(members[2].comment.as_deref(), Some("Idle. Without function; exists for compatibility only."));
}
