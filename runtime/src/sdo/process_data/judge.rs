//! Whether a master may make process data of what it writes (CiA 301, PDO mapping parameter; ETG.1000.6, sync manager
//! PDO assignment).
//!
//! Entries are judged one by one when they are written, which is only while subindex 0 is 0; what they are together is
//! judged when subindex 0 says how many count.

use super::role::{PdoRules, Role, Way, bits};
use crate::object::Address;
use crate::pdo::{Mapping, SyncManager};
use crate::sdo::{AbortCode, Hooks, Server, Values, found};

/// What an object is going to hold.
#[derive(Clone, Copy)]
struct Proposed<'a> {
    role: Role,
    index: u16,
    /// The object as a transfer of the whole has it; none if its entries are what they are.
    whole: Option<&'a [u8]>,
}

/// Whether the server judges a number of entries here, and not by the table alone.
pub(crate) fn counts_process_data(values: &impl Values, address: Address) -> bool {
    let rules = values.process_data();
    address.subindex == 0 && rules.is_some_and(|rules| rules.role(address.index).is_some())
}

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// Judges the write of an entry that the table allows.
    pub(crate) fn judge(&mut self, to: Address, data: &[u8]) -> Result<(), AbortCode> {
        let Some((rules, role)) = self.role(to.index) else { return Ok(()) };
        if let (0, Some(count)) = (to.subindex, data.first()) {
            return self.judge_count(rules, Proposed { role, index: to.index, whole: None }, *count);
        }
        if self.number(Address::new(to.index, 0))? != 0 {
            return Err(AbortCode::SUBINDEX_0_NOT_CLEARED);
        }
        role.judge(&self.values, number(data))
    }

    /// What an object says of process data, and what is allowed there.
    fn role(&self, index: u16) -> Option<(&'static PdoRules, Role)> {
        let rules = self.values.process_data()?;
        Some((rules, rules.role(index)?))
    }

    /// Judges the write of a whole object that has data of the right length.
    pub(crate) fn judge_whole(&mut self, from: Address, data: &[u8]) -> Result<(), AbortCode> {
        let Some((rules, role)) = self.role(from.index) else { return Ok(()) };
        if from.subindex > 0 {
            return match self.number(Address::new(from.index, 0))? {
                0 => Ok(()),
                _ => Err(AbortCode::SUBINDEX_0_NOT_CLEARED),
            };
        }
        let proposed = Proposed { role, index: from.index, whole: Some(data) };
        let count = data.first().copied().unwrap_or(0);
        for subindex in 1..=count {
            let value = self.proposed(proposed, subindex)?;
            role.judge(&self.values, value)?;
        }
        self.judge_count(rules, proposed, count)
    }

    fn judge_count(&mut self, rules: &PdoRules, proposed: Proposed<'_>, count: u8) -> Result<(), AbortCode> {
        let object = self.values.table().object(proposed.index).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        if count > object.highest_subindex() {
            return Err(AbortCode::PDO_TOO_LONG);
        }
        match proposed.role {
            _ if count == 0 => Ok(()),
            Role::Mapping(way) => self.judge_mapping(rules, way, proposed, count),
            Role::Assignment(way) => self.judge_assignment(rules, way, proposed, count),
        }
    }

    /// An entry that is empty is no object, and all entries together have to fit.
    fn judge_mapping(
        &mut self,
        rules: &PdoRules,
        way: Way,
        proposed: Proposed<'_>,
        count: u8,
    ) -> Result<(), AbortCode> {
        let mut mapped = 0_usize;
        for subindex in 1..=count {
            let mapping = Mapping::from_word(self.proposed(proposed, subindex)?);
            if mapping.bits == 0 {
                return Err(AbortCode::NO_SUCH_OBJECT);
            }
            mapped = mapped.saturating_add(mapping.bits.into());
        }
        match rules.most_bits(proposed.index, way) {
            Some(most) if mapped > most => Err(AbortCode::PDO_TOO_LONG),
            _ => Ok(()),
        }
    }

    /// Each PDO once, none with one that it excludes, also not by another sync manager of the direction; all that have to be
    /// there, and together no longer than is carried.
    fn judge_assignment(
        &mut self,
        rules: &PdoRules,
        way: Way,
        proposed: Proposed<'_>,
        count: u8,
    ) -> Result<(), AbortCode> {
        let Some(manager) = rules.manager(way) else { return Ok(()) };
        let (mut carried, mut mandatory) = (0_usize, 0_usize);
        let beside = || rules.assignments(way).filter(|other| *other != proposed.index);
        for other in beside() {
            carried = carried.saturating_add(self.carried_by(other).saturating_mul(8));
        }
        for subindex in 1..=count {
            let pdo = self.pdo(proposed, subindex)?;
            for before in 1..subindex {
                let other = self.pdo(proposed, before)?;
                if other == pdo || manager.excludes(other, pdo) {
                    return Err(AbortCode::PARAMETERS_INCOMPATIBLE);
                }
            }
            for other in beside() {
                self.judge_beside(manager, other, pdo)?;
            }
            carried = carried.saturating_add(self.bits_of(pdo)?);
            mandatory = mandatory.saturating_add(manager.mandatory.contains(&pdo).into());
        }
        if mandatory < manager.mandatory_of(proposed.index) {
            return Err(AbortCode::PARAMETERS_INCOMPATIBLE);
        }
        match manager.max_size.map(bits) {
            Some(most) if carried > most => Err(AbortCode::PDO_TOO_LONG),
            _ => Ok(()),
        }
    }

    /// Whether a PDO may be there while another sync manager has what it has.
    fn judge_beside(&mut self, manager: &SyncManager, other: u16, pdo: u16) -> Result<(), AbortCode> {
        let count = u8::try_from(self.number(Address::new(other, 0)).unwrap_or(0)).unwrap_or(u8::MAX);
        for subindex in 1..=count {
            let beside = u16::try_from(self.number(Address::new(other, subindex))?).unwrap_or(0);
            if beside == pdo || manager.excludes(beside, pdo) {
                return Err(AbortCode::PARAMETERS_INCOMPATIBLE);
            }
        }
        Ok(())
    }

    /// A PDO that is going to be assigned; that there is one was judged when it was written, but for an empty entry.
    fn pdo(&mut self, proposed: Proposed<'_>, subindex: u8) -> Result<u16, AbortCode> {
        match u16::try_from(self.proposed(proposed, subindex)?) {
            Ok(pdo) if pdo != 0 => Ok(pdo),
            _ => Err(AbortCode::VALUE_OUT_OF_RANGE),
        }
    }

    /// What an entry is going to hold. In a whole object the number of entries takes two bytes.
    fn proposed(&mut self, proposed: Proposed<'_>, subindex: u8) -> Result<u32, AbortCode> {
        let address = Address::new(proposed.index, subindex);
        let Some(whole) = proposed.whole else { return self.number(address) };
        let length = usize::from(found(&self.values, address)?.entry.bytes());
        let from = usize::from(subindex).saturating_sub(1).saturating_mul(length).saturating_add(2);
        let data = whole.get(from..).and_then(|rest| rest.get(..length));
        data.map(number).ok_or(AbortCode::LENGTH_TOO_LOW)
    }
}

