//! What a dictionary says, as plain structs: each thing with its place in the file.

use std::fmt;
use std::rc::Rc;

use super::element::At;
use super::esi::Texts;
use crate::model::{Safety, SdoAccess, UnitCode};

/// An object of the dictionary with its type resolved into values.
#[derive(Debug, Default)]
pub(crate) struct Object {
    pub(crate) at: At,
    pub(crate) index: u16,
    pub(crate) name: Option<String>,
    pub(crate) names: Texts,
    pub(crate) comment: Option<String>,
    pub(crate) flags: Flags,
    pub(crate) properties: Vec<Property>,
    pub(crate) shape: Shape,
    pub(crate) values: Vec<Value>,
}

/// How the type of an object is declared.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    #[default]
    Var,
    Array,
    Record,
}

/// A value that an index and a subindex name.
#[derive(Debug, Default)]
pub(crate) struct Value {
    pub(crate) at: At,
    pub(crate) subindex: u8,
    pub(crate) name: Option<String>,
    pub(crate) names: Texts,
    /// What tools are to show instead of the name.
    pub(crate) display_name: Option<String>,
    pub(crate) comment: Option<String>,
    /// The basic type at the bottom of its type.
    pub(crate) type_name: String,
    pub(crate) bits: Option<u32>,
    pub(crate) choices: Rc<[Choice]>,
    pub(crate) flags: Flags,
    pub(crate) properties: Vec<Property>,
    pub(crate) default: Option<Datum>,
    pub(crate) min: Option<Datum>,
    pub(crate) max: Option<Datum>,
    /// What a step of it is: a power of ten of a unit.
    pub(crate) unit: Option<(&'static UnitCode, i8)>,
}

#[derive(Debug, Default, Clone, PartialEq)]
pub(crate) struct Choice {
    pub(crate) value: i64,
    pub(crate) name: String,
    pub(crate) names: Texts,
    pub(crate) comment: Option<String>,
}

/// Something that the vendor's tools are told.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub(crate) struct Property {
    pub(crate) name: String,
    pub(crate) value: Option<String>,
    pub(crate) about: Option<String>,
}

/// Who may do what with a value.
#[derive(Debug, Default, Clone, PartialEq, Eq)]
pub(crate) struct Flags {
    pub(crate) access: Option<String>,
    pub(crate) write_restrictions: Option<String>,
    pub(crate) category: Option<String>,
    pub(crate) pdo_mapping: Option<String>,
    pub(crate) safety: Option<Safety>,
    pub(crate) sdo_access: Option<SdoAccess>,
    pub(crate) backup: bool,
    pub(crate) setting: bool,
}

/// A value as it is written.
#[derive(Debug, Clone)]
pub(crate) struct Datum {
    pub(crate) at: At,
    pub(crate) written: Written,
}

/// The three ways to write a value.
#[derive(Debug, Clone)]
pub(crate) enum Written {
    /// Little-endian bytes.
    Data(Vec<u8>),
    /// A number.
    Number(String),
    /// Text.
    Text(String),
}

impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Data(bytes) => bytes.iter().try_for_each(|byte| write!(f, "{byte:02X}")),
            Self::Number(text) | Self::Text(text) => f.write_str(text),
        }
    }
}
