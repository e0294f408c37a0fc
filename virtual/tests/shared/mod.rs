//! The shipped devices, and where their process data has what: by the description, apart from what runs in the drive.
#![allow(dead_code)] // each target of tests uses a part

use std::path::Path;
use std::sync::LazyLock;

use devc::model::{Address, Configuration, Device, Direction, Index, Pdo, Role};
use devc::source::{Disk, Memory};
use devc_virtual::drive::Model;

/// Every device that is shipped, compiled once.
static DEVICES: LazyLock<Vec<(Device, Model)>> = LazyLock::new(|| {
    let families = ["c887", "s700", "pmc-sc6"].map(|name| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices").join(name);
        devc::compile(&Disk, &folder).family.expect("the description has no errors")
    });
    let members = families.iter().flat_map(|family| &family.members);
    members.map(|device| (device.clone(), Model::new(device))).collect()
});

/// A drive that has what no shipped one has.
static OWN: LazyLock<(Device, Model)> = LazyLock::new(|| {
    let memory = Memory::default().with("own/device.toml", include_bytes!("own.toml").to_vec());
    let family = devc::compile(&memory, Path::new("own")).family.expect("the description has no errors");
    (family.members[0].clone(), Model::new(&family.members[0]))
});

fn known() -> impl Iterator<Item = &'static (Device, Model)> {
    DEVICES.iter().chain(std::iter::once(&*OWN))
}

/// Those that are shipped.
pub(crate) fn devices() -> impl Iterator<Item = &'static Device> {
    DEVICES.iter().map(|(device, _)| device)
}

pub(crate) fn device(id: &str) -> &'static Device {
    known().map(|(device, _)| device).find(|device| device.id == id).expect("it is a member")
}

/// What a device runs on.
pub(crate) fn model(device: &Device) -> Model {
    known().find(|(of, _)| of.id == device.id).expect("it is a member").1
}

/// Where entries lie in the process data of a direction: first bit and width.
#[derive(Default)]
pub(crate) struct Layout {
    entries: Vec<(Address, usize, usize)>,
    bits: usize,
}

impl Layout {
    /// What a device carries by default, or as a configuration has changed it.
    pub(crate) fn new(device: &Device, way: Direction, chosen: Option<&Configuration>) -> Self {
        let default = || device.assigned(Role::of(way)).map(|pdo| pdo.index).collect::<Vec<Index>>();
        let pdos = chosen.and_then(|it| it.assigned(way)).map_or_else(default, <[Index]>::to_vec);
        let is_written =
            |index| chosen.is_some_and(|it| it.startup.iter().any(|write| write.address.index == index));
        let own = |index| chosen?.mapping.iter().find(|pdo: &&Pdo| pdo.index == index && is_written(index));
        let mut layout = Self::default();
        for index in pdos {
            let pdo = own(index).or_else(|| device.pdo(index)).expect("there is such a PDO");
            for entry in &pdo.entries {
                layout.entries.extend(entry.address.map(|it| (it, layout.bits, entry.bits as usize)));
                layout.bits += entry.bits as usize;
            }
        }
        layout
    }

    pub(crate) fn bytes(&self) -> usize {
        self.bits.div_ceil(8)
    }

    /// First bit and width of an entry.
    pub(crate) fn place(&self, address: Address) -> Option<(usize, usize)> {
        self.entries.iter().find(|(of, ..)| *of == address).map(|(_, from, width)| (*from, *width))
    }

    /// Writes a value into an image; false if it is not mapped.
    pub(crate) fn write(&self, image: &mut [u8], address: Address, value: i64) -> bool {
        let Some((from, width)) = self.place(address) else { return false };
        for bit in 0..width {
            let (byte, mask) = ((from + bit) / 8, 1 << ((from + bit) % 8));
            image[byte] = image[byte] & !mask | if value >> bit & 1 == 1 { mask } else { 0 };
        }
        true
    }

    /// Reads the bits of a value out of an image, the lowest first, if it is mapped.
    pub(crate) fn read(&self, image: &[u8], address: Address) -> Option<Vec<bool>> {
        let (from, width) = self.place(address)?;
        Some((from..from + width).map(|bit| image[bit / 8] >> (bit % 8) & 1 == 1).collect())
    }
}

/// An address on an axis by that on the first.
pub(crate) fn on(device: &Device, axis: usize, index: u16, subindex: u8) -> Address {
    let shifted = device.repetition(Index(index)).map(|it| it.axes[axis].expect("the axis has it"));
    Address { index: shifted.unwrap_or(Index(index)), subindex }
}

/// The number that bits are, the lowest first.
pub(crate) fn number(bits: &[bool], is_signed: bool) -> i64 {
    let start = if is_signed && bits.last() == Some(&true) { -1 } else { 0 };
    bits.iter().rev().fold(start, |high, bit| high << 1 | i64::from(*bit))
}
