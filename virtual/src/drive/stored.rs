//! Parameters that outlast a power cycle (CiA 301, store parameters and restore default parameters).

use std::collections::BTreeMap;

use devc::model::{Access, Device, Entry, Mappable};
use devc_runtime::object::Address;
use devc_runtime::sdo::Dictionary;

use super::dictionary::Values;

/// The objects that store and restore, and what has to be written to them.
const STORE: (u16, [u8; 4]) = (0x1010, *b"save");
const RESTORE: (u16, [u8; 4]) = (0x1011, *b"load");

/// Values by their address, as they travel.
pub type Stored = BTreeMap<Address, Vec<u8>>;

/// What a device stores.
#[derive(Debug, Clone)]
pub(super) struct Parameters(Vec<Address>);

/// What a master asks for by a signature, for the parameters that a subindex stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    Store(u8),
    Restore(u8),
}

impl Order {
    /// Whether an entry takes orders.
    pub(super) const fn is_at(address: Address) -> bool {
        (address.index == STORE.0 || address.index == RESTORE.0) && address.subindex != 0
    }

    /// What a write asks for, and whether it has the signature for that; none for other objects.
    pub(super) fn of(address: Address, data: &[u8]) -> Option<Result<Self, ()>> {
        let (signature, order) = match address {
            _ if !Self::is_at(address) => return None,
            Address { index, subindex } if index == STORE.0 => (STORE.1, Self::Store(subindex)),
            Address { subindex, .. } => (RESTORE.1, Self::Restore(subindex)),
        };
        Some(if data == signature { Ok(order) } else { Err(()) })
    }
}

impl Parameters {
    /// Those that the description marks as `backup`; if it marks none, what can be written and is not for process data.
    pub(super) fn new(device: &Device, table: &Dictionary) -> Self {
        let entries = || device.objects.iter().flat_map(|object| &object.entries);
        let is_marked = |entry: &&Entry| entry.backup;
        let is_setting =
            |entry: &&Entry| entry.access == Access::Rw && matches!(entry.pdo, Mappable::None | Mappable::Tx);
        let chosen: Vec<&Entry> = match entries().any(|entry| entry.backup) {
            true => entries().filter(is_marked).collect(),
            false => entries().filter(is_setting).collect(),
        };
        let addresses =
            chosen.into_iter().map(|entry| Address::new(entry.address.index.0, entry.address.subindex));
        let is_kept = |address: &Address| {
            let is_order = [STORE.0, RESTORE.0].contains(&address.index);
            !is_order && table.find(*address).is_ok_and(|found| found.place().is_some())
        };
        Self(addresses.filter(is_kept).collect())
    }

    /// Does what a master asks for.
    pub(super) fn carry_out(&self, order: Order, values: &mut Values, stored: &mut Stored) {
        match order {
            Order::Store(group) => {
                let addresses = self.0.iter().filter(|address| is_in(group, **address));
                stored.extend(addresses.filter_map(|address| Some((*address, values.read(*address)?))));
            }
            Order::Restore(group) => stored.retain(|address, _| !is_in(group, *address)),
        }
    }

    /// Takes the values that were stored, when the device is switched on.
    pub(super) fn load(&self, stored: &Stored, values: &mut Values) {
        for (address, value) in stored.iter().filter(|(address, _)| self.0.contains(address)) {
            values.write(*address, value);
        }
    }
}

/// Whether the subindex of 0x1010 and 0x1011 stands for an entry: all, those of communication, of the application, and from
/// 4 on the manufacturer's.
fn is_in(group: u8, address: Address) -> bool {
    match group {
        1 => true,
        2 => (0x1000..=0x1FFF).contains(&address.index),
        3 => (0x6000..=0x9FFF).contains(&address.index),
        _ => (0x2000..=0x5FFF).contains(&address.index),
    }
}
