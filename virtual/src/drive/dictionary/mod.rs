//! The object dictionary of a device, made from its description while the program runs.
//!
//! It is what generated code has as constants and as a struct, in the same types: the table that finds an entry by its
//! address, bounds, names, what process data may be made of, and the values.

mod number;
mod rights;
mod rules;
mod table;
mod values;

use devc::model::{Access, DataType, Device, Entry, Object, Value};
use devc_runtime::sdo::{Dictionary, Names, PdoRules, Range};

pub(crate) use number::Number;
pub use values::Values;

use self::values::Kept;
use super::forever;

/// All tables of a device, and the values that it starts with.
#[derive(Debug)]
pub(crate) struct Tables {
    /// Every entry, by address.
    pub(crate) dictionary: Dictionary,
    /// The bounds of the values that have any.
    ranges: &'static [Range],
    /// The names, for a device that tells them.
    pub(crate) names: Option<&'static Names>,
    /// What process data may be made of.
    rules: Option<PdoRules>,
    has_complete_access: bool,
    /// The values of each object that keeps any, after start-up.
    defaults: Vec<Vec<Kept>>,
}

/// An object, and its entries that are kept, if it has any: then it has a field of its own.
struct Home<'a> {
    object: &'a Object,
    kept: Vec<&'a Entry>,
    field: u16,
}

impl Tables {
    /// Makes the tables of a device.
    pub(crate) fn new(device: &Device) -> &'static Self {
        let homes = homes(device);
        let mailbox = device.mailbox.as_ref();
        let has_names = mailbox.is_some_and(|mailbox| mailbox.sdo_info);
        let names = has_names.then(|| forever::value(table::names(&homes)));
        let kept = homes.iter().filter(|home| !home.kept.is_empty());
        let defaults = kept.map(|home| home.kept.iter().map(|entry| default(entry)).collect());
        forever::value(Self {
            dictionary: table::dictionary(&homes),
            ranges: rights::ranges(&homes),
            names,
            rules: rules::rules(device),
            has_complete_access: mailbox.is_some_and(|mailbox| mailbox.complete_access),
            defaults: defaults.collect(),
        })
    }
}

/// Every object with what it keeps; fields are counted in the order of the indices.
fn homes(device: &Device) -> Vec<Home<'_>> {
    let mut fields = 0..u16::MAX;
    let home = |object| {
        let kept = kept(device, object);
        let field = if kept.is_empty() { 0 } else { fields.next().unwrap_or(u16::MAX) };
        Home { object, kept, field }
    };
    device.objects.iter().map(home).collect()
}

/// The entries that are kept.
fn kept<'a>(device: &Device, object: &'a Object) -> Vec<&'a Entry> {
    object.entries.iter().filter(|entry| device.keeps(object, entry)).collect()
}

/// The value of an entry after start-up, as it is kept; nothing stands for 0.
fn default(entry: &Entry) -> Kept {
    let value = entry.default.as_ref();
    match (entry.data_type, entry.access) {
        (DataType::Bool | DataType::Bits(1), _) => {
            Kept::Bool(value.and_then(Value::integer).is_some_and(|value| value != 0))
        }
        (DataType::Text(_), Access::Ro | Access::Const) => match value {
            Some(Value::Text(text)) => Kept::Text(forever::text(text)),
            _ => Kept::Text(""),
        },
        _ => Kept::Bytes(bytes(entry)),
    }
}

/// The value of an entry after start-up as it travels.
fn bytes(entry: &Entry) -> Vec<u8> {
    entry.default.as_ref().unwrap_or(&Value::Integer(0)).little_endian(entry.data_type)
}
