//! Changes that break what was made for the old version.

use super::kinds;

kinds! { WireBreaking:
    /// The vendor id or the product code is another one: it is another device. Masters compare both at start-up and
    /// refuse the device.
    CHANGED_DEVICE = "changed-device", "the vendor id or the product code is another one";

    /// A device of the family is gone: whoever has it can do nothing with the new description.
    REMOVED_DEVICE = "removed-device", "a device of the family is gone";

    /// A PDO that is assigned at start-up has other content: offsets, widths or the length of the process image are not
    /// what programs and stored projects take them for. Another length is noticed on the way to Safe-Operational, with AL
    /// status 0x001D or 0x001E; the same length in another order is noticed by nobody.
    CHANGED_IMAGE = "changed-image", "the default process image is another one";

    /// A PDO whose content a master cannot choose has other content. Masters that assign it exchange the wrong bytes, or
    /// fail with AL status 0x001D or 0x001E.
    CHANGED_FIXED_PDO = "changed-fixed-pdo", "a PDO with a fixed mapping has other content";

    /// A PDO is gone, or goes the other way. Masters that assign it are refused with SDO abort 0x06020000 or 0x06090030.
    REMOVED_PDO = "removed-pdo", "a PDO is gone";

    /// Other PDOs are assigned at start-up. Masters without a start-up list of their own take the new assignment, and
    /// their programs read it as the old one.
    CHANGED_ASSIGNMENT = "changed-assignment", "other PDOs are assigned by default";

    /// An object is gone. Reading and writing it ends in SDO abort 0x06020000; a master whose start-up list writes it does
    /// not get the device to run.
    REMOVED_OBJECT = "removed-object", "an object is gone";

    /// An entry is gone, or has another subindex. Reading and writing it ends in SDO abort 0x06090011.
    REMOVED_ENTRY = "removed-entry", "an entry of an object is gone";

    /// A single value has become a record or an array, or the other way round: what is at a subindex is something else.
    CHANGED_KIND = "changed-kind", "an object is made of something else";

    /// A value has another width. Writing it ends in SDO abort 0x06070010, 0x06070012 or 0x06070013, and who reads it takes
    /// too many bytes or too few.
    CHANGED_WIDTH = "changed-width", "a value has another width";

    /// A value has the same width and another meaning, as when a number gets a sign. Nobody notices it, and values are
    /// wrong: the worst kind of change.
    CHANGED_TYPE = "changed-type", "a value of the same width has another type";

    /// A value counts in another unit, or in other steps: the same bytes make another motion, and nobody notices.
    CHANGED_UNIT = "changed-unit", "a value has another unit or scale";

    /// A mode of operation is gone, or has another code. The drive does not take it, and 0x6061 never shows it.
    REMOVED_MODE = "removed-mode", "a mode of operation is gone";

    /// A state, a command or a transition is gone or has another pattern of bits. Programs wait for a state that never
    /// comes, or command something else.
    CHANGED_STATE_MACHINE = "changed-state-machine", "the state machine is another one";

    /// A bit of a word is gone, or means something else. Programs that set or read it do what they should not.
    MOVED_BITS = "moved-bits", "bits of a word are gone or mean something else";

    /// A sync manager has another address, role, direction or buffer, a mailbox another size, or their number is another
    /// one. Masters with stored settings fail with AL status 0x0016, 0x0017, 0x001D or 0x001E; those that read the EEPROM
    /// adapt.
    MOVED_SYNC_MANAGER = "moved-sync-manager", "the sync managers are others";

    /// The mailbox, or CANopen in it, is gone: nothing can be read, written or configured.
    REMOVED_COE = "removed-coe", "CANopen over EtherCAT is gone";

    /// The device no longer bears the command that reads and writes process data in one (LRW). Masters that use it get inputs
    /// that are none, or a working counter that is too low, and do not reach Operational.
    SPLIT_COMMANDS = "split-commands", "process data can no longer be read and written by one command";
}
