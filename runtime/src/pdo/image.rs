//! Images: all process data of a direction, and which PDOs a device lets it be made of.

use super::{Direction, MappedPdo, Pdo, ProcessData};
use crate::Device;
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

/// A device that has process data this way.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no process data in direction `{Way}`",
    note = "the description has no sync manager for it"
)]
pub trait Carries<Way: Direction>: Device {
    /// What it lets a master assign.
    const SYNC_MANAGER: SyncManager;
}

/// What may be assigned to a sync manager (ETG.1000.6, sync manager PDO assignment).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SyncManager {
    /// The PDOs that are assigned if nobody changes it, by index.
    pub default: &'static [u16],
    /// Whether a master may write the assignment object.
    pub assignable: bool,
    /// The largest number of PDOs at once.
    pub slots: u8,
    /// The longest image in bytes, if the description says.
    pub max_size: Option<u16>,
    /// PDOs that have to be there.
    pub mandatory: &'static [u16],
    /// Pairs of PDOs of which one has to be left out.
    pub exclusive: &'static [[u16; 2]],
}

impl SyncManager {
    /// Whether two PDOs cannot be assigned together.
    pub const fn excludes(&self, one: u16, other: u16) -> bool {
        has_pair(self.exclusive, one, other)
    }
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
    MappedPdo::of_axis::<P>(axis)
}

/// Refuses a field of an image that cannot be together with what is before it: `at` is its place among the PDOs.
///
/// For the derive, which calls it for each field in a constant.
#[track_caller]
pub const fn check_pdo<I: ProcessImage>(at: usize)
where
    I::Device: Carries<I::Direction>,
{
    let manager = <I::Device as Carries<I::Direction>>::SYNC_MANAGER;
    let (before, rest) = I::PDOS.split_at(at);
    let Some(pdo) = rest.first() else { return };
    let mut others = before;
    while let Some((other, rest)) = others.split_first() {
        if other.index == pdo.index {
            refuse(Text::new().hex(pdo.index).text(" is in the image twice"));
        }
        if manager.excludes(other.index, pdo.index) {
            refuse(
                Text::new()
                    .hex(other.index)
                    .text(" and ")
                    .hex(pdo.index)
                    .text(" cannot be assigned together"),
            );
        }
        others = rest;
    }
}

/// Refuses an image that lacks something, or that is too much for the device.
///
/// For the derive, which calls it in a constant.
#[track_caller]
pub const fn check_image<I: ProcessImage>()
where
    I::Device: Carries<I::Direction>,
{
    let manager = <I::Device as Carries<I::Direction>>::SYNC_MANAGER;
    let (count, slots) = (I::PDOS.len(), manager.slots as usize);
    if !manager.assignable && !is_default(manager.default, I::PDOS) {
        let text = Text::new().text("the device does not let its assignment be changed: it is ");
        refuse(text.list(manager.default));
    }
    if count > slots {
        refuse(Text::new().number(count).text(" PDOs are in the image, the device takes ").number(slots));
    }
    if let Some(max) = manager.max_size
        && I::LEN > max as usize
    {
        let text = Text::new().text("the image has ").number(I::LEN).text(" bytes, the device takes ");
        refuse(text.number(max as usize));
    }
    let mut mandatory = manager.mandatory;
    while let Some((index, rest)) = mandatory.split_first() {
        if !has(I::PDOS, *index) {
            refuse(Text::new().hex(*index).text(" is missing, the device does not do without it"));
        }
        mandatory = rest;
    }
}

/// Ends compilation with a text.
#[track_caller]
#[expect(clippy::panic, reason = "it is called in constants only, where a panic is an error of the compiler")]
pub(crate) const fn refuse(text: Text) -> ! {
    panic!("{}", text.as_str())
}

const fn has(mut pdos: &[MappedPdo], index: u16) -> bool {
    while let Some((pdo, rest)) = pdos.split_first() {
        if pdo.index == index {
            return true;
        }
        pdos = rest;
    }
    false
}

const fn has_pair(mut pairs: &[[u16; 2]], one: u16, other: u16) -> bool {
    while let Some(([a, b], rest)) = pairs.split_first() {
        if (*a == one && *b == other) || (*a == other && *b == one) {
            return true;
        }
        pairs = rest;
    }
    false
}

const fn is_default(mut default: &[u16], mut pdos: &[MappedPdo]) -> bool {
    while let (Some((index, others)), Some((pdo, rest))) = (default.split_first(), pdos.split_first()) {
        if *index != pdo.index {
            return false;
        }
        (default, pdos) = (others, rest);
    }
    default.is_empty() && pdos.is_empty()
}
