//! An object with its entries.

use super::Sheet;
use crate::model::{Access, DataType, Device, Entry, Kind, Mappable, Object, Value};

/// Object codes of CiA 301.
const VAR: u8 = 7;
const ARRAY: u8 = 8;
const RECORD: u8 = 9;

/// The section of an object, and those of its entries if it has several.
pub(super) fn object(device: &Device, object: &Object, sheet: &mut Sheet) {
    let index = format!("{:04X}", object.index.0);
    let name = device.on_axis(&object.name, object.axis);
    sheet.section(&index);
    sheet.key("ParameterName", &name);
    match object.entries.as_slice() {
        [only] if only.address.subindex == 0 => value(only, sheet),
        entries => {
            let code = if object.kind == Kind::Array { ARRAY } else { RECORD };
            sheet.key("ObjectType", format_args!("0x{code:X}"));
            sheet.key("SubNumber", entries.len());
            for entry in entries {
                sheet.section(format_args!("{index}sub{:X}", entry.address.subindex));
                sheet.key("ParameterName", &entry.name);
                value(entry, sheet);
            }
        }
    }
}

fn value(entry: &Entry, sheet: &mut Sheet) {
    sheet.key("ObjectType", format_args!("0x{VAR:X}"));
    sheet.key("DataType", format_args!("0x{:04X}", known(entry.data_type).code()));
    sheet.key("AccessType", access(entry));
    let text = |value: &Option<Value>| value.as_ref().map(|value| text(value, entry.data_type));
    for (key, value) in
        [("LowLimit", &entry.min), ("HighLimit", &entry.max), ("DefaultValue", &entry.default)]
    {
        if let Some(value) = text(value) {
            sheet.key(key, value);
        }
    }
    sheet.key("PDOMapping", u8::from(entry.pdo != Mappable::None));
}

/// The type that CiA 306 knows: a number of the width where it is one of bits.
fn known(data_type: DataType) -> DataType {
    match data_type {
        DataType::Bits(1) => DataType::Bool,
        DataType::Bits(_) => DataType::Uint(8),
        DataType::Bitstring(bits) => DataType::Uint(bits),
        other => other,
    }
}

/// What can be mapped and written says by which process data.
fn access(entry: &Entry) -> &'static str {
    match (entry.access, entry.pdo) {
        (Access::Ro, _) => "ro",
        (Access::Wo, _) => "wo",
        (Access::Const, _) => "const",
        (Access::Rw, Mappable::Rx) => "rww",
        (Access::Rw, Mappable::Tx) => "rwr",
        (Access::Rw, Mappable::None | Mappable::RxTx) => "rw",
    }
}

/// Numbers without a sign are hexadecimal, since there are readers that take mappings for nothing else.
fn text(value: &Value, data_type: DataType) -> String {
    match (value, data_type) {
        (Value::Text(_), DataType::Octets(_)) => {
            value.little_endian(data_type).iter().map(|byte| format!("{byte:02X}")).collect()
        }
        (_, DataType::Uint(bits) | DataType::Bitstring(bits) | DataType::Bits(bits)) => match value.integer()
        {
            Some(number) => format!("0x{number:0digits$X}", digits = usize::from(bits).div_ceil(4)),
            None => value.to_string(),
        },
        (Value::Boolean(value), _) => u8::from(*value).to_string(),
        _ => value.to_string(),
    }
}
