//! PDOs, and what of them is transferred together.

use serde::Serialize;

use super::names::Names;
use super::value::{self, Kind};
use crate::emit::escape::prose;
use crate::emit::steps;
use crate::model::{Configuration, Device, Direction, Mapped, Pdo as Described, Role};

/// Process data that there can be.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Selection {
    /// The configuration that chooses it; none by default.
    pub(in crate::emit) configuration: Option<String>,
    /// The PDOs that are mapped as nowhere before.
    pub(in crate::emit) pdos: Vec<Pdo>,
    /// What is transferred: outputs, then inputs, as far as they are chosen here.
    pub(in crate::emit) images: Vec<Image>,
}

/// A PDO.
#[derive(Debug, Clone, Serialize)]
pub(in crate::emit) struct Pdo {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) is_output: bool,
    pub(in crate::emit) bits: u32,
    pub(in crate::emit) bytes: u32,
    /// What is in it; gaps are left out.
    pub(in crate::emit) fields: Vec<Field>,
    /// All that is mapped, with gaps.
    pub(in crate::emit) mapping: Vec<Mapping>,
}

/// A field of a PDO.
#[derive(Debug, Clone, Serialize)]
pub(in crate::emit) struct Field {
    pub(in crate::emit) name: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) unit: Option<String>,
    pub(in crate::emit) kind: Kind,
    /// The width of its value.
    pub(in crate::emit) width: u32,
    /// The first bit in the PDO.
    pub(in crate::emit) offset: u32,
    /// The bits that it has there.
    pub(in crate::emit) bits: u32,
}

/// What a mapping object says.
#[derive(Debug, Clone, Serialize)]
pub(in crate::emit) struct Mapping {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) subindex: u8,
    pub(in crate::emit) bits: u32,
}

/// PDOs one behind the other.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Image {
    pub(in crate::emit) global: String,
    pub(in crate::emit) is_output: bool,
    pub(in crate::emit) bytes: u32,
    pub(in crate::emit) parts: Vec<Part>,
}

/// A PDO in an image.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Part {
    pub(in crate::emit) name: String,
    /// The first bit in the image.
    pub(in crate::emit) offset: u32,
    pub(in crate::emit) pdo: Pdo,
}

/// All of them.
pub(super) fn selections(device: &Device, names: &mut Names) -> Vec<Selection> {
    let pdos: Vec<Pdo> = device.pdos.iter().map(|it| pdo(device, it, None, names)).collect();
    let images = [Direction::Rx, Direction::Tx].into_iter().filter_map(|way| {
        let chosen: Vec<&Pdo> = device
            .assigned(Role::of(way))
            .filter_map(|it| pdos.iter().find(|pdo| pdo.index == it.index.0))
            .collect();
        image(None, way, &chosen, names)
    });
    let images = images.collect();
    let mut selections = vec![Selection { configuration: None, pdos, images }];
    for configuration in &device.configurations {
        let known = selections.first().map_or(&[][..], |first| &first.pdos);
        let chosen = chosen(device, configuration, known, names);
        selections.extend(chosen);
    }
    selections
}

/// What a configuration chooses, if it chooses any process data.
fn chosen(device: &Device, of: &Configuration, known: &[Pdo], names: &mut Names) -> Option<Selection> {
    let pdos: Vec<Pdo> = of.mapping.iter().map(|it| pdo(device, it, Some(&of.id), names)).collect();
    let mut images = Vec::new();
    for way in [Direction::Rx, Direction::Tx] {
        let remapped = of.mapping.iter().any(|pdo| pdo.direction == way);
        let indices: Vec<u16> = match of.assigned(way) {
            Some(indices) => indices.iter().map(|index| index.0).collect(),
            None if remapped => device.assigned(Role::of(way)).map(|pdo| pdo.index.0).collect(),
            None => continue,
        };
        let find = |index: &u16| pdos.iter().chain(known).find(|pdo| pdo.index == *index);
        let parts: Vec<&Pdo> = indices.iter().filter_map(find).collect();
        images.extend(image(Some(&of.id), way, &parts, names));
    }
    let nothing = pdos.is_empty() && images.is_empty();
    (!nothing).then(|| Selection { configuration: Some(prose(&of.name)), pdos, images })
}

fn word(way: Direction) -> &'static str {
    match way {
        Direction::Rx => "rx",
        Direction::Tx => "tx",
    }
}

fn pdo(device: &Device, of: &Described, configuration: Option<&str>, names: &mut Names) -> Pdo {
    let index = format!("{:04x}", of.index.0);
    let global = names.global(&[configuration.unwrap_or_default(), word(of.direction), &index]);
    names.reserve(&global, &["index", "bytes", "pack", "unpack"]);
    let mut siblings = names.siblings();
    let fields = of.entries.iter().filter(|mapped| mapped.address.is_some());
    let fields = fields.map(|mapped| field(device, of, mapped, siblings.claim(&mapped.id))).collect();
    let mapping = of.entries.iter().map(|mapped| Mapping {
        index: mapped.address.map_or(0, |address| address.index.0),
        subindex: mapped.address.map_or(0, |address| address.subindex),
        bits: mapped.bits,
    });
    Pdo {
        index: of.index.0,
        global,
        title: prose(&device.on_axis(&of.name, of.axis)),
        is_output: of.direction == Direction::Rx,
        bits: of.bits(),
        bytes: of.bytes(),
        fields,
        mapping: mapping.collect(),
    }
}

fn field(device: &Device, of: &Described, mapped: &Mapped, name: String) -> Field {
    let (kind, width) = value::of(device, mapped);
    let entry = mapped.address.and_then(|address| device.entry(address));
    let unit = entry.and_then(|entry| device.unit(entry.unit.as_deref()?));
    let address = mapped.address.map(|address| format!("{address} ")).unwrap_or_default();
    Field {
        name,
        title: prose(&format!("{address}{}", mapped.name)),
        unit: unit.and_then(|unit| steps::on(unit, of.axis)).map(|unit| prose(&unit)),
        kind,
        width,
        offset: mapped.offset,
        bits: mapped.bits,
    }
}

fn image(configuration: Option<&str>, way: Direction, pdos: &[&Pdo], names: &mut Names) -> Option<Image> {
    if pdos.is_empty() {
        return None;
    }
    let mut siblings = names.siblings();
    let mut offset = 0;
    let mut parts = Vec::new();
    for pdo in pdos {
        let name = siblings.claim(&format!("{}-{:04x}", word(way), pdo.index));
        parts.push(Part { name, offset, pdo: (*pdo).clone() });
        offset += pdo.bits;
    }
    let is_output = way == Direction::Rx;
    let global =
        names.global(&[configuration.unwrap_or_default(), if is_output { "outputs" } else { "inputs" }]);
    names.reserve(&global, &["bytes", "pack", "unpack"]);
    Some(Image { global, is_output, bytes: offset.div_ceil(8), parts })
}
