//! PDOs as types.

use devc_start_up::{Mapping, Members};

use super::ProcessData;

/// A single PDO: process data that has an index of its own.
///
/// Where each axis has a PDO of the same shape, there is one type for all, so that a program can go through the axes;
/// the constants are those of the first axis, and the generated type tells the others.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no PDO",
    note = "PDOs are in the module of a device, or structs with `#[derive(Pdo)]`"
)]
pub trait Pdo: ProcessData {
    /// The mapping object, 0x1600 on for received and 0x1A00 on for transmitted PDOs (CiA 301).
    const INDEX: u16;
    /// What is mapped, in order, each as the mapping object holds it: index, subindex and number of bits.
    const MAPPING: &'static [Mapping];

    /// The PDO of each axis, or the only one, with what is mapped to it.
    const ALL: &'static [MappedPdo] = &[MappedPdo::new(Self::INDEX, Self::MAPPING)];

    /// The members of the family that have it.
    const MEMBERS: Members = Members::ALL;
}

/// A PDO with what is mapped to it.
pub type MappedPdo = devc_start_up::MappedPdo<'static>;
