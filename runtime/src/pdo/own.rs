//! Own mappings: what is put into a PDO whose mapping is free.

use super::image::refuse;
use super::{Direction, MappedPdo, Mapping, Members, Pdo, Rx, Tx};
use crate::object::{Entry, Value};
use crate::text::Text;
use crate::unit::Measurand;

/// What a user may put into a PDO. The module of a device has a type for each whose mapping is free, such as
/// `FreeRxPdo1600`; `#[derive(Pdo)]` makes process data of it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no PDO whose mapping is free",
    note = "the module of a device has a type for each that it lets a master map, such as `FreeRxPdo1600`"
)]
pub trait MappingObject {
    /// The device that has it, or the family of those that have it.
    type Device;
    /// Which way it goes.
    type Direction: Direction;
    /// The mapping object of each axis, or the only one.
    const INDICES: &'static [u16];
    /// Whether a master may map it.
    const IS_FREE: bool = true;
    /// The largest number of bytes, if the description says.
    const MAX_BYTES: Option<u16>;
    /// The largest number of entries, if the description says.
    const MAX_ENTRIES: Option<u8>;
    /// The members of the family that have it.
    const MEMBERS: Members = Members::ALL;
}

/// The PDOs that are mapped already: who names one of them is told so once, not wherever it would have to be free.
impl<P: Pdo> MappingObject for P {
    type Device = P::Device;
    type Direction = P::Direction;
    const INDICES: &'static [u16] = &[P::INDEX];
    const IS_FREE: bool = false;
    const MAX_BYTES: Option<u16> = None;
    const MAX_ENTRIES: Option<u8> = None;
    const MEMBERS: Members = P::MEMBERS;
}

/// An entry that is in no PDO.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unmapped {}

/// An entry that may be in PDOs of either direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RxTx {}

/// An entry that may be mapped to PDOs that go this way (CiA 301, PDO mapping of an object).
#[diagnostic::on_unimplemented(
    message = "this entry cannot be mapped to a {Way} PDO",
    label = "not to be mapped here",
    note = "by the description its mapping is `{Self}`"
)]
pub trait MapsTo<Way> {}

impl MapsTo<Rx> for Rx {}
impl MapsTo<Tx> for Tx {}
impl MapsTo<Rx> for RxTx {}
impl MapsTo<Tx> for RxTx {}

/// The entry as what is mapped to a free PDO: it has to be of the same device, to have the field's type, and to be
/// one that may be mapped this way.
pub const fn mapped<F: MappingObject, T: Value, A, M: MapsTo<F::Direction>>(
    entry: Entry<F::Device, T, A, M, impl Measurand>,
) -> Mapping {
    Mapping { address: entry.address(), bits: T::BITS as u8 }
}

/// Refuses what is mapped beyond the limits: up to here there are so many entries with so many bits.
///
/// For the derive, which calls it for each field and for the gap behind them in a constant.
#[track_caller]
pub const fn check_entry<F: MappingObject>(entries: usize, bits: usize) {
    let Some(index) = F::INDICES.first() else { return };
    let bytes = bits.div_ceil(8);
    if let Some(max) = F::MAX_BYTES
        && bytes > max as usize
    {
        let text = Text::new().text("with this the PDO has ").number(bytes).text(" bytes, ");
        refuse(text.hex(*index).text(" takes ").number(max as usize));
    }
    if let Some(max) = F::MAX_ENTRIES
        && entries > max as usize
    {
        let text = Text::new().text("with this the PDO has ").number(entries).text(" entries, ");
        refuse(text.hex(*index).text(" takes ").number(max as usize));
    }
}

/// Refuses a mapping of a PDO that is fixed, and one that is for one axis if there is a PDO for each.
///
/// For the derive, which calls it in a constant.
#[track_caller]
pub const fn check_mapping<F: MappingObject>(axes: usize) {
    if !F::IS_FREE {
        let text = Text::new().list(F::INDICES);
        refuse(text.text(
            " has a fixed mapping; the module has a type for each that is free, such as `FreeRxPdo1600`",
        ));
    }
    if F::INDICES.len() != axes {
        let text = Text::new().text("each axis has this PDO: ").list(F::INDICES);
        refuse(text.text("; map it with `per_axis`"));
    }
}

/// The PDO of each axis with its own mapping.
pub const fn own<F: MappingObject, const FIELDS: usize, const AXES: usize>(
    table: &'static [[Mapping; FIELDS]; AXES],
) -> [MappedPdo; AXES] {
    let mut pdos = [MappedPdo::own(0, &[]); AXES];
    let mut places: &mut [MappedPdo] = &mut pdos;
    let (mut indices, mut rows) = (F::INDICES, table.as_slice());
    while let (Some((place, others)), Some((index, left)), Some((row, below))) =
        (places.split_first_mut(), indices.split_first(), rows.split_first())
    {
        *place = MappedPdo { members: F::MEMBERS, ..MappedPdo::own(*index, row) };
        (places, indices, rows) = (others, left, below);
    }
    pdos
}
