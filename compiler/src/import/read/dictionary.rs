//! The object dictionary: objects and their types brought together as values.

use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::element::{At, Element};
use super::esi::{Choice, Datum, Flags, Object, Property, Shape, Value, Written};
use super::number::{bytes, number, truth};
use super::{meanings, words};
use crate::model::{Safety, SdoAccess, UnitCode};

/// A type as it is declared.
struct DataType<'e, 't> {
    element: &'e Element<'t>,
    bits: Option<u32>,
    base: Option<&'e str>,
    array: Option<(u32, u32)>,
    items: Vec<&'e Element<'t>>,
    choices: Rc<[Choice]>,
    used: Cell<bool>,
}

type Types<'e, 't> = BTreeMap<&'e str, DataType<'e, 't>>;

/// Types that are made of each other are followed so far.
const MOST_NESTED: usize = 8;

/// How many values and meanings of values a dictionary may have: a few lines can ask for very many, by types that are
/// arrays. devc holds no more entries of a description.
const MOST_VALUES: usize = 500_000;

/// The objects; and the first that was one too many, if there was one.
pub(super) fn objects(dictionary: &Element<'_>) -> (Vec<Object>, Option<At>) {
    let mut types = Types::new();
    for element in dictionary.all("DataTypes").flat_map(|types| types.all("DataType")) {
        if let Some(name) = element.child("Name") {
            // Of two types of one name the first counts.
            types.entry(name.text()).or_insert_with(|| data_type(element));
        }
    }
    let (mut objects, mut values) = (Vec::new(), 0_usize);
    for element in dictionary.all("Objects").flat_map(|objects| objects.all("Object")) {
        let Some(mut object) = object(element, &types) else { continue };
        meanings::take_out(&mut object);
        let weights = object.values.iter().map(|value| 1 + value.choices.len());
        values = values.saturating_add(weights.sum());
        if values > MOST_VALUES {
            return (objects, Some(element.at()));
        }
        objects.push(object);
    }
    // A type that no object has says nothing of the device.
    types.values().filter(|it| !it.used.get()).for_each(|it| it.element.is_idle());
    (objects, None)
}

fn data_type<'e, 't>(element: &'e Element<'t>) -> DataType<'e, 't> {
    let array = element.child("ArrayInfo").map(|array| {
        let first = array.child_as("LBound", number).unwrap_or(1);
        (first, array.child_as("Elements", number).unwrap_or(0))
    });
    DataType {
        element,
        bits: element.child_as("BitSize", number),
        base: element.child("BaseType").map(Element::text).filter(|base| !base.is_empty()),
        array,
        items: element.all("SubItem").collect(),
        choices: element.all("EnumInfo").filter_map(choice).collect(),
        used: Cell::new(false),
    }
}

fn choice(element: &Element<'_>) -> Option<Choice> {
    let value = element.child_as("Enum", number)?;
    let name = words::name(element, "Text")?;
    let names = words::others(element, "Text");
    Some(Choice { value, name, names, comment: words::name(element, "Comment") })
}

fn object(element: &Element<'_>, types: &Types<'_, '_>) -> Option<Object> {
    let index_element = element.child("Index")?;
    let index = number(index_element.text())?;
    let own = own_flags(element).unwrap_or_default();
    let type_name = element.child("Type").map(|it| it.text()).unwrap_or_default();
    let bits = element.child_as("BitSize", number);
    let mut object = Object {
        at: element.at(),
        index,
        name: words::name(element, "Name"),
        names: words::others(element, "Name"),
        comment: words::name(element, "Comment"),
        flags: own.clone(),
        properties: element.child("Properties").map(properties).unwrap_or_default(),
        ..Object::default()
    };
    let info = element.child("Info");
    match types.get(type_name).filter(|it| !it.items.is_empty()) {
        None => {
            let mut value = basic(element, type_name, bits, types);
            value.flags = own;
            values(&mut value, info);
            object.values.push(value);
        }
        Some(composite) => {
            composite.used.set(true);
            (object.shape, object.values) = members(composite, &own, types);
            infos(&mut object.values, info);
            own_values(&mut object.values, composite);
        }
    }
    Some(object)
}

