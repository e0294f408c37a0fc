//! A dictionary as an EDS tells it (CiA 306).

use super::esi::{Datum, Device, Esi, Flags, Head, Object, Shape, Value, Written};
use super::number::{bytes, number};
use super::sheet::{Section, Sheet};
use super::{basic_types, default_image};

/// Codes of objects, CiA 301.
const VAR: u8 = 7;
const ARRAY: u8 = 8;
const RECORD: u8 = 9;

/// The lists of indices, which say no more than that there are objects.
const LISTS: [&str; 3] = ["MandatoryObjects", "OptionalObjects", "ManufacturerObjects"];

/// What the file says of the device.
pub(crate) fn device(sheet: &Sheet<'_>) -> (Esi, Device) {
    let objects: Vec<Object> = sheet.sections().iter().filter_map(|section| object(sheet, section)).collect();
    let mut device = default_image::device(objects);
    let information = sheet.section("DeviceInfo");
    let text = |key| information.and_then(|it| it.text(key)).map(str::to_owned);
    let code = |key| information.and_then(|it| it.value_as(key, number));
    let identity = default_image::identity(&device.objects);
    let name = text("ProductName").unwrap_or_default();
    device.head = Head {
        at: information.map(Section::at).unwrap_or_default(),
        type_name: text("OrderCode").unwrap_or_default(),
        product_code: code("ProductNumber").or(identity[1]),
        revision: code("RevisionNumber").or(identity[2]).unwrap_or(0),
        name,
    };
    let vendor = Esi { vendor_id: code("VendorNumber").or(identity[0]), vendor_name: text("VendorName") };
    pass_over(sheet);
    (vendor, device)
}

/// What an EDS says of itself, of CAN, and once more of its objects.
fn pass_over(sheet: &Sheet<'_>) {
    for idle in ["FileInfo", "Comments", "DummyUsage"] {
        sheet.section(idle).into_iter().for_each(Section::is_idle);
    }
    let follows = ["NrOfRXPDO", "NrOfTXPDO", "Granularity"];
    let is_no = |value: &str| number::<u32>(value) == Some(0);
    if let Some(information) = sheet.section("DeviceInfo") {
        information
            .says_usual(|key, value| is_no(value) || follows.iter().any(|it| it.eq_ignore_ascii_case(key)));
    }
    for list in LISTS.iter().filter_map(|name| sheet.section(name)) {
        let is_there = |value: &str| {
            number::<u16>(value).is_some_and(|index| sheet.section(&format!("{index:04X}")).is_some())
        };
        list.says_usual(|key, value| key.eq_ignore_ascii_case("SupportedObjects") || is_there(value));
    }
}

