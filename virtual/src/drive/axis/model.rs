//! What the description says of an axis.

use devc::model::{self, Device, Field, Fields, Mode, Way};
use devc_runtime::cia402::HomingBits;
use devc_runtime::sdo::Dictionary;

use super::roles::{Finder, Roles};
use super::scale::{self, Scales};
use crate::drive::dictionary::Number;

/// What the firmware has to know of an axis.
#[derive(Debug)]
pub(crate) struct AxisModel {
    pub(crate) name: String,
    pub(super) roles: Roles,
    pub(super) scales: Scales,
    /// The unit of the position, and how much of it a step is.
    pub(super) unit: Option<(String, f64)>,
    pub(super) modes: Vec<ModeModel>,
    /// The bits of the statusword that mean the same in every mode, by the word for each.
    pub(super) status_bits: Vec<(u16, String)>,
    /// The homing methods, by each number of theirs, with the direction in which they start.
    pub(super) homing_methods: Vec<(i8, Option<Way>)>,
    /// What the bits of homing are, and whether the statusword shows them in every mode.
    pub(super) homing_bits: HomingBits,
}

/// A mode of operation on an axis.
#[derive(Debug)]
pub(super) struct ModeModel {
    /// Its code in CiA 402; a device may take others for it.
    pub(super) code: i16,
    codes: Vec<i16>,
    pub(super) name: String,
    pub(super) target_position: Option<Number>,
    /// The bits of the controlword and of the statusword that have a meaning in it.
    pub(super) control_bits: u16,
    pub(super) status_bits: u16,
    /// The bits that move the axis by hand, forwards and backwards, in a vendor's own mode that has such.
    pub(super) jog: Option<[u16; 2]>,
}

impl AxisModel {
    pub(crate) fn new(device: &Device, table: &Dictionary, axis: &model::Axis) -> Self {
        let finder = Finder { device, table, axis: axis.number };
        let statusword = word(device, 0x6041);
        let control = mask(word(device, 0x6040).filter(|field| is_general(field)));
        let methods = device.homing_methods.iter().flat_map(|method| {
            let numbers = std::iter::once(method.number).chain(method.aliases.iter().copied());
            numbers.map(|number| (number, method.direction))
        });
        Self {
            name: axis.name.clone(),
            roles: Roles::new(&finder),
            scales: Scales::new(&finder),
            unit: scale::unit(&finder),
            modes: device.modes.iter().map(|mode| ModeModel::new(&finder, mode, control)).collect(),
            status_bits: statusword
                .filter(|field| is_general(field))
                .map(|field| (bit(field.low), field.id.clone()))
                .collect(),
            homing_methods: methods.collect(),
            homing_bits: homing_bits(device),
        }
    }

    /// The mode that a code selects.
    pub(super) fn mode(&self, code: i8) -> Option<&ModeModel> {
        self.modes.iter().find(|mode| mode.codes.contains(&code.into()))
    }

    /// Whether a bit of the statusword means the same in every mode.
    pub(super) fn is_general(&self, bits: u16) -> bool {
        self.status_bits.iter().any(|(of, _)| of & bits != 0)
    }

    /// The bit of the statusword that has this word in every mode; 0 if none has.
    pub(super) fn status_bit(&self, id: &str) -> u16 {
        self.status_bits.iter().filter(|(_, of)| of == id).fold(0, |all, (bit, _)| all | bit)
    }
}

impl ModeModel {
    fn new(finder: &Finder<'_>, mode: &Mode, general: u16) -> Self {
        let used = |fields: &Fields| mask(fields.iter().filter(|field| !field.reserved));
        let reserved = mask(mode.control_bits.iter().filter(|field| field.reserved));
        Self {
            code: mode.code,
            codes: std::iter::once(mode.code).chain(mode.aliases.iter().copied()).collect(),
            name: mode.name.clone(),
            target_position: finder.target_position(mode),
            control_bits: used(&mode.control_bits) | general & !reserved,
            status_bits: used(&mode.status_bits),
            jog: jog(mode),
        }
    }
}

/// The bits of a mode whose names say that they jog.
fn jog(mode: &Mode) -> Option<[u16; 2]> {
    let find = |id: &str| mode.control_bits.iter().find(|field| field.id == id).map(|field| bit(field.low));
    Some([find("jog-positive")?, find("jog-negative")?])
}

/// The fields of the word at an index of the first axis.
fn word(device: &Device, index: u16) -> impl Iterator<Item = &Field> {
    let words = device.words.iter().filter(move |word| word.address.index.0 == index);
    words.flat_map(|word| word.fields.iter())
}

fn is_general(field: &Field) -> bool {
    !field.reserved && !field.per_mode
}

fn bit(number: u8) -> u16 {
    1_u16.checked_shl(number.into()).unwrap_or(0)
}

fn mask<'a>(fields: impl Iterator<Item = &'a Field>) -> u16 {
    fields.fold(0, |mask, field| mask | (field.low..=field.high).fold(0, |bits, place| bits | bit(place)))
}

/// The bits of homing; those of CiA 402 where the description has none.
fn homing_bits(device: &Device) -> HomingBits {
    let bits = device.modes.iter().find_map(|mode| mode.homing_bits);
    bits.map_or(HomingBits::PROFILE, |bits| HomingBits {
        start: bit(bits.start),
        reached: bit(bits.reached),
        attained: bit(bits.attained),
        error: bit(bits.error),
    })
}
