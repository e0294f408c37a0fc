//! Which types are declared, and who shares one.

use std::collections::BTreeSet;

use crate::subjects::{corners, subjects};

#[test]
fn every_type_that_is_named_is_declared_and_every_declared_one_named() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let types = &read.dictionary.types;
            let members =
                types.values().flat_map(|it| it.items.iter().map(|item| &item.type_name).chain(&it.base));
            let objects = read.dictionary.objects.iter().map(|object| &object.type_name);
            let named: BTreeSet<_> = members.chain(objects).collect();
            assert_eq!(named, types.keys().collect::<BTreeSet<_>>(), "{}", model.name);
        }
    }
}

#[test]
fn composite_types_are_named_after_an_object_of_theirs() {
    for subject in subjects() {
        for (_, read) in subject.devices() {
            for (name, _) in read.dictionary.types.iter().filter(|(_, it)| !it.items.is_empty()) {
                let own =
                    read.dictionary.objects.iter().find(|object| format!("DT{:04X}", object.index) == *name);
                assert_eq!(own.map(|object| &object.type_name), Some(name));
            }
        }
    }
}

#[test]
fn axes_share_a_type_only_if_it_says_the_same_of_both() {
    let subject = corners();
    let objects = &subject.esi.devices[0].dictionary.objects;
    let type_of = |index| objects.iter().find(|object| object.index == index).map(|it| it.type_name.as_str());
    assert_eq!(type_of(0x6001), Some("DT6001"));
    assert_eq!(type_of(0x6801), Some("DT6001"), "the same on both axes");
    assert_eq!(type_of(0x6002), Some("DT6002"));
    assert_eq!(type_of(0x6802), Some("DT6802"), "a remark of its own on the second axis");
}

#[test]
fn choices_of_the_same_values_share_a_type() {
    let subject = corners();
    let dictionary = &subject.esi.devices[0].dictionary;
    let type_of = |index| dictionary.objects.iter().find(|it| it.index == index).unwrap().type_name.as_str();
    assert_eq!(type_of(0x2009), "DT0800EN08");
    assert_eq!(type_of(0x200A), "DT0800EN08", "the same choice");
    assert_eq!(type_of(0x2006), "SINT", "one value is no choice");
    assert_eq!(type_of(0x2004), "SINT", "ETG.2000 has no enumerations of numbers with a sign");
    let choices = [(0, "Off".to_owned()), (1, "On".to_owned()), (255, "Unknown".to_owned())];
    assert_eq!(dictionary.types["DT0800EN08"].choices, choices);
    assert_eq!(dictionary.types["DT0800EN08"].base.as_deref(), Some("USINT"));
}

#[test]
fn enumerations_stand_on_types_that_may_have_them() {
    for subject in subjects() {
        for (model, read) in subject.devices() {
            let enumerations = read.dictionary.types.values().filter(|it| !it.choices.is_empty());
            for base in enumerations.map(|it| it.base.as_deref().unwrap_or_default()) {
                assert!(["BOOL", "USINT", "UINT", "UDINT"].contains(&base), "{}: {base}", model.name);
            }
        }
    }
}

/// ETG.1020 has them as arrays of bytes and of units of 16 bits, which have no subindices.
#[test]
fn octets_and_wide_text_are_arrays() {
    let subject = corners();
    let dictionary = &subject.esi.devices[0].dictionary;
    let object = |index| dictionary.objects.iter().find(|it| it.index == index).unwrap();
    let array = |name: &str| (dictionary.types[name].base.as_deref(), dictionary.types[name].array);
    assert_eq!(object(0x200C).type_name, "ARRAY [0..5] OF BYTE");
    assert_eq!(array("ARRAY [0..5] OF BYTE"), (Some("BYTE"), Some((0, 6))));
    assert_eq!(object(0x200D).type_name, "ARRAY [0..3] OF UINT");
    assert_eq!(array("ARRAY [0..3] OF UINT"), (Some("UINT"), Some((0, 4))));
    assert_eq!(object(0x200D).info.default, Some(vec![b'a', 0, 0xDF, 0, 0, 0, 0, 0]));
}
