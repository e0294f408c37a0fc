//! The image of an EEPROM: what a slave controller and a master read before there is any mail.
//!
//! Its layout is ETG.1000.6, slave information interface, with the categories of ETG.2010. All PDOs of a direction are in
//! one category, for there are masters that read the first of a kind only. It stands below the rules since they judge
//! whether it fits.
//!
//! The first bytes, `config-data`, decide how the controller speaks with the firmware. They are a parameter: who makes an
//! image has to know them, and an image with a guess in it can turn that interface off.

mod categories;
mod header;
mod pdos;
mod strings;

use crate::model::{Device, Eeprom};

use strings::Strings;

pub use header::checksum;

/// How much of a device an image tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// All PDOs.
    All,
    /// The PDOs that are assigned at start-up; a master with a mailbox reads the others from the device.
    Assigned,
}

/// The image for an EEPROM of the size that is described, which it fills; none if not even the assigned PDOs fit.
pub fn image(device: &Device, config_data: &[u8]) -> Option<Vec<u8>> {
    fitting(device).map(|extent| laid_out(device, config_data, extent, device.eeprom.size))
}

/// The image as [`image`] makes it, in a larger EEPROM if it takes one: for a device that is none but a program.
pub fn image_of_any_size(device: &Device, config_data: &[u8]) -> Vec<u8> {
    image(device, config_data).unwrap_or_else(|| {
        let needed = u32::try_from(bytes(device, Extent::Assigned)).unwrap_or(Eeprom::MOST);
        laid_out(device, config_data, Extent::Assigned, needed.next_power_of_two())
    })
}

/// The most that fits into the EEPROM that is described.
pub fn fitting(device: &Device) -> Option<Extent> {
    let size = usize::try_from(device.eeprom.size).unwrap_or(usize::MAX);
    let fits = |extent: &Extent| {
        device.eeprom.is_possible() && bytes(device, *extent) <= size && names(device, *extent).fit()
    };
    [Extent::All, Extent::Assigned].into_iter().find(fits)
}

/// The bytes that an image takes without what fills it up.
pub fn bytes(device: &Device, extent: Extent) -> usize {
    header::BYTES
        + categories(device, extent).iter().map(|it| Category::HEAD + it.data.len()).sum::<usize>()
        + END.len()
}

/// Stands behind the last category.
const END: [u8; 2] = [0xFF, 0xFF];

/// What an EEPROM holds where nothing was written.
const ERASED: u8 = 0xFF;

/// One of the parts behind the header.
struct Category {
    /// Its type.
    kind: u16,
    /// What is in it, in whole words.
    data: Vec<u8>,
}

impl Category {
    /// The bytes of type and length.
    const HEAD: usize = 4;

    /// A category, unless nothing is in it. An odd length is filled up.
    fn of(kind: u16, mut data: Vec<u8>, filling: u8) -> Option<Self> {
        if !data.len().is_multiple_of(2) {
            data.push(filling);
        }
        (!data.is_empty()).then_some(Self { kind, data })
    }

    fn write(&self, image: &mut Vec<u8>) {
        let words = u16::try_from(self.data.len() / 2).unwrap_or(u16::MAX);
        image.extend(self.kind.to_le_bytes());
        image.extend(words.to_le_bytes());
        image.extend(&self.data);
    }
}

fn laid_out(device: &Device, config_data: &[u8], extent: Extent, size: u32) -> Vec<u8> {
    let mut image = header::header(device, config_data, size);
    categories(device, extent).iter().for_each(|category| category.write(&mut image));
    image.extend(END);
    image.resize(usize::try_from(size).unwrap_or(image.len()).max(image.len()), ERASED);
    image
}

fn categories(device: &Device, extent: Extent) -> Vec<Category> {
    let mut strings = Strings::default();
    let others = named(device, extent, &mut strings);
    strings.category().into_iter().chain(others).collect()
}

fn names(device: &Device, extent: Extent) -> Strings {
    let mut strings = Strings::default();
    named(device, extent, &mut strings);
    strings
}

/// The categories behind the strings, which take their names from there.
fn named(device: &Device, extent: Extent, strings: &mut Strings) -> Vec<Category> {
    let general = categories::general(device, strings);
    let [inputs, outputs] = pdos::pdos(device, extent, strings);
    let clocks = categories::clocks(device, strings);
    let all = [
        general,
        categories::mapping_units(device),
        categories::sync_managers(device),
        inputs,
        outputs,
        clocks,
    ];
    all.into_iter().flatten().collect()
}
