//! Changes that nobody notices who does not look for them.

use super::kinds;

kinds! { Compatible:
    /// The revision number is higher: it announces what else has changed. Masters can be told to accept it.
    RAISED_REVISION = "raised-revision", "the revision number is higher";

    /// The family has another device.
    ADDED_DEVICE = "added-device", "the family has another device";

    /// There is another object.
    ADDED_OBJECT = "added-object", "there is another object";

    /// An object has another entry.
    ADDED_ENTRY = "added-entry", "an object has another entry";

    /// There is another PDO, which nobody assigned before.
    ADDED_PDO = "added-pdo", "there is another PDO";

    /// A PDO can be mapped, taken out, or assigned together with another one, or takes more.
    LOOSENED_PDO = "loosened-pdo", "more can be done with a PDO";

    /// A value can also be read or written, or in more EtherCAT states.
    WIDENED_ACCESS = "widened-access", "more can be done with a value";

    /// A value can also be mapped to process data.
    MAPPABLE_ENTRY = "mappable", "a value can be mapped";

    /// A limit of a value that masters write is wider or gone, or of one that the device writes narrower.
    LOOSENED_LIMITS = "loosened-limits", "a value is limited less";

    /// An enumeration has another value. Programs that only know the old ones may have to expect it.
    ADDED_VALUE = "added-value", "there is another named value";

    /// What did nothing does something.
    GAINED_FUNCTION = "gained-function", "an object does something now";

    /// There is another error code, or another message of the diagnosis history.
    ADDED_ERROR = "added-error", "there is another error code";

    /// There is another mode of operation, or another code for one.
    ADDED_MODE = "added-mode", "there is another mode of operation";

    /// There is another command, or a transition that only a command sets off.
    ADDED_TRANSITION = "added-transition", "the state machine knows another transition";

    /// Bits of a word that meant nothing mean something.
    ADDED_BITS = "added-bits", "free bits of a word mean something";

    /// There is another way to find the reference position.
    ADDED_HOMING = "added-homing", "there is another homing method";

    /// The device takes less current from the E-bus, or gives more.
    LOWERED_CURRENT = "lowered-current", "the device takes less current from the E-bus";

    /// The area of a sync manager can get longer.
    ENLARGED_AREA = "enlarged-area", "a sync manager's area is larger";

    /// The mailbox can do more, or there is one.
    ADDED_ABILITY = "added-ability", "the mailbox can do more";

    /// Masters accept more devices in place of this one.
    WIDENED_CHECK = "widened-check", "masters accept more devices in its place";

    /// A master finds the number that people set at the device in another way as well.
    FOUND_ID = "found-id", "the number that people set is found";

    /// One command reads and writes process data (LRW); those that do one of it still work.
    JOINED_COMMANDS = "joined-commands", "process data can be read and written by one command";

    /// Tools save a value with the settings of a machine.
    SAVED_VALUE = "saved-value", "tools save a value";

    /// A master is to wait for another time. Those that are set up keep theirs.
    CHANGED_TIMEOUT = "changed-timeout", "a master is to wait for another time";

    /// There is another start-up configuration to choose.
    ADDED_START_UP = "added-start-up", "there is another start-up configuration";

    /// There is another way to keep time with the master, behind those that there were.
    ADDED_SYNC_MODE = "added-sync-mode", "there is another synchronisation mode";

    /// The shortest cycle is shorter, more cycles can be chosen, or an effect comes earlier.
    SHORTENED_TIME = "shortened-time", "a cycle or a dead time is shorter";
}