/// Gives each value what the member of its type says, where the object says nothing.
fn own_values(found: &mut [Value], composite: &DataType<'_, '_>) {
    for item in &composite.items {
        let subindex: Option<u8> = item.child_as("SubIdx", number);
        let Some(value) = found.iter_mut().find(|value| Some(value.subindex) == subindex) else { continue };
        for (place, what) in
            [(&mut value.default, "Default"), (&mut value.min, "Min"), (&mut value.max, "Max")]
        {
            if place.is_none() {
                *place = datum(item, what);
            }
        }
    }
}

/// A value of a type that has no members: its basic type, width and choices.
fn basic(element: &Element<'_>, type_name: &str, bits: Option<u32>, types: &Types<'_, '_>) -> Value {
    let mut value = Value { at: element.at(), type_name: type_name.to_owned(), bits, ..Value::default() };
    for _ in 0..MOST_NESTED {
        let Some(declared) = types.get(value.type_name.as_str()) else { break };
        declared.used.set(true);
        value.bits = value.bits.or(declared.bits);
        if value.choices.is_empty() {
            value.choices = Rc::clone(&declared.choices);
        }
        match declared.base {
            Some(base) if declared.array.is_none() => value.type_name = base.to_owned(),
            _ => break,
        }
    }
    value
}

/// The values that a composite type has room for, subindex 0 first.
fn members(composite: &DataType<'_, '_>, own: &Flags, types: &Types<'_, '_>) -> (Shape, Vec<Value>) {
    let mut shape = Shape::Record;
    let mut found = Vec::new();
    for item in &composite.items {
        let subindex: Option<u8> = item.child_as("SubIdx", number);
        if subindex.is_none()
            && item.children().iter().any(|child| child.name() == "SubIdx" && !child.is_blank())
        {
            // One that is none leads nowhere: all of it stays unread.
            continue;
        }
        let type_name = item.child("Type").map(|it| it.text()).unwrap_or_default();
        let bits = item.child_as("BitSize", number);
        // How members lie follows from their widths.
        item.child_as("BitOffs", number::<u32>);
        let flags = own_flags(item).unwrap_or_else(|| own.clone());
        let name = words::name(item, "Name");
        let comment = words::name(item, "Comment");
        let array = types.get(type_name).and_then(|it| Some((it, it.array?))).filter(|_| subindex.is_none());
        let Some((array, (first, elements))) = array else {
            let value = basic(item, type_name, bits, types);
            let next = u8::try_from(found.len()).unwrap_or(u8::MAX);
            let names = words::others(item, "DisplayName");
            let display_name = words::name(item, "DisplayName");
            let subindex = subindex.unwrap_or(next);
            let properties = properties(item);
            found.push(Value { subindex, name, names, display_name, comment, flags, properties, ..value });
            continue;
        };
        shape = Shape::Array;
        array.used.set(true);
        let element = basic(item, array.base.unwrap_or_default(), None, types);
        let step = array.bits.unwrap_or(0).checked_div(elements);
        for number in first..first.saturating_add(elements.min(255)) {
            let Ok(subindex) = u8::try_from(number) else { break };
            let (type_name, choices) = (element.type_name.clone(), element.choices.clone());
            let bits = element.bits.or(step);
            found.push(Value {
                at: element.at,
                subindex,
                type_name,
                choices,
                bits,
                flags: flags.clone(),
                ..Value::default()
            });
        }
    }
    (shape, found)
}

/// What the vendor's tools are told: names with values.
fn properties(parent: &Element<'_>) -> Vec<Property> {
    let property = |element: &Element<'_>| {
        Some(Property {
            name: element.child("Name")?.text().to_owned(),
            value: element.child("Value").map(|value| value.text().to_owned()),
            about: words::name(element, "Desc"),
        })
    };
    parent.all("Property").filter_map(property).collect()
}

