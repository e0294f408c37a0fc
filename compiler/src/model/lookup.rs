//! Finding parts of a device.

use super::{
    Address, Device, Direction, Entry, Enumeration, Index, Object, Pdo, Role, SyncManager, SyncMode, Unit,
    Word,
};
use crate::source::Value;

impl Device {
    /// The group that an ESI offers the devices of a vendor in, unless a description says it.
    pub fn usual_group(vendor: &str) -> String {
        format!("{vendor} drives")
    }

    /// The object of this index.
    pub fn object(&self, index: Index) -> Option<&Object> {
        let place = self.objects.binary_search_by_key(&index, |object| object.index).ok()?;
        self.objects.get(place)
    }

    /// The entry of this address.
    pub fn entry(&self, address: Address) -> Option<&Entry> {
        self.object(address.index)?.entry(address.subindex)
    }

    /// The PDO of this index.
    pub fn pdo(&self, index: Index) -> Option<&Pdo> {
        self.pdos.iter().find(|pdo| pdo.index == index)
    }

    /// The PDOs of a direction.
    pub fn pdos_of(&self, direction: Direction) -> impl Iterator<Item = &Pdo> {
        self.pdos.iter().filter(move |pdo| pdo.direction == direction)
    }

    /// The first sync manager of a role.
    pub fn sync_manager(&self, role: Role) -> Option<&SyncManager> {
        self.sync_managers_of(role).next()
    }

    /// The sync managers of a role, by number.
    pub fn sync_managers_of(&self, role: Role) -> impl Iterator<Item = &SyncManager> {
        self.sync_managers.iter().filter(move |manager| manager.role == role)
    }

    /// The PDOs that the sync managers of a role carry by default, in the order of the process image.
    pub fn assigned(&self, role: Role) -> impl Iterator<Item = &Pdo> {
        self.sync_managers_of(role).flat_map(|manager| self.assigned_to(manager))
    }

    /// The PDOs that a sync manager carries by default, in order.
    pub fn assigned_to<'d>(&'d self, manager: &'d SyncManager) -> impl Iterator<Item = &'d Pdo> {
        manager.pdos.iter().filter_map(|index| self.pdo(*index))
    }

    /// The sync manager that carries a PDO by default.
    pub fn manager_of(&self, pdo: &Pdo) -> Option<&SyncManager> {
        self.sync_managers.iter().find(|manager| manager.pdos.contains(&pdo.index))
    }

    /// The PDOs of a direction by index, but those assigned at start-up in the order of their assignment: masters lay
    /// out the process image in the order in which they are told of them.
    pub fn pdos_in_order(&self, direction: Direction) -> Vec<&Pdo> {
        let mut assigned = self.sync_managers.iter().flat_map(|manager| self.assigned_to(manager));
        let mut next_assigned = || assigned.by_ref().find(|pdo| pdo.direction == direction);
        let in_place = |it| if self.manager_of(it).is_some() { next_assigned().unwrap_or(it) } else { it };
        self.pdos_of(direction).map(in_place).collect()
    }

    /// The sync managers that have a mapping unit each, in the usual order: outputs, inputs, and the state of the mailbox.
    pub fn mapping_units(&self) -> impl Iterator<Item = &SyncManager> {
        let roles = [Role::Outputs, Role::Inputs, Role::MailboxIn].into_iter();
        roles.flat_map(|role| self.sync_managers_of(role))
    }

    /// The ways to keep time, the default first; none if the device makes no use of distributed clocks.
    pub fn clock_modes(&self) -> &[SyncMode] {
        let synchronous = self.sync_modes.iter().any(|mode| mode.assign_activate != 0);
        if synchronous { &self.sync_modes } else { &[] }
    }

    /// The sync units that PDOs name, each once.
    pub fn sync_units(&self) -> Vec<&str> {
        let mut units: Vec<&str> = Vec::new();
        for unit in self.pdos.iter().filter_map(|pdo| pdo.sync_unit.as_deref()) {
            if !units.contains(&unit) {
                units.push(unit);
            }
        }
        units
    }

    /// The word of this id.
    pub fn word(&self, id: &str) -> Option<&Word> {
        self.words.iter().find(|word| word.id == id)
    }

    /// The unit of this id.
    pub fn unit(&self, id: &str) -> Option<&Unit> {
        self.units.iter().find(|unit| unit.id == id)
    }

    /// The enumeration that the values of an entry are from, if they are not its own.
    pub fn enumeration_of(&self, entry: &Entry) -> Option<&Enumeration> {
        let Value::String(id) = &entry.origin.node("values")?.value else { return None };
        self.enumerations.iter().find(|enumeration| enumeration.id == **id)
    }

    /// The bytes of the process image that the sync managers of a role carry by default.
    pub fn image_bytes(&self, role: Role) -> u32 {
        self.sync_managers_of(role).map(|manager| self.carried_bytes(manager)).sum()
    }

    /// The bytes that a sync manager carries by default.
    pub fn carried_bytes(&self, manager: &SyncManager) -> u32 {
        self.assigned_to(manager).map(Pdo::bits).sum::<u32>().div_ceil(8)
    }
}
