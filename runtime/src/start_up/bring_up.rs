//! What of a device bears on its bring-up.

#[cfg(test)]
mod tests;

use devc_start_up::{AxisObjects, CycleLimit, Way};

use crate::pdo::{Direction, MappedPdo, ProcessImage, Rx, SyncManager};
use crate::text::Text;

/// What of a device bears on its bring-up, and on what process data it takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BringUp {
    /// The name of the device.
    pub name: &'static str,
    /// Its place in its family.
    pub member: u16,
    /// What may be assigned to what the master sends; none if there is no sync manager for it.
    pub outputs: Option<SyncManager>,
    /// What may be assigned to what the device sends.
    pub inputs: Option<SyncManager>,
    /// Whether a master may write mapping objects.
    pub maps: bool,
    /// The objects of each axis that does something with them.
    pub axes: &'static [AxisObjects],
    /// The cycle times that the device takes, for one use or another; any if none are told.
    pub cycles: &'static [CycleLimit<'static>],
}

impl BringUp {
    /// Whether the device takes an image: has its PDOs, and lets them be assigned together.
    ///
    /// ```ignore
    /// const _: () = assert!(s700::s400::BRING_UP.takes::<Outputs>());
    /// ```
    pub const fn takes<I: ProcessImage>(&self) -> bool {
        let mut place = 0;
        while let Some((before, [pdo, ..])) = I::PDOS.split_at_checked(place) {
            if !self.has(&[*pdo]) || self.pair_fault::<I::Direction>(before, *pdo).is_some() {
                return false;
            }
            place += 1;
        }
        self.image_fault::<I>().is_none()
    }

    /// Whether the device has these PDOs.
    pub(crate) const fn has(&self, mut pdos: &[MappedPdo]) -> bool {
        while let Some((pdo, rest)) = pdos.split_first() {
            if !pdo.members.has(self.member) {
                return false;
            }
            pdos = rest;
        }
        true
    }

    /// What is wrong with a PDO behind others, if anything is.
    pub(crate) const fn pair_fault<Way: Direction>(
        &self,
        others: &[MappedPdo],
        pdo: MappedPdo,
    ) -> Option<Text> {
        match self.manager::<Way>() {
            Some(manager) => manager.pair_fault(others, pdo.index),
            None => None,
        }
    }

    /// What is wrong with an image as a whole, if anything is.
    pub(crate) const fn image_fault<I: ProcessImage>(&self) -> Option<Text> {
        match self.manager::<I::Direction>() {
            Some(manager) => manager.image_fault(I::PDOS, I::LEN),
            None => Some(Text::new().text(self.name).text(" has no process data in this direction")),
        }
    }

    /// Whether a master may assign PDOs this way.
    pub(crate) const fn is_assignable<Way: Direction>(&self) -> bool {
        match self.manager::<Way>() {
            Some(manager) => manager.assignable,
            None => false,
        }
    }

    /// Whether another device is brought up by the same list, with the same images.
    pub(crate) const fn is_like<O, I>(&self, other: &Self) -> bool
    where
        O: ProcessImage,
        I: ProcessImage,
    {
        let maps_alike = self.maps == other.maps || !(has_own(O::PDOS) || has_own(I::PDOS));
        maps_alike
            && self.is_assignable::<O::Direction>() == other.is_assignable::<O::Direction>()
            && self.is_assignable::<I::Direction>() == other.is_assignable::<I::Direction>()
            && are_alike(self.axes, other.axes)
    }

    /// That it is brought up in another way than another device.
    pub(crate) const fn differs(&self, other: &Self) -> Text {
        let names = Text::new().text(other.name).text(" and ").text(self.name);
        names.text(" take these images, but not the same list: make it by `StartUp::on`")
    }

    /// The process data of a direction, as far as the device lets it be chosen.
    pub(crate) const fn way<Dir: Direction>(&self, pdos: &'static [MappedPdo]) -> Way<'static> {
        let (carriers, assignable) = match self.manager::<Dir>() {
            Some(manager) => (manager.carriers, manager.assignable),
            None => return Way::NONE,
        };
        let assigned = if assignable { Some(pdos) } else { None };
        Way { carriers, mapped: if self.maps { pdos } else { &[] }, assigned }
    }

    const fn manager<Way: Direction>(&self) -> &Option<SyncManager> {
        if Way::ASSIGNMENT == Rx::ASSIGNMENT { &self.outputs } else { &self.inputs }
    }
}

/// Whether one of the PDOs is a master's own.
const fn has_own(mut pdos: &[MappedPdo]) -> bool {
    while let Some((pdo, rest)) = pdos.split_first() {
        if pdo.is_own {
            return true;
        }
        pdos = rest;
    }
    false
}

const fn are_alike(mut some: &[AxisObjects], mut others: &[AxisObjects]) -> bool {
    while let (Some((one, rest)), Some((other, left))) = (some.split_first(), others.split_first()) {
        if !is_same(one.mode, other.mode) || !is_same(one.cycle, other.cycle) {
            return false;
        }
        (some, others) = (rest, left);
    }
    some.is_empty() && others.is_empty()
}

const fn is_same(one: Option<u16>, other: Option<u16>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => one == other,
        (None, None) => true,
        _ => false,
    }
}