/// Gives each value what `Info` says of it: by name where names are unique, by the subindex that a name is, else in order.
fn infos(found: &mut [Value], info: Option<&Element<'_>>) {
    let items: Vec<&Element<'_>> = info.into_iter().flat_map(|info| info.all("SubItem")).collect();
    let names: Vec<Option<String>> = items.iter().map(|item| words::name(item, "Name")).collect();
    let known: BTreeMap<String, usize> =
        found.iter().enumerate().filter_map(|(place, value)| Some((value.name.clone()?, place))).collect();
    let named = found.iter().filter(|value| value.name.is_some()).count();
    let by_name = named == found.len()
        && known.len() == found.len()
        && names.iter().all(|name| name.as_ref().is_some_and(|name| known.contains_key(name)));
    let numbers: Option<BTreeSet<u8>> = names.iter().map(|name| numbered(name.as_deref()?)).collect();
    let by_number = !by_name && numbers.is_some_and(|numbers| numbers.len() == items.len());
    for (order, (item, name)) in items.iter().zip(names).enumerate() {
        let place = match &name {
            Some(name) if by_name => known.get(name).copied().unwrap_or(order),
            Some(name) if by_number => {
                found.iter().position(|value| Some(value.subindex) == numbered(name)).unwrap_or(usize::MAX)
            }
            _ => order,
        };
        let Some(value) = found.get_mut(place) else { continue };
        values(value, item.child("Info"));
        value.name = value.name.take().or(name);
    }
}

/// The subindex that a name is: `SubIndex 017`, in decimal.
fn numbered(name: &str) -> Option<u8> {
    let (word, digits) = name.split_once(' ')?;
    word.eq_ignore_ascii_case("subindex").then(|| digits.trim().parse().ok())?
}

/// Default and limits.
fn values(value: &mut Value, info: Option<&Element<'_>>) {
    let Some(info) = info else { return };
    value.default = datum(info, "Default");
    value.min = datum(info, "Min");
    value.max = datum(info, "Max");
    value.unit = info.child_as("Unit", |text| UnitCode::read(number(text)?));
    if let Some(name) = words::name(info, "DisplayName") {
        value.display_name = Some(name);
    }
}

fn datum(info: &Element<'_>, what: &str) -> Option<Datum> {
    let find = |suffix: &str| {
        let name = format!("{what}{suffix}");
        let found = info.children().iter().find(|child| child.name() == name);
        found.map(|child| (child, name))
    };
    let data = find("Data")
        .and_then(|(child, name)| Some((child.at(), Written::Data(info.child_as(&name, bytes)?))));
    let text = || find("String").map(|(child, _)| (child.at(), Written::Text(child.text().to_owned())));
    let plain = || find("Value").map(|(child, _)| (child.at(), Written::Number(child.text().to_owned())));
    let (at, written) = data.or_else(text).or_else(plain)?;
    let is_empty = match &written {
        Written::Data(bytes) => bytes.is_empty(),
        Written::Number(text) => text.is_empty(),
        Written::Text(_) => false,
    };
    (!is_empty).then_some(Datum { at, written })
}

fn own_flags(element: &Element<'_>) -> Option<Flags> {
    let flags = element.child("Flags")?;
    let access = flags.child("Access");
    let word = |name| flags.child(name).map(|it| it.text().to_owned()).filter(|it| !it.is_empty());
    Some(Flags {
        access: access.map(|access| access.text().to_owned()).filter(|it| !it.is_empty()),
        write_restrictions: access
            .and_then(|access| access.attribute("WriteRestrictions"))
            .map(str::to_owned),
        category: word("Category"),
        pdo_mapping: word("PdoMapping"),
        safety: flags.child_as("SafetyMapping", safety),
        sdo_access: flags.child_as("SdoAccess", sdo_access),
        backup: flags.child_as("Backup", truth).unwrap_or(false),
        setting: flags.child_as("Setting", truth).unwrap_or(false),
    })
}

fn safety(text: &str) -> Option<Safety> {
    Safety::ALL.into_iter().find(|it| it.name().eq_ignore_ascii_case(text))
}

fn sdo_access(text: &str) -> Option<SdoAccess> {
    SdoAccess::ALL.into_iter().find(|it| it.name() == text)
}
