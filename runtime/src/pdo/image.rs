//! Images: all process data of a direction, and which PDOs a device lets it be made of.

use super::{MappedPdo, Pdo, ProcessData};
use crate::Family;
use crate::text::Text;

/// What a device carries one way each cycle: PDOs one after the other.
///
/// `#[derive(ProcessImage)]` makes it of a struct whose fields are PDOs, or arrays of the PDOs of axes. A selection
/// that the device forbids does not compile.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no process image",
    note = "`#[derive(ProcessImage)]` makes one of a struct of PDOs"
)]
pub trait ProcessImage: ProcessData {
    /// The PDOs, in order: what the assignment object of the direction has to name.
    const PDOS: &'static [MappedPdo];
}

/// The same device: that of all PDOs in an image.
#[diagnostic::on_unimplemented(
    message = "a PDO of `{Self}` in an image of `{Of}`",
    label = "another device's than the first field"
)]
pub trait SameDevice<Of> {}

impl<D> SameDevice<D> for D {}

/// The same direction: that of all PDOs in an image.
#[diagnostic::on_unimplemented(
    message = "a {Self} PDO in an image of {As} PDOs",
    label = "goes the other way than the first field"
)]
pub trait SameDirection<As> {}

impl<Way> SameDirection<Way> for Way {}

/// A PDO in an image that begins with `First`, for an axis by number; refuses an axis that has none.
///
/// For the derive, which calls it in a constant.
#[track_caller]
pub const fn selected<First, P>(axis: u8) -> MappedPdo
where
    First: ProcessData,
    P: Pdo,
    P::Device: SameDevice<First::Device>,
    P::Direction: SameDirection<First::Direction>,
{
    of_axis::<P>(axis)
}

/// The PDO of an axis, by number; refuses an axis that has none, so it is for constants.
#[track_caller]
pub const fn of_axis<P: Pdo>(axis: u8) -> MappedPdo {
    match P::ALL.split_at_checked(axis as usize) {
        Some((_, [pdo, ..])) => MappedPdo { members: P::MEMBERS, ..*pdo },
        _ => refuse(
            Text::new()
                .text("there is no axis ")
                .number(axis as usize)
                .text(": ")
                .hex(P::INDEX)
                .text(" is that of the first of ")
                .number(P::ALL.len()),
        ),
    }
}

/// Refuses a field of an image that cannot be together with what is before it: `at` is its place among the PDOs.
///
/// For the derive, which calls it for each field in a constant.
#[track_caller]
pub const fn check_pdo<I: ProcessImage>(at: usize)
where
    I::Device: Family,
{
    let Some((before, [pdo, ..])) = I::PDOS.split_at_checked(at) else { return };
    let (mut members, mut fault) = (<I::Device as Family>::MEMBERS, None);
    while let Some((member, rest)) = members.split_first() {
        if member.has(before) && member.has(&[*pdo]) {
            match member.pair_fault::<I::Direction>(before, *pdo) {
                None => return,
                other => fault = if fault.is_some() { fault } else { other },
            }
        }
        members = rest;
    }
    match fault {
        Some(text) => refuse(text),
        None => refuse(Text::new().text("no device has ").hex(pdo.index).text(" and what is before it")),
    }
}

/// Refuses an image that lacks something, or that is too much: one that no device takes which has its PDOs.
///
/// For the derive, which calls it in a constant.
#[track_caller]
pub const fn check_image<I: ProcessImage>()
where
    I::Device: Family,
{
    let (mut members, mut fault) = (<I::Device as Family>::MEMBERS, None);
    while let Some((member, rest)) = members.split_first() {
        if member.has(I::PDOS) {
            match member.image_fault::<I>() {
                None => return,
                other => fault = if fault.is_some() { fault } else { other },
            }
        }
        members = rest;
    }
    if let Some(text) = fault {
        refuse(text)
    }
}

/// Ends compilation with a text.
#[track_caller]
#[expect(clippy::panic, reason = "it is called in constants only, where a panic is an error of the compiler")]
pub(crate) const fn refuse(text: Text) -> ! {
    panic!("{}", text.as_str())
}
