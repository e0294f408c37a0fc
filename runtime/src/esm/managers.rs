//! What a master sets the sync managers to, against what the device needs.

use super::AlStatusCode;

/// Where a sync manager lies, and how long it may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Area {
    /// The first byte.
    pub address: u16,
    /// The least and the greatest number of bytes.
    pub length: (u16, u16),
}

/// The sync managers of a device; those that it does not have are none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Areas {
    /// Mail from the master.
    pub mailbox_out: Option<Area>,
    /// Mail to the master.
    pub mailbox_in: Option<Area>,
    /// Mail from the master in Bootstrap; none for a device that does not have the state.
    pub boot_out: Option<Area>,
    /// Mail to the master in Bootstrap.
    pub boot_in: Option<Area>,
    /// Process data from the master.
    pub outputs: Option<Area>,
    /// Process data to the master.
    pub inputs: Option<Area>,
}

/// The lengths of the process data as it is mapped at present, in bytes:
/// [`Server::image_len`](crate::sdo::Server::image_len).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lengths {
    /// From the master.
    pub outputs: usize,
    /// To the master.
    pub inputs: usize,
}

/// The eight registers of a sync manager, from 0x0800 on (ETG.1000.4, sync manager).
///
/// ```
/// use devc_runtime::esm::Configured;
///
/// let outputs = Configured::from_registers([0x00, 0x11, 0x06, 0x00, 0x64, 0x00, 0x01, 0x00]);
/// assert_eq!(outputs, Configured { address: 0x1100, length: 6, control: 0x64, is_on: true });
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Configured {
    /// The first byte of the area.
    pub address: u16,
    /// Its bytes.
    pub length: u16,
    /// Buffers, direction and events.
    pub control: u8,
    /// Whether the master has switched it on.
    pub is_on: bool,
}

impl Configured {
    /// The settings as the registers hold them.
    pub const fn from_registers(registers: [u8; 8]) -> Self {
        let [a, b, c, d, control, _, activate, _] = registers;
        let (address, length) = (u16::from_le_bytes([a, b]), u16::from_le_bytes([c, d]));
        Self { address, length, control, is_on: activate & 0x01 != 0 }
    }

    /// Whether the master writes it: bits 2 and 3 of the control byte are 1.
    const fn is_written_by_master(self) -> bool {
        self.control & 0x0C == 0x04
    }

    /// Whether it sets off the watchdog: bit 6 of the control byte.
    pub(super) const fn is_watched(self) -> bool {
        self.control & 0x40 != 0
    }

    /// Whether it is a mailbox: bits 0 and 1 of the control byte are 2.
    const fn is_mailbox(self) -> bool {
        self.control & 0x03 == 0x02
    }

    /// Whether it is on, and where it should be.
    fn is_at(self, area: Area, is_out: bool) -> bool {
        let (least, greatest) = area.length;
        self.is_on
            && self.address == area.address
            && (least..=greatest).contains(&self.length)
            && self.is_written_by_master() == is_out
    }
}

/// Whether a pair of mailboxes is as it should be; a device without a mailbox has nothing to judge.
pub(super) fn mailboxes(
    areas: [Option<Area>; 2],
    configured: &[Configured; 4],
    fault: AlStatusCode,
) -> Result<(), AlStatusCode> {
    let [out, into, ..] = configured;
    let [area_out, area_in] = areas;
    let fits = |configured: &Configured, area: Option<Area>, is_out| {
        area.is_none_or(|area| configured.is_mailbox() && configured.is_at(area, is_out))
    };
    if fits(out, area_out, true) && fits(into, area_in, false) { Ok(()) } else { Err(fault) }
}

/// Whether the sync managers of process data are as long as what is mapped. What nothing is mapped to is off.
pub(super) fn process_data(
    areas: &Areas,
    configured: &[Configured; 4],
    lengths: Lengths,
) -> Result<(), AlStatusCode> {
    let [_, _, outputs, inputs] = configured;
    let fits = |configured: &Configured, area: Option<Area>, length: usize, is_out| match (length, area) {
        (0, _) => !configured.is_on || configured.length == 0,
        (_, None) => false,
        (_, Some(area)) => {
            !configured.is_mailbox()
                && configured.is_at(area, is_out)
                && usize::from(configured.length) == length
        }
    };
    if !fits(outputs, areas.outputs, lengths.outputs, true) {
        return Err(AlStatusCode::INVALID_OUTPUTS);
    }
    if !fits(inputs, areas.inputs, lengths.inputs, false) {
        return Err(AlStatusCode::INVALID_INPUTS);
    }
    Ok(())
}
