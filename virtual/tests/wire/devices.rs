//! The nine devices that are described, with facts from their manuals (C-887 p. 24; S700 3.1; what no manual gives, from the
//! descriptions).

use std::path::Path;
use std::sync::LazyLock;

use devc::source::Disk;
use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::Device as Identity;
use devc_runtime::esm::{Areas, Manager, Role};
use devc_virtual::drive::{Drive, Model};
use devc_virtual::{Firmware, Subdevice};

use crate::image;
use crate::served::Served;

pub(crate) type Any = Box<dyn Firmware>;

/// A device with what a master has to find.
pub(crate) struct Device {
    pub(crate) name: &'static str,
    /// Vendor, product, revision.
    pub(crate) identity: [u32; 3],
    /// Bytes of process data by default, from and to the master.
    pub(crate) lengths: (usize, usize),
    pub(crate) areas: Areas,
    pub(crate) firmware: Any,
}

impl Device {
    pub(crate) fn subdevice(self) -> Subdevice<Any> {
        let image = image::of(self.name, self.identity, &self.areas, self.lengths);
        Subdevice::new(self.firmware, image)
    }
}

fn areas(mail: [(u16, u16); 2], outputs: (u16, u16), inputs: (u16, u16)) -> Areas {
    let exact = |role, (address, length): (u16, u16)| Manager::new(role, address, (length, length));
    let up_to = |role, (address, length): (u16, u16)| Manager::new(role, address, (0, length));
    let [out, into] = mail;
    let managers = [
        exact(Role::MailboxOut, out),
        exact(Role::MailboxIn, into),
        up_to(Role::Outputs, outputs),
        up_to(Role::Inputs, inputs),
    ];
    Areas { managers: managers.to_vec().leak(), boot: None }
}

macro_rules! device {
    ($($module:ident)::+, $device:ident, $areas:expr, $lengths:expr, $names:expr) => {{
        use $($module)::+ as of;
        let identity = [of::$device::VENDOR_ID, of::$device::PRODUCT_CODE, of::$device::REVISION];
        let areas = $areas;
        let values = of::dictionary::Dictionary::DEFAULT;
        let firmware = Box::new(Served::new(values, $names, areas));
        Device { name: of::$device::NAME, identity, lengths: $lengths, areas, firmware }
    }};
}

pub(crate) fn c887() -> Device {
    let areas = areas([(0x1000, 128), (0x1080, 128)], (0x1100, 90), (0x1400, 66));
    device!(c887, C887, areas, (42, 66), Some(&c887::dictionary::NAMES))
}

fn s_areas() -> Areas {
    areas([(0x1800, 512), (0x1C00, 512)], (0x1100, 64), (0x1140, 72))
}

pub(crate) fn s700() -> Device {
    device!(s700::s700, S700, s_areas(), (6, 6), None)
}

fn pmc_areas() -> Areas {
    areas([(0x1000, 1024), (0x1400, 1024)], (0x1800, 192), (0x1C00, 192))
}

pub(crate) fn all() -> Vec<Device> {
    vec![
        c887(),
        device!(s700::s300, S300, s_areas(), (6, 6), None),
        device!(s700::s400, S400, s_areas(), (6, 6), None),
        device!(s700::s600, S600, s_areas(), (6, 6), None),
        s700(),
        device!(pmc_sc6::double, Double, pmc_areas(), (46, 58), Some(&pmc_sc6::double::dictionary::NAMES)),
        device!(pmc_sc6::single, Single, pmc_areas(), (23, 29), Some(&pmc_sc6::single::dictionary::NAMES)),
        device!(pmc_sc6::double_hires, DoubleHires, pmc_areas(), (46, 58), None),
        device!(pmc_sc6::single_hires, SingleHires, pmc_areas(), (23, 29), None),
    ]
}

/// The same nine, made of their descriptions while the test runs.
pub(crate) fn described() -> Vec<Subdevice<Any>> {
    static MODELS: LazyLock<Vec<(Model, Vec<u8>)>> = LazyLock::new(models);
    let subdevice = |(model, image): &(Model, Vec<u8>)| {
        let drive: Any = Box::new(Drive::new(*model));
        Subdevice::new(drive, image.clone())
    };
    MODELS.iter().map(subdevice).collect()
}

/// What is made of each description once, with an image for its EEPROM.
fn models() -> Vec<(Model, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let mut models = Vec::new();
    for name in ["c887", "s700", "pmc-sc6"] {
        let family = devc::compile(&Disk, &folder.join(name)).family.expect("a description without errors");
        let image = |device| devc::sii::image_of_any_size(device, &[0x08, 0x0C, 0, 0, 0, 0]);
        models.extend(family.members.iter().map(|device| (Model::new(device), image(device))));
    }
    models
}
