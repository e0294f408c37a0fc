//! The addresses of registers (ETG.1000.4, register overview), and which of them a master may write.

pub(crate) const TYPE: u16 = 0x0000;
pub(crate) const STATION: u16 = 0x0010;
pub(crate) const ALIAS: u16 = 0x0012;
pub(crate) const DL_CONTROL: u16 = 0x0100;
pub(crate) const DL_STATUS: u16 = 0x0110;
pub(crate) const AL_CONTROL: u16 = 0x0120;
pub(crate) const AL_STATUS: u16 = 0x0130;
pub(crate) const AL_STATUS_CODE: u16 = 0x0134;
pub(crate) const PDI_CONTROL: u16 = 0x0140;
pub(crate) const PDI_CONFIGURATION: u16 = 0x0150;
pub(crate) const EVENT_MASK: u16 = 0x0200;
pub(crate) const EVENT_REQUEST: u16 = 0x0210;
pub(crate) const ERROR_COUNTERS: u16 = 0x0300;
pub(crate) const WATCHDOG_DIVIDER: u16 = 0x0400;
pub(crate) const PDI_WATCHDOG_TIME: u16 = 0x0410;
pub(crate) const WATCHDOG_TIME: u16 = 0x0420;
pub(crate) const WATCHDOG_STATUS: u16 = 0x0440;
pub(crate) const EEPROM_CONFIGURATION: u16 = 0x0500;
pub(crate) const EEPROM_CONTROL: u16 = 0x0502;
pub(crate) const EEPROM_ADDRESS: u16 = 0x0504;
pub(crate) const EEPROM_DATA: u16 = 0x0508;
pub(crate) const FMMUS: u16 = 0x0600;
pub(crate) const MANAGERS: u16 = 0x0800;
pub(crate) const PORT_TIMES: u16 = 0x0900;
pub(crate) const SYSTEM_TIME: u16 = 0x0910;
pub(crate) const RECEIVE_TIME: u16 = 0x0918;
pub(crate) const TIME_OFFSET: u16 = 0x0920;
pub(crate) const TIME_DELAY: u16 = 0x0928;
pub(crate) const TIME_DIFFERENCE: u16 = 0x092C;
pub(crate) const SPEED_START: u16 = 0x0930;
pub(crate) const CLOCKS_END: u16 = 0x0A00;
pub(crate) const SYNC_ACTIVATION: u16 = 0x0981;
pub(crate) const SYNC_PULSE: u16 = 0x0982;
pub(crate) const SYNC_STATUS: u16 = 0x0984;
pub(crate) const SYNC_START: u16 = 0x0990;
pub(crate) const SYNC1_NEXT: u16 = 0x0998;
pub(crate) const SYNC0_CYCLE: u16 = 0x09A0;
pub(crate) const SYNC1_CYCLE: u16 = 0x09A4;
pub(crate) const LATCH_CONTROL: u16 = 0x09A8;
pub(crate) const LATCH_STATUS: u16 = 0x09AE;
pub(crate) const LATCH_TIMES: u16 = 0x09B0;
/// Memory for masters and firmware, of no meaning to the controller.
const USER: u16 = 0x0F80;
/// Where the memory of process data begins.
pub(crate) const RAM: u16 = 0x1000;

/// Bytes of the registers of an FMMU, and of a sync manager.
pub(crate) const FMMU_SIZE: u16 = 16;
pub(crate) const MANAGER_SIZE: u16 = 8;
/// How many of each there are, as in most controllers.
pub(crate) const COUNT: u16 = 8;

/// What a master may write below the memory of process data: first byte, and number of bytes.
const WRITABLE: [(u16, u16); 25] = [
    (STATION, 2),
    (0x0020, 2),
    (0x0030, 2),
    (0x0040, 2),
    (DL_CONTROL, 4),
    (0x0108, 2),
    (AL_CONTROL, 2),
    (EVENT_MASK, 2),
    (ERROR_COUNTERS, 20),
    (WATCHDOG_DIVIDER, 2),
    (PDI_WATCHDOG_TIME, 2),
    (WATCHDOG_TIME, 2),
    (0x0442, 2),
    (EEPROM_CONFIGURATION, 1),
    (EEPROM_CONTROL, 14),
    (0x0510, 8),
    (FMMUS, FMMU_SIZE * COUNT),
    (MANAGERS, MANAGER_SIZE * COUNT),
    (PORT_TIMES, 4),
    (SYSTEM_TIME, 8),
    (TIME_OFFSET, 12),
    (SPEED_START, 6),
    (0x0980, 2),
    (SYNC_START, 26),
    (USER, 0x80),
];

/// Whether a master may write a register.
pub(super) fn is_writable(address: u16) -> bool {
    let listed = WRITABLE.iter().any(|(first, length)| address.wrapping_sub(*first) < *length);
    let in_manager = address.wrapping_sub(MANAGERS);
    let is_of_device = in_manager < MANAGER_SIZE * COUNT && matches!(in_manager % MANAGER_SIZE, 5 | 7);
    listed && !is_of_device
}
