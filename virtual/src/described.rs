//! A subdevice of a description.

use devc::model::Device;

use crate::Subdevice;
use crate::drive::{Drive, Model, Stored};

/// The settings of a controller whose host interface is of no matter, as there is none: a 16-bit interface, with clocks.
const CONFIG_DATA: [u8; 6] = [0x08, 0x0C, 0, 0, 0, 0];

impl Subdevice<Drive> {
    /// The device of a description, with an EEPROM as it says: a drive that has just been switched on.
    pub fn of(device: &Device) -> Self {
        Self::with_stored(device, Stored::new())
    }

    /// The same, with what a master has stored in it before.
    pub fn with_stored(device: &Device, stored: Stored) -> Self {
        let described = &device.eeprom.config_data.0;
        let config_data = if described.is_empty() { &CONFIG_DATA } else { described.as_slice() };
        let image = devc::sii::image_of_any_size(device, config_data);
        Self::new(Drive::with_stored(Model::new(device), stored), image)
    }

    /// Switches it off and on again. What is stored stays, and what is in the EEPROM.
    pub fn power_cycle(&mut self) {
        let mut firmware = self.firmware.clone();
        firmware.power_cycle();
        self.restart(firmware);
    }
}
