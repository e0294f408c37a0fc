//! What a sync manager takes.

#[cfg(test)]
mod tests;

use super::{Carrier, MappedPdo};
use crate::text::Text;

/// What may be assigned to the sync managers of a direction (ETG.1000.6, sync manager PDO assignment).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SyncManager {
    /// The sync managers, one in most devices, with what is assigned to each if nobody changes it.
    pub carriers: &'static [Carrier<'static>],
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

    /// How many of the PDOs that have to be there a sync manager carries, by its assignment object: those that it carries if
    /// nobody changes it, or all where there is no other.
    pub(crate) fn mandatory_of(&self, assignment: u16) -> usize {
        let is_only = self.carriers.len() <= 1;
        let mut carriers = self.carriers.iter();
        let own = carriers.find(|carrier| carrier.assignment == assignment).map_or(&[][..], |it| it.pdos);
        self.mandatory.iter().filter(|pdo| is_only || own.contains(pdo)).count()
    }

    /// What is wrong with a PDO behind others, if anything is.
    pub(crate) const fn pair_fault(&self, mut others: &[MappedPdo], pdo: u16) -> Option<Text> {
        while let Some((other, rest)) = others.split_first() {
            if other.index == pdo {
                return Some(Text::new().hex(pdo).text(" is in the image twice"));
            }
            if self.excludes(other.index, pdo) {
                let pair = Text::new().hex(other.index).text(" and ").hex(pdo);
                return Some(pair.text(" cannot be assigned together"));
            }
            others = rest;
        }
        None
    }

    /// What is wrong with an image of PDOs as a whole, if anything is.
    pub(crate) const fn image_fault(&self, pdos: &[MappedPdo], bytes: usize) -> Option<Text> {
        let (count, slots) = (pdos.len(), self.slots as usize);
        if !self.assignable && !is_default(self.carriers, pdos) {
            let text = Text::new().text("the device does not let its assignment be changed: it is ");
            let (mut text, mut carriers, mut between) = (text, self.carriers, "");
            while let Some((carrier, rest)) = carriers.split_first() {
                text = text.text(between).list(carrier.pdos);
                (carriers, between) = (rest, ", ");
            }
            return Some(text);
        }
        if count > slots {
            let text = Text::new().number(count).text(" PDOs are in the image, the device takes ");
            return Some(text.number(slots));
        }
        if let Some(max) = self.max_size
            && bytes > max as usize
        {
            let text = Text::new().text("the image has ").number(bytes).text(" bytes, the device takes ");
            return Some(text.number(max as usize));
        }
        let mut mandatory = self.mandatory;
        while let Some((index, rest)) = mandatory.split_first() {
            if !has(pdos, *index) {
                return Some(Text::new().hex(*index).text(" is missing, the device does not do without it"));
            }
            mandatory = rest;
        }
        None
    }
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

const fn is_default(mut carriers: &[Carrier<'_>], mut pdos: &[MappedPdo]) -> bool {
    while let Some((carrier, rest)) = carriers.split_first() {
        let mut default = carrier.pdos;
        while let Some((index, others)) = default.split_first() {
            match pdos.split_first() {
                Some((pdo, rest)) if pdo.index == *index => (default, pdos) = (others, rest),
                _ => return false,
            }
        }
        carriers = rest;
    }
    pdos.is_empty()
}
