//! Finding parts of a device.

use super::{Address, Device, Direction, Entry, Index, Object, Pdo, Role, SyncManager, Unit, Word};

impl Device {
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

    /// The sync manager of a role.
    pub fn sync_manager(&self, role: Role) -> Option<&SyncManager> {
        self.sync_managers.iter().find(|manager| manager.role == role)
    }

    /// The word of this id.
    pub fn word(&self, id: &str) -> Option<&Word> {
        self.words.iter().find(|word| word.id == id)
    }

    /// The unit of this id.
    pub fn unit(&self, id: &str) -> Option<&Unit> {
        self.units.iter().find(|unit| unit.id == id)
    }

    /// The bytes of the process image that a sync manager carries by default.
    pub fn image_bytes(&self, role: Role) -> u32 {
        let assigned = self.sync_manager(role).map_or(&[][..], |manager| &manager.pdos);
        let bits: u32 = assigned.iter().filter_map(|index| self.pdo(*index)).map(Pdo::bits).sum();
        bits.div_ceil(8)
    }
}