fn object(sheet: &Sheet<'_>, section: &Section<'_>) -> Option<Object> {
    let name = section.name();
    let index = u16::from_str_radix(name, 16).ok().filter(|_| name.len() == 4)?;
    let kind = section.value_as("ObjectType", number::<u8>);
    let subs: Vec<(u8, &Section<'_>)> =
        (0..=u8::MAX).filter_map(|sub| Some((sub, sheet.section(&format!("{name}sub{sub:X}"))?))).collect();
    // How many there are, and what each of them is.
    section.value_as("SubNumber", number::<u16>);
    section.says_usual(|key, value| key.eq_ignore_ascii_case("ObjFlags") && number::<u32>(value) == Some(0));
    let values = match section.value_as("CompactSubObj", number::<u8>).filter(|count| *count > 0) {
        Some(count) => compact(sheet, section, count),
        None if subs.is_empty() => vec![value(section, 0)],
        None => {
            subs.iter().map(|(sub, section)| Value { name: title(section), ..value(section, *sub) }).collect()
        }
    };
    let shape = match kind {
        Some(ARRAY) => Shape::Array,
        Some(RECORD) => Shape::Record,
        _ if values.len() > 1 => Shape::Record,
        _ => Shape::Var,
    };
    Some(Object { at: section.at(), index, name: title(section), shape, values, ..Object::default() })
}

fn title(section: &Section<'_>) -> Option<String> {
    section.text("ParameterName").map(str::to_owned)
}

/// The entries of an object that says once what holds for all of them, with their names and values in sections of their
/// own.
fn compact(sheet: &Sheet<'_>, section: &Section<'_>, count: u8) -> Vec<Value> {
    let own = |suffix: &str| sheet.section(&format!("{}{suffix}", section.name()));
    let (names, values) = (own("Name"), own("Value"));
    for list in [names, values].into_iter().flatten() {
        list.value_as("NrOfEntries", number::<u16>);
    }
    let first = Value {
        type_name: "UINT8".to_owned(),
        bits: Some(8),
        flags: Flags { access: Some("ro".to_owned()), ..Flags::default() },
        default: Some(Datum { at: section.at(), written: Written::Number(count.to_string()) }),
        ..Value::default()
    };
    let entry = |subindex: u8| {
        let entry = value(section, subindex);
        let key = subindex.to_string();
        let given = values.and_then(|it| it.text(&key));
        let default = given.map(|text| datum(section, "DefaultValue", text, &entry.type_name));
        let name = names.and_then(|it| it.text(&key)).map(str::to_owned);
        Value { name, default: default.or(entry.default.clone()), ..entry }
    };
    std::iter::once(first).chain((1..=count).map(entry)).collect()
}

/// A value as its section tells it.
fn value(section: &Section<'_>, subindex: u8) -> Value {
    let code = section.value_as("DataType", number::<u16>);
    let (type_name, bits) = match code {
        Some(code) => basic_types::of_code(code).unwrap_or_else(|| (format!("0x{code:04X}"), None)),
        None => (String::new(), None),
    };
    let limit = |key: &str| section.text(key).map(|text| datum(section, key, text, &type_name));
    let (default, min, max) = (limit("DefaultValue"), limit("LowLimit"), limit("HighLimit"));
    let length = default.as_ref().and_then(|datum| match &datum.written {
        Written::Data(bytes) => u32::try_from(bytes.len()).ok(),
        Written::Text(text) => u32::try_from(text.len()).ok(),
        Written::Number(_) => None,
    });
    let bits = bits.or_else(|| length.filter(|length| *length > 0).map(|length| length.saturating_mul(8)));
    let type_name = basic_types::sized(type_name, bits);
    section.value_as("ObjectType", |text| number::<u8>(text).filter(|kind| *kind == VAR));
    section.says_usual(|key, value| key.eq_ignore_ascii_case("ObjFlags") && number::<u32>(value) == Some(0));
    Value {
        at: section.at(),
        subindex,
        type_name,
        bits,
        flags: flags(section),
        default,
        min,
        max,
        ..Value::default()
    }
}

/// A value in the form that its type has: bytes, text or a number.
fn datum(section: &Section<'_>, key: &str, text: &str, type_name: &str) -> Datum {
    let written = match type_name {
        "OCTET_STRING" => bytes(text).map_or_else(|| Written::Number(text.to_owned()), Written::Data),
        "STRING" => Written::Text(text.to_owned()),
        _ => Written::Number(text.to_owned()),
    };
    Datum { at: section.place(key), written }
}

/// Who may do what: `rwr` and `rww` say in which process data a value can be that can be read and written.
fn flags(section: &Section<'_>) -> Flags {
    let word = section.text("AccessType").map(str::to_lowercase);
    let is_mapped = section.value_as("PDOMapping", number::<u8>).is_some_and(|mapped| mapped != 0);
    let (access, directions) = match word.as_deref() {
        Some("rwr") => ("rw", "T"),
        Some("rww") => ("rw", "R"),
        Some("rw") => ("rw", "RT"),
        Some("wo") => ("wo", "R"),
        Some(other) => (other, "T"),
        None => ("ro", "T"),
    };
    Flags {
        access: Some(access.to_owned()),
        pdo_mapping: is_mapped.then(|| directions.to_owned()),
        ..Flags::default()
    }
}
