//! The EEPROM, as masters read it through registers.

use super::Memory;
use super::registers as at;

/// How long an operation takes, in nanoseconds: some bytes of a chip at 400 kHz.
const BUSY: u64 = 200_000;

const CHECKSUM_WRONG: u16 = 0x0800;
const REFUSED: u16 = 0x2000;
const WRITE_DISABLED: u16 = 0x4000;
const IS_BUSY: u16 = 0x8000;
/// Eight bytes are read at once.
const READS_EIGHT: u16 = 0x0040;
/// Addresses of the chip have two bytes.
const IS_LARGE: u16 = 0x0080;

/// What fills the chip behind the image.
const EMPTY: u8 = 0xFF;

/// The EEPROM with its interface (ETG.1000.4, subdevice information interface).
#[derive(Debug, Clone)]
pub(crate) struct Eeprom {
    image: Vec<u8>,
    status: u16,
    /// What is being done, and how long it still takes.
    operation: Option<(Operation, u64)>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Operation {
    Read,
    Write,
    Reload,
}

impl Eeprom {
    /// A chip with this image: as large as the image says, or as it is.
    pub(super) fn new(mut image: Vec<u8>) -> Self {
        let kilobits = image.get(0x7C..0x7E).and_then(|word| word.first_chunk()).copied();
        let told = kilobits.map_or(0, |kilobits| (usize::from(u16::from_le_bytes(kilobits)) + 1) * 128);
        let length = image.len().max(told.min(0x1_0000)).next_multiple_of(2);
        image.resize(length, EMPTY);
        let size = if length > 2048 { IS_LARGE } else { 0 };
        Self { image, status: READS_EIGHT | size, operation: None }
    }

    /// What is in it.
    pub(super) fn image(&self) -> &[u8] {
        &self.image
    }

    /// A word of the image.
    fn word(&self, number: usize) -> [u8; 2] {
        let bytes = number.checked_mul(2).and_then(|first| self.image.get(first..)?.first_chunk());
        bytes.copied().unwrap_or([EMPTY; 2])
    }

    /// Takes the settings of the controller, as it does when it is switched on: only if their checksum is right.
    pub(super) fn load(&mut self, memory: &mut Memory) {
        let settings = self.image.get(..14).unwrap_or_default();
        let is_right = self.image.get(14).is_some_and(|byte| *byte == checksum(settings));
        self.status = self.status & !CHECKSUM_WRONG | if is_right { 0 } else { CHECKSUM_WRONG };
        if is_right {
            memory.put(at::PDI_CONTROL, &self.word(0));
            memory.put(at::PDI_CONFIGURATION, &self.word(1));
            memory.put(at::SYNC_PULSE, &self.word(2));
            memory.put(at::PDI_CONFIGURATION + 2, &self.word(3));
            memory.put(at::ALIAS, &self.word(4));
        }
        self.show(memory);
    }

    /// Whether the settings were taken.
    pub(super) const fn is_loaded(&self) -> bool {
        self.status & CHECKSUM_WRONG == 0
    }

    /// Whether a master has no access now: something is being done, or the firmware has the EEPROM.
    pub(super) fn is_locked(&self, memory: &Memory) -> bool {
        self.operation.is_some() || memory.byte(at::EEPROM_CONFIGURATION) & 0x01 != 0
    }

    /// Takes the command that a master wrote.
    pub(super) fn command(&mut self, memory: &mut Memory) {
        let control = memory.word(at::EEPROM_CONTROL);
        self.status &= !(REFUSED | WRITE_DISABLED);
        let operation = match control >> 8 & 0x07 {
            0 => None,
            1 => Some(Operation::Read),
            2 if control & 0x01 != 0 => Some(Operation::Write),
            2 => {
                self.status |= WRITE_DISABLED;
                None
            }
            4 => Some(Operation::Reload),
            _ => {
                self.status |= REFUSED;
                None
            }
        };
        self.operation = operation.map(|operation| (operation, BUSY));
        self.show(memory);
    }

    /// Time goes on.
    pub(super) fn elapse(&mut self, ns: u64, memory: &mut Memory) {
        let Some((operation, left)) = &mut self.operation else { return };
        *left = left.saturating_sub(ns);
        if *left > 0 {
            return;
        }
        let address = u32::from_le_bytes(memory.array(at::EEPROM_ADDRESS));
        let first = usize::try_from(address).ok().and_then(|word| word.checked_mul(2));
        let first = first.filter(|first| *first < self.image.len());
        match (*operation, first) {
            (Operation::Reload, _) => self.load(memory),
            (_, None) => self.status |= REFUSED,
            (Operation::Read, Some(first)) => {
                let rest = self.image.get(first..).unwrap_or_default();
                let mut data = [EMPTY; 8];
                data.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
                memory.put(at::EEPROM_DATA, &data);
            }
            (Operation::Write, Some(first)) => {
                let data = memory.array::<2>(at::EEPROM_DATA);
                let place = self.image.get_mut(first..).unwrap_or_default();
                place.iter_mut().zip(data).for_each(|(to, from)| *to = from);
            }
        }
        self.operation = None;
        self.show(memory);
    }

    /// Brings the register up to date.
    pub(super) fn show(&self, memory: &mut Memory) {
        let busy = if self.operation.is_some() { IS_BUSY } else { 0 };
        memory.put(at::EEPROM_CONTROL, &(self.status | busy).to_le_bytes());
    }
}

/// CRC-8 with the polynomial 0x07, begun with 0xFF (ETG.1000.6, SII, checksum).
fn checksum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0xFF, |crc, byte| {
        (0..8).fold(crc ^ byte, |crc, _| if crc & 0x80 == 0 { crc << 1 } else { crc << 1 ^ 0x07 })
    })
}
