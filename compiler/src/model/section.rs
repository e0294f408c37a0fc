//! The sections of a description: the one list of them.

/// Hands the list of sections to a macro: for each its name, the word for it in a description, how its tables are told
/// apart, and what a table is read into.
///
/// A new section is one line here, its struct, and what makes use of it.
macro_rules! for_each_section {
    ($do:ident) => {
        $do! {
            Device head "device" Single RawHead,
            Family family "family" Single Shared,
            Identity identity "identity" Single Identity,
            Eeprom eeprom "eeprom" Single Eeprom,
            Documents documents "documents" Words Document,
            Axes axes "axes" Single RawAxes,
            Modules modules "modules" Indices Module,
            Slots slots "slots" Words Slot,
            Areas areas "areas" Indices Area,
            Objects objects "objects" Indices RawObject,
            Enumerations enumerations "enumerations" Words Enumeration,
            Coordinates coordinates "coordinates" Single RawCoordinates,
            Parameters parameters "parameters" Words Parameter,
            Units units "units" Words RawUnit,
            RxPdos rx_pdos "rx-pdos" Indices RawPdo,
            TxPdos tx_pdos "tx-pdos" Indices RawPdo,
            SyncManagers sync_managers "sync-managers" Words RawSyncManager,
            Mailbox mailbox "mailbox" Single Mailbox,
            Timeouts timeouts "timeouts" Single Timeouts,
            Configurations configurations "configurations" Words RawConfiguration,
            Words words "words" Words RawWord,
            States states "states" Words State,
            Commands commands "commands" Words Command,
            Transitions transitions "transitions" Numbers Transition,
            DeviceControl device_control "device-control" Single DeviceControl,
            CommunicationStates communication_states "communication-states" Words CommunicationState,
            CommunicationTransitions communication_transitions "communication-transitions" Words CommunicationTransition,
            Modes modes "modes" Numbers RawMode,
            ModeChanges mode_changes "mode-changes" List ModeChange,
            StopOptions stop_options "stop-options" List StopOption,
            HomingMethods homing_methods "homing-methods" Numbers HomingMethod,
            Errors errors "errors" Indices ErrorCode,
            VendorCodes vendor_codes "vendor-codes" Numbers VendorCode,
            Diagnosis diagnosis "diagnosis" Indices DiagnosisMessage,
            SyncModes sync_modes "sync-modes" Words SyncMode,
            CycleTimes cycle_times "cycle-times" Words CycleTime,
            DeadTime dead_time "dead-time" Single DeadTime,
            Registers registers "registers" Indices Register,
            AlStatusCodes al_status_codes "al-status-codes" Indices AlStatusCode,
            AbortCodes abort_codes "abort-codes" Numbers AbortCode,
            Telegrams telegrams "telegrams" Words Telegram,
            Leds leds "leds" Words Led,
            Connectors connectors "connectors" Words Connector,
            Limits limits "limits" Words Limit,
            MasterSettings master_settings "master-settings" List MasterSetting,
            Procedures procedures "procedures" Words RawProcedure,
            Remarks remarks "remarks" List Remark,
            Errata errata "errata" List Erratum,
        }
    };
}
pub(crate) use for_each_section;

/// How the tables of a section are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// There is one.
    Single,
    /// By a word.
    Words,
    /// By a number.
    Numbers,
    /// By a number that people write in hexadecimal.
    Indices,
    /// By their place in a list.
    List,
}

macro_rules! sections {
    ($($name:ident $field:ident $key:literal $shape:ident $table:ty,)*) => {
        /// A section of a description: a table at its top.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Section {
            $(
                #[doc = concat!("`[", $key, "]`.")]
                $name,
            )*
        }

        impl Section {
            /// All of them, in the order in which they are explained.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Its key in a description.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $key,)*
                }
            }

            /// The section whose tables are this field of a device.
            pub(crate) fn of_field(field: &str) -> Option<Self> {
                match field {
                    $(stringify!($field) => Some(Self::$name),)*
                    _ => None,
                }
            }

            /// How its tables are told apart.
            pub fn shape(self) -> Shape {
                match self {
                    $(Self::$name => Shape::$shape,)*
                }
            }
        }
    };
}
for_each_section!(sections);

impl Section {
    /// The section of this name.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|section| section.name() == name)
    }
}
