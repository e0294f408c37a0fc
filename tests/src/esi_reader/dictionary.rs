//! The object dictionary: types, objects, and the values that the two make together.

use std::collections::BTreeMap;

use super::node::{
    Node, children, complaint, english, number, only, optional, optional_bytes, optional_number,
    optional_text, text,
};

/// An object dictionary.
#[derive(Debug)]
pub struct Dictionary {
    /// The types by name.
    pub types: BTreeMap<String, DataType>,
    /// The objects as they stand in the file.
    pub objects: Vec<Object>,
}

/// A type.
#[derive(Debug)]
pub struct DataType {
    /// The type below, for an array or an enumeration.
    pub base: Option<String>,
    /// The width in bits.
    pub bits: u32,
    /// The first element and the number of elements, for an array.
    pub array: Option<(u32, u32)>,
    /// The members, for a record or what holds an array.
    pub items: Vec<SubItem>,
    /// Values with their meanings, for an enumeration.
    pub choices: Vec<(i64, String)>,
}

/// A member of a type.
#[derive(Debug)]
pub struct SubItem {
    /// Its subindex; none if it stands for all elements of an array.
    pub subindex: Option<u8>,
    /// Its name.
    pub name: String,
    /// What people should know.
    pub comment: Option<String>,
    /// Its type.
    pub type_name: String,
    /// The width in bits.
    pub bits: u32,
    /// The first bit.
    pub offset: u32,
    /// Who may do what with it.
    pub flags: Flags,
}

/// Who may do what with a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Flags {
    /// `ro`, `wo` or `rw`.
    pub access: String,
    /// The only states in which it can be written.
    pub write_restrictions: Option<String>,
    /// `m`, `o` or `c`.
    pub category: Option<String>,
    /// `T`, `R` or both.
    pub pdo_mapping: Option<String>,
    /// Whether a backup holds it, and whether it is a setting.
    pub kept: (Option<u8>, Option<u8>),
}

/// An object.
#[derive(Debug)]
pub struct Object {
    /// Its index.
    pub index: u16,
    /// Its name.
    pub name: String,
    /// What people should know.
    pub comment: Option<String>,
    /// Its type.
    pub type_name: String,
    /// The width in bits.
    pub bits: u32,
    /// Its values.
    pub info: Info,
    /// Who may do what with it.
    pub flags: Flags,
}

/// Values of an object or of a part of it.
#[derive(Debug, Clone, Default)]
pub struct Info {
    /// The least value.
    pub min: Option<Vec<u8>>,
    /// The greatest value.
    pub max: Option<Vec<u8>>,
    /// The value after start-up.
    pub default: Option<Vec<u8>>,
    /// The parts with their names.
    pub parts: Vec<(String, Info)>,
}

/// A value that an index and a subindex name.
#[derive(Debug)]
pub struct Value {
    /// The object.
    pub index: u16,
    /// The entry.
    pub subindex: u8,
    /// Its name.
    pub name: String,
    /// The basic type at the bottom of its type.
    pub basic_type: String,
    /// Values with their meanings.
    pub choices: Vec<(i64, String)>,
    /// The width in bits.
    pub bits: u32,
    /// The first bit within the object.
    pub offset: u32,
    /// Who may do what with it.
    pub flags: Flags,
    /// Limits and default.
    pub info: Info,
}

impl Dictionary {
    /// All values of an object, as a tool would list them.
    ///
    /// # Errors
    /// If a type is not declared, or type and object do not fit together.
    pub fn values(&self, object: &Object) -> Result<Vec<Value>, String> {
        let declared = self.type_of(&object.type_name)?;
        if declared.items.is_empty() {
            return Ok(vec![self.value(
                object,
                0,
                &object.name,
                &object.type_name,
                0,
                &object.flags,
                &object.info,
            )?]);
        }
        let mut places = Vec::new();
        for item in &declared.items {
            places.extend(self.places(item)?);
        }
        let parts = &object.info.parts;
        if places.len() != parts.len() {
            return Err(format!("{:04X}: {} members, {} values", object.index, places.len(), parts.len()));
        }
        let pairs = places.into_iter().zip(parts);
        pairs
            .map(|(place, (name, info))| {
                if place.own_name.is_some_and(|own| own != name) {
                    return Err(format!(
                        "{:04X}: member {:?} has a value {name}",
                        object.index, place.own_name
                    ));
                }
                let Place { subindex, type_name, offset, flags, .. } = place;
                self.value(object, subindex, name, type_name, offset, flags, info)
            })
            .collect()
    }

