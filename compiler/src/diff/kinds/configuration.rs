//! Changes that break how a device is set up.

use super::kinds;

kinds! { ConfigurationBreaking:
    /// The revision number is lower than it was: tools take the new description for the older one. The gate never lets
    /// this pass.
    LOWERED_REVISION = "lowered-revision", "the revision number is lower";

    /// A PDO that a master can map, and that is not assigned at start-up, is mapped otherwise by default. Masters that
    /// write the mapping do not notice; those that assign the PDO as it is exchange other data.
    CHANGED_MAPPING = "changed-mapping", "the default mapping of a PDO that is not assigned is another one";

    /// A PDO can no longer be mapped, taken out, or assigned together with another one, or takes less. What was chosen
    /// before is refused, with SDO abort 0x06010002, 0x06040041 or 0x06040042.
    RESTRICTED_PDO = "restricted-pdo", "less can be done with a PDO";

    /// A value can no longer be read or written, or not in as many EtherCAT states. A start-up list that does so ends in
    /// SDO abort 0x06010001, 0x06010002 or 0x08000022.
    NARROWED_ACCESS = "narrowed-access", "less can be done with a value";

    /// A value can no longer be mapped to process data. Masters that map it are refused with SDO abort 0x06040041.
    UNMAPPABLE_ENTRY = "unmappable", "a value can no longer be mapped";

    /// A value is another one after start-up. Who relies on it and does not write it gets another behaviour.
    CHANGED_DEFAULT = "changed-default", "a value is another one after start-up";

    /// A limit of a value that masters write is narrower, or new: what was accepted ends in SDO abort 0x06090030 to
    /// 0x06090032. For a value that only the device writes it is the wider limit that surprises its reader.
    CHANGED_LIMITS = "changed-limits", "a value is limited otherwise";

    /// A value of an enumeration is gone, or its number has another meaning.
    CHANGED_VALUE = "changed-value", "a named value is gone or means something else";

    /// Writing a value sets off something else, or nothing.
    CHANGED_TRIGGER = "changed-trigger", "writing a value sets off something else";

    /// Tools no longer save a value with the settings of a machine: a device that takes the place of another one starts
    /// without it.
    UNSAVED_VALUE = "unsaved-value", "tools no longer save a value";

    /// A value is another one to the safety of a machine: a safe input or output, or a parameter that safety depends on. Tools
    /// for safety map and check it by that, and have to set it up again.
    CHANGED_SAFETY = "changed-safety", "a value is another one to the safety of a machine";

    /// What is there does nothing any more; reading and writing it still works.
    LOST_FUNCTION = "lost-function", "an object does nothing any more";

    /// The device takes more current from the E-bus, or gives less. Configuration tools add up what the devices behind a
    /// coupler take: what was enough may be so no longer.
    RAISED_CURRENT = "raised-current", "the device takes more current from the E-bus";

    /// An error code is gone, or has another meaning or another bit of the error register; or a message of the diagnosis history. Programs that look for it do not
    /// find it, or take it for something else.
    CHANGED_ERROR = "changed-error", "an error code is gone or means something else";

    /// The drive does something else in a state or on the way to one, or leaves a state by itself that it used to keep.
    CHANGED_BEHAVIOUR = "changed-behaviour", "the drive behaves otherwise";

    /// A way to find the reference position is gone or does something else.
    CHANGED_HOMING = "changed-homing", "a homing method is gone or another one";

    /// The ESI lists axes as slots and no longer as one dictionary, or the other way round, or the modules in the slots are
    /// others. Tools that set up slots have to do it again; a device that compares 0xF030 with what it finds stays in
    /// Pre-Operational, with AL status 0x0070.
    CHANGED_SLOTS = "changed-slots", "the slots of the ESI, or the modules in them, are others";

    /// A sync manager's outputs are newly watched or no longer, or its interrupts are others. A master that is too slow
    /// for the watchdog loses the device, with AL status 0x001B.
    CHANGED_WATCHDOG = "changed-watchdog", "watchdog or interrupts of a sync manager are others";

    /// The area of a sync manager can get less long than it could.
    REDUCED_AREA = "reduced-area", "a sync manager's area is smaller";

    /// Masters are to accept fewer devices in place of this one: product codes or revisions that a configuration tool let
    /// pass are refused at start-up.
    NARROWED_CHECK = "narrowed-check", "masters accept fewer devices in its place";

    /// A master no longer finds the number that people set at the device, or finds it elsewhere: what is hot-connected is
    /// not recognised (ETG.1020).
    LOST_ID = "lost-id", "the number that people set is no longer found where it was";

    /// A protocol of the mailbox other than CANopen is gone, or an ability such as the assignment of PDOs. Tools and
    /// start-up lists that use it fail.
    REMOVED_ABILITY = "removed-ability", "the mailbox can do less";

    /// A start-up configuration is gone, or its list of writes is another one. Projects that were made before keep the old
    /// list; new ones take the new one.
    CHANGED_START_UP = "changed-start-up", "a start-up configuration is another one";

    /// A way to keep time with the master is gone, has another name, other signals, or another one is the default.
    /// Projects store the mode by its name.
    CHANGED_SYNC_MODE = "changed-sync-mode", "a synchronisation mode is gone or another one";

    /// The shortest cycle is longer, a cycle can no longer be chosen, or an effect comes later.
    LENGTHENED_TIME = "lengthened-time", "a cycle or a dead time is longer";

    /// The first words of the EEPROM are others, or the ports: a device whose EEPROM is written anew starts otherwise.
    CHANGED_HARDWARE = "changed-hardware", "the EEPROM's configuration or the ports are others";

    /// The device follows another profile, or says so in 0x1000, which masters may compare.
    CHANGED_PROFILE = "changed-profile", "the device profile is another one";
}