impl Role {
    /// Judges a value of an entry for itself; 0 empties it.
    fn judge(self, values: &impl Values, value: u32) -> Result<(), AbortCode> {
        match self {
            _ if value == 0 => Ok(()),
            Self::Mapping(way) => may_map(values, Mapping::from_word(value), way),
            Self::Assignment(way) => {
                let pdo = u16::try_from(value).ok().filter(|pdo| Way::of_pdo(*pdo) == Some(way));
                match pdo.and_then(|pdo| values.table().object(pdo)) {
                    Some(_) => Ok(()),
                    None => Err(AbortCode::VALUE_OUT_OF_RANGE),
                }
            }
        }
    }
}

/// A gap may be of any width; an object has to be there, to be for this way, and to be mapped with its own width.
fn may_map(values: &impl Values, mapping: Mapping, way: Way) -> Result<(), AbortCode> {
    if mapping.is_gap() {
        return Ok(());
    }
    let entry = found(values, mapping.address).map_err(|_| AbortCode::NOT_MAPPABLE)?.entry;
    match entry.access.includes(way.right()) && entry.bits == u16::from(mapping.bits) {
        true => Ok(()),
        false => Err(AbortCode::NOT_MAPPABLE),
    }
}

/// A number as an SDO carries it.
pub(super) fn number(data: &[u8]) -> u32 {
    data.iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte))
}
