//! What a master sets the sync managers to, against what the device needs.

/// Where a sync manager lies, and how long it may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Area {
    /// The first byte.
    pub address: u16,
    /// The least and the greatest number of bytes.
    pub length: (u16, u16),
}

/// What a sync manager is for (ETG.1000.6, sync manager communication type).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Mail from the master.
    MailboxOut,
    /// Mail to the master.
    MailboxIn,
    /// Process data from the master.
    Outputs,
    /// Process data to the master.
    Inputs,
}

impl Role {
    /// Whether the master writes what it carries.
    pub const fn is_written_by_master(self) -> bool {
        matches!(self, Self::MailboxOut | Self::Outputs)
    }
}

/// A sync manager of a device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Manager {
    /// What it is for.
    pub role: Role,
    /// Where it lies.
    pub area: Area,
}

impl Manager {
    /// A sync manager at an address, with the least and the greatest number of bytes.
    pub const fn new(role: Role, address: u16, length: (u16, u16)) -> Self {
        Self { role, area: Area { address, length } }
    }
}

/// The sync managers of a device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Areas {
    /// All of them, by number.
    pub managers: &'static [Manager],
    /// Mail in Bootstrap, from the master and to it; none for a device that does not have the state.
    pub boot: Option<[Area; 2]>,
}

impl Areas {
    /// Of a device without any.
    pub const NONE: Self = Self { managers: &[], boot: None };

    /// The numbers of the sync managers of a role, with where they lie.
    pub fn of(&self, role: Role) -> impl Iterator<Item = (usize, Area)> {
        let numbered = self.managers.iter().enumerate();
        numbered
            .filter(move |(_, manager)| manager.role == role)
            .map(|(number, manager)| (number, manager.area))
    }

    /// The same for mail in Bootstrap.
    pub fn of_boot(&self, role: Role) -> impl Iterator<Item = (usize, Area)> {
        let boot = self.boot.map(|[out, into]| if role.is_written_by_master() { out } else { into });
        self.of(role).filter_map(move |(number, _)| Some((number, boot?)))
    }
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

/// Whether mailboxes are as they should be; a device without a mailbox has nothing to judge.
pub(super) fn mailboxes(
    mut areas: impl Iterator<Item = (usize, Area)>,
    configured: &[Configured],
    role: Role,
) -> bool {
    areas.all(|(number, area)| {
        let configured = at(configured, number);
        configured.is_mailbox() && configured.is_at(area, role.is_written_by_master())
    })
}

/// Whether the sync managers of process data are as long as what is mapped. What nothing is mapped to is off.
pub(super) fn process_data(areas: &Areas, configured: &[Configured], lengths: &[usize], role: Role) -> bool {
    areas.of(role).all(|(number, area)| {
        let configured = at(configured, number);
        match lengths.get(number).copied().unwrap_or(0) {
            0 => !configured.is_on || configured.length == 0,
            length => {
                !configured.is_mailbox()
                    && configured.is_at(area, role.is_written_by_master())
                    && usize::from(configured.length) == length
            }
        }
    })
}

/// The settings of a sync manager; one that the controller does not have is off.
pub(super) fn at(configured: &[Configured], number: usize) -> Configured {
    configured.get(number).copied().unwrap_or_default()
}