    fn places<'a>(&'a self, item: &'a SubItem) -> Result<Vec<Place<'a>>, String> {
        let place = |subindex, own_name, type_name, offset| Place {
            subindex,
            own_name,
            type_name,
            offset,
            flags: &item.flags,
        };
        if let Some(subindex) = item.subindex {
            return Ok(vec![place(subindex, Some(item.name.as_str()), &item.type_name, item.offset)]);
        }
        let array = self.type_of(&item.type_name)?;
        let (Some(base), Some((1, elements))) = (array.base.as_deref(), array.array) else {
            return Err(format!("{} has no subindex and is no array from 1 on", item.name));
        };
        let step = array.bits / elements;
        (1..=elements)
            .map(|element| {
                let subindex = u8::try_from(element).map_err(|error| error.to_string())?;
                Ok(place(subindex, None, base, item.offset + (element - 1) * step))
            })
            .collect()
    }

    #[expect(clippy::too_many_arguments, reason = "the parts of a value come from three places")]
    fn value(
        &self,
        object: &Object,
        subindex: u8,
        name: &str,
        type_name: &str,
        offset: u32,
        flags: &Flags,
        info: &Info,
    ) -> Result<Value, String> {
        let declared = self.type_of(type_name)?;
        Ok(Value {
            index: object.index,
            subindex,
            name: name.to_owned(),
            basic_type: declared.base.clone().unwrap_or_else(|| type_name.to_owned()),
            choices: declared.choices.clone(),
            bits: declared.bits,
            offset,
            flags: flags.clone(),
            info: info.clone(),
        })
    }

    fn type_of(&self, name: &str) -> Result<&DataType, String> {
        self.types.get(name).ok_or_else(|| format!("the type {name} is not declared"))
    }
}

/// A place that a type has for a value.
struct Place<'a> {
    subindex: u8,
    own_name: Option<&'a str>,
    type_name: &'a str,
    offset: u32,
    flags: &'a Flags,
}

pub(super) fn read(node: Node<'_, '_>) -> Result<Dictionary, String> {
    let mut types = BTreeMap::new();
    for node in children(only(node, "DataTypes")?, "DataType") {
        if types.insert(text(node, "Name")?, data_type(node)?).is_some() {
            return Err(complaint(node, "is declared twice"));
        }
    }
    let objects = children(only(node, "Objects")?, "Object").map(object).collect::<Result<_, _>>()?;
    Ok(Dictionary { types, objects })
}

fn data_type(node: Node<'_, '_>) -> Result<DataType, String> {
    let array = optional(node, "ArrayInfo")?;
    Ok(DataType {
        base: optional_text(node, "BaseType")?,
        bits: number(node, "BitSize")?,
        array: array
            .map(|array| Ok::<_, String>((number(array, "LBound")?, number(array, "Elements")?)))
            .transpose()?,
        items: children(node, "SubItem").map(sub_item).collect::<Result<_, _>>()?,
        choices: children(node, "EnumInfo").map(choice).collect::<Result<_, _>>()?,
    })
}

fn sub_item(node: Node<'_, '_>) -> Result<SubItem, String> {
    Ok(SubItem {
        subindex: optional_number(node, "SubIdx")?,
        name: text(node, "Name")?,
        comment: optional_text(node, "Comment")?,
        type_name: text(node, "Type")?,
        bits: number(node, "BitSize")?,
        offset: number(node, "BitOffs")?,
        flags: flags(only(node, "Flags")?)?,
    })
}

fn choice(node: Node<'_, '_>) -> Result<(i64, String), String> {
    Ok((number(node, "Enum")?, english(node, "Text")?))
}

fn object(node: Node<'_, '_>) -> Result<Object, String> {
    Ok(Object {
        index: number(node, "Index")?,
        name: english(node, "Name")?,
        comment: optional_text(node, "Comment")?,
        type_name: text(node, "Type")?,
        bits: number(node, "BitSize")?,
        info: optional(node, "Info")?.map(info).transpose()?.unwrap_or_default(),
        flags: flags(only(node, "Flags")?)?,
    })
}

fn info(node: Node<'_, '_>) -> Result<Info, String> {
    let part = |node| Ok::<_, String>((text(node, "Name")?, info(only(node, "Info")?)?));
    Ok(Info {
        min: optional_bytes(node, "MinData")?,
        max: optional_bytes(node, "MaxData")?,
        default: optional_bytes(node, "DefaultData")?,
        parts: children(node, "SubItem").map(part).collect::<Result<_, _>>()?,
    })
}

fn flags(node: Node<'_, '_>) -> Result<Flags, String> {
    let access = only(node, "Access")?;
    Ok(Flags {
        access: access.text().unwrap_or_default().to_owned(),
        write_restrictions: access.attribute("WriteRestrictions").map(str::to_owned),
        category: optional_text(node, "Category")?,
        pdo_mapping: optional_text(node, "PdoMapping")?,
        kept: (optional_number(node, "Backup")?, optional_number(node, "Setting")?),
    })
}
