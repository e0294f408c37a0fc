//! PDOs that are transferred together: by default, and as configurations have it.

use super::lookup;
use crate::model::{Configuration, Device, Direction, Mapped, Pdo, Place, Role, Section, SyncManager};
use crate::source::Location;

/// What a sync manager carries.
pub(super) struct Image<'d> {
    pub(super) role: Role,
    pub(super) manager: Option<&'d SyncManager>,
    /// The configuration that chooses it; none by default.
    pub(super) configuration: Option<&'d Configuration>,
    /// The PDOs in their order, as they are mapped then.
    pub(super) pdos: Vec<&'d Pdo>,
}

/// All images of a device.
pub(super) fn images(device: &Device) -> impl Iterator<Item = Image<'_>> {
    let by_default = device.sync_managers.iter().map(|manager| {
        let pdos = manager.pdos.iter().filter_map(|index| device.pdo(*index)).collect();
        Image { role: manager.role, manager: Some(manager), configuration: None, pdos }
    });
    let chosen = device.configurations.iter().flat_map(move |configuration| {
        [Direction::Rx, Direction::Tx].into_iter().filter_map(move |way| chosen(device, configuration, way))
    });
    by_default.chain(chosen)
}

/// The image of a direction, if the configuration says anything of it.
fn chosen<'d>(device: &'d Device, configuration: &'d Configuration, way: Direction) -> Option<Image<'d>> {
    let manager = device.sync_manager(Role::of(way));
    let assigned = configuration.assigned(way);
    let is_remapped = configuration.mapping.iter().any(|pdo| pdo.direction == way);
    let indices = match (assigned, is_remapped) {
        (Some(assigned), _) => assigned,
        (None, true) => &manager?.pdos,
        (None, false) => return None,
    };
    let as_mapped = |index| configuration.mapping.iter().find(|pdo| pdo.index == index);
    let pdos = indices.iter().filter_map(|index| as_mapped(*index).or_else(|| device.pdo(*index))).collect();
    Some(Image { role: Role::of(way), manager, configuration: Some(configuration), pdos })
}

impl<'d> Image<'d> {
    /// What chooses it.
    pub(super) fn place(&self) -> Place {
        match self.configuration {
            Some(configuration) => Section::Configurations.at(&configuration.id),
            None => Section::SyncManagers.at(self.role.key()),
        }
    }

    /// Where it is said what is in it.
    pub(super) fn assigned(&self) -> Option<Location> {
        let key = if self.role == Role::Outputs { "outputs" } else { "inputs" };
        let chosen = self.configuration.map(|configuration| &configuration.origin);
        let chosen =
            chosen.map(|origin| if origin.has(key) { origin.value(key) } else { origin.value("mapping") });
        chosen.or_else(|| self.manager.map(|manager| manager.origin.value("pdos")))
    }

    /// What it carries, with the place of each; of a PDO that is assigned twice once.
    pub(super) fn mapped(&self) -> impl Iterator<Item = (&'d Pdo, Place, &'d Mapped)> {
        let is_first = |(place, pdo): &(usize, &&Pdo)| {
            !self.pdos.iter().take(*place).any(|other| std::ptr::eq(*other, **pdo))
        };
        self.pdos.iter().enumerate().filter(is_first).flat_map(|(_, pdo)| {
            let remapping = self.configuration.filter(|configuration| {
                configuration.mapping.iter().any(|remapped| std::ptr::eq(remapped, *pdo))
            });
            lookup::mapped_of(pdo, remapping)
        })
    }

    /// Its length in bytes.
    pub(super) fn bytes(&self) -> u32 {
        self.pdos.iter().map(|pdo| pdo.bits()).sum::<u32>().div_ceil(8)
    }
}
