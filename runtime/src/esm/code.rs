//! Why a device is not in the state that it should be in.

use core::fmt;

use crate::codes::codes;

/// What the register AL status code, 0x0134, shows (ETG.1000.6, AL status codes).
///
/// ```
/// use devc_runtime::esm::AlStatusCode;
///
/// assert_eq!(AlStatusCode::WATCHDOG.to_string(), "0x001B: outputs did not come in time");
/// assert_eq!(AlStatusCode(0x8000).to_string(), "0x8000: unknown AL status code");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AlStatusCode(pub u16);

codes! { AlStatusCode:
    NONE = 0x0000, "no error";
    UNSPECIFIED = 0x0001, "an error that is not told";
    NO_MEMORY = 0x0002, "the device has not enough memory";
    INVALID_SETUP = 0x0003, "the parts of the device do not fit each other";
    INVALID_REVISION = 0x0004, "the device is of a revision that does not fit";
    EEPROM_OF_OTHER_FIRMWARE = 0x0006, "the EEPROM was written for another firmware";
    UPDATE_FAILED = 0x0007, "the firmware that was loaded cannot be used";
    NO_LICENCE = 0x000E, "the device lacks a licence";
    INVALID_CHANGE = 0x0011, "the state that is asked for does not follow the present one";
    UNKNOWN_STATE = 0x0012, "there is no such state";
    NO_BOOTSTRAP = 0x0013, "the device has no state Bootstrap";
    NO_FIRMWARE = 0x0014, "there is no firmware to run";
    INVALID_BOOT_MAILBOX = 0x0015, "a sync manager of the mailbox is wrong for Bootstrap";
    INVALID_MAILBOX = 0x0016, "a sync manager of the mailbox is wrong";
    INVALID_SYNC_MANAGER = 0x0017, "a sync manager is wrong";
    NO_VALID_INPUTS = 0x0018, "there are no valid inputs";
    NO_VALID_OUTPUTS = 0x0019, "there are no valid outputs";
    SYNCHRONISATION = 0x001A, "synchronisation was lost";
    WATCHDOG = 0x001B, "outputs did not come in time";
    INVALID_TYPES = 0x001C, "the types of the sync managers are wrong";
    INVALID_OUTPUTS = 0x001D, "the sync manager of the outputs does not fit what is mapped";
    INVALID_INPUTS = 0x001E, "the sync manager of the inputs does not fit what is mapped";
    INVALID_WATCHDOG = 0x001F, "the watchdog is set to a time that the device does not take";
    NEEDS_COLD_START = 0x0020, "the device has to be switched off and on";
    NEEDS_INIT = 0x0021, "the device has to go to Init";
    NEEDS_PRE_OPERATIONAL = 0x0022, "the device has to go to Pre-Operational";
    NEEDS_SAFE_OPERATIONAL = 0x0023, "the device has to go to Safe-Operational";
    INVALID_INPUT_MAPPING = 0x0024, "what is mapped to the inputs is wrong";
    INVALID_OUTPUT_MAPPING = 0x0025, "what is mapped to the outputs is wrong";
    INCONSISTENT_SETTINGS = 0x0026, "settings contradict each other";
    NO_FREE_RUN = 0x0027, "the device does not run without synchronisation";
    NO_SYNCHRONISATION = 0x0028, "the device does not have this kind of synchronisation";
    FREE_RUN_NEEDS_BUFFERS = 0x0029, "without synchronisation three buffers are needed";
    BACKGROUND_WATCHDOG = 0x002A, "the device was too slow";
    NO_VALID_DATA = 0x002B, "there are neither valid inputs nor valid outputs";
    FATAL_SYNCHRONISATION = 0x002C, "the signals of synchronisation stopped";
    NO_SYNC_SIGNAL = 0x002D, "the signals of synchronisation did not come";
    INVALID_SYNC = 0x0030, "the settings of the distributed clocks are wrong";
    INVALID_LATCH = 0x0031, "the settings of the latches are wrong";
    NOT_LOCKED = 0x0032, "the device does not follow the distributed clocks";
    SYNC_IO = 0x0033, "signals and process data do not fit each other";
    SYNC_TIMEOUT = 0x0034, "signals of synchronisation were missing";
    INVALID_CYCLE = 0x0035, "the device does not take the cycle time";
    INVALID_SYNC0_CYCLE = 0x0036, "the device does not take the cycle time of SYNC0";
    INVALID_SYNC1_CYCLE = 0x0037, "the device does not take the cycle time of SYNC1";
    MAILBOX_AOE = 0x0041, "the mailbox of ADS failed";
    MAILBOX_EOE = 0x0042, "the mailbox of Ethernet failed";
    MAILBOX_COE = 0x0043, "the mailbox of CANopen failed";
    MAILBOX_FOE = 0x0044, "the mailbox of files failed";
    MAILBOX_SOE = 0x0045, "the mailbox of the servo profile failed";
    MAILBOX_VOE = 0x004F, "the mailbox of the vendor's protocol failed";
    EEPROM_NOT_ACCESSIBLE = 0x0050, "the EEPROM is not given to the device";
    EEPROM_ERROR = 0x0051, "the EEPROM could not be read";
    HARDWARE_NOT_READY = 0x0052, "something that is connected is not ready";
    RESTARTED = 0x0060, "the device has restarted by itself";
    IDENTIFICATION_UPDATED = 0x0061, "the device has another identification value";
    MODULES_DIFFER = 0x0070, "the modules are not those that are set up";
    VOLTAGE_TOO_LOW = 0x0080, "the supply voltage is too low";
    VOLTAGE_TOO_HIGH = 0x0081, "the supply voltage is too high";
    TEMPERATURE_TOO_LOW = 0x0082, "the temperature is too low";
    TEMPERATURE_TOO_HIGH = 0x0083, "the temperature is too high";
    CONTROLLER_AVAILABLE = 0x00F0, "the device's own controller is there now";
}

impl fmt::Display for AlStatusCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:04X}: {}", self.0, self.meaning().unwrap_or("unknown AL status code"))
    }
}
