//! The device as it is: every reference bound, every axis written out, every PDO laid out.
//!
//! The model is plain data. Where a thing was written is kept beside it as an [`Origin`] and is not part of what the
//! model says; all else is, and the JSON output is this model, word for word.

mod axis;
mod bounds;
mod carried;
mod citation;
mod compare;
mod compared;
mod configuration;
mod control;
mod data_type;
mod diagnosis;
mod difference;
mod enumeration;
mod error;
mod fact;
mod field;
mod front;
mod homing;
mod identity;
pub(crate) mod ids;
mod index;
mod kept;
mod keyed;
mod language;
mod lasting;
mod literal;
mod lookup;
mod machine;
mod meaning;
mod mode;
mod mode_manager;
mod module;
mod object;
mod on_axis;
mod parameter;
mod parts;
mod pattern;
mod pdo;
mod picture;
mod place;
mod ports;
mod provenance;
mod register;
mod repetition;
mod safety;
mod said;
#[cfg(feature = "schema")]
pub(crate) mod schema;
mod section;
pub(crate) mod shorthand;
mod slot;
mod state;
mod symbol;
pub(crate) mod table;
mod timing;
mod told;
mod transport;
mod type_name;
mod unit;
mod value;
mod walk;
mod word;

use crate::source::Origin;
pub use axis::{Area, Arrangement, Axis, Shift};
pub use bounds::Bounds;
pub use carried::Carried;
pub use citation::Source;
pub use compare::{Beside, Compare, Walker, differences};
pub use configuration::{ChosenWrite, Configuration, SdoWrite};
pub use control::{DeviceControl, Refusal};
pub use data_type::{DataType, Item};
pub use diagnosis::{DiagnosisClass, DiagnosisMessage};
pub use difference::{Difference, FieldPath, PathStep};
pub use enumeration::Enumeration;
pub use error::{ErrorCode, VendorCode};
pub use fact::{Assumption, Document, Erratum, Remark, RemarkKind, Tables, Written};
pub use field::{Field, Fields};
pub use front::{Connector, Led, LedPattern, Limit, MasterSetting, Procedure, Step};
pub use homing::{Alternative, HomingMethod, Way};
pub use identity::{CheckedCode, CheckedRevision, Identity};
pub use index::{Address, Index};
pub use language::{Language, Translation, Translations};
pub use lasting::{Effective, Stored};
pub use literal::{Delay, Duration, Fraction, Hex, Literal, OneOrMore};
pub use machine::Given;
pub use meaning::{Meaning, Meanings, Notation, ValueRange, ValueRanges};
pub use mode::{HomingBits, Mode, ModeChange, MotionCommand, StopOption};
pub use mode_manager::{ModeManager, ModeManagers, ModePdo};
pub use module::{Module, Slots};
pub use object::{Access, Category, Entry, Kind, Mappable, Object, Property, Trigger, WriteWindow};
pub(crate) use parameter::coordinate;
pub use parameter::{AxisGroup, Coordinates, Group, Parameter};
pub(crate) use parts::{model, plain};
pub use pattern::{Bit, Pattern};
pub use pdo::{Direction, Mapped, Oversampling, Pdo};
pub use picture::Picture;
pub use place::Place;
pub(crate) use ports::are_ports;
pub use provenance::{Provenance, assumption, facts, facts_of_type, provenance};
pub use register::{AbortCode, AlStatusCode, Register, RegisterAccess, Telegram};
pub(crate) use repetition::repetitions;
pub use repetition::{Repeated, Repetition};
pub use safety::{Safety, SdoAccess};
pub use said::Said;
pub(crate) use section::for_each_section;
pub use section::{Section, Shape};
pub use slot::{ModuleClass, Slot};
pub use state::{
    Answer, Command, CommunicationState, CommunicationTransition, Event, Scope, State, Transition,
};
pub use symbol::{Dimension, SYMBOLS, Symbol, dimensions};
pub use table::Table;
use table::table;
pub use timing::{CycleTime, DeadTime, LimitedUse, SyncMode, SyncSignal, Timeouts};
pub use told::Pair;
pub use transport::{Eeprom, Mailbox, Protocol, Role, SyncManager};
#[cfg(any(feature = "esi", feature = "import"))]
pub(crate) use unit::UnitCode;
pub use unit::{AxisUnit, Path, Scale, Unit};
pub use value::Value;
pub use word::Word;

model! {
    /// Devices that share a description: the members of a family, or one device alone.
    pub struct Family {
        /// The name of the description's folder, and of its outputs.
        pub id: String,
        /// The name of the family; the device's if it is alone.
        pub name: String,
        /// What its members share, and what tells them apart.
        pub about: Option<String>,
        /// Where these facts are from.
        pub source: Option<Source>,
        /// The devices, in the order in which they were written; never none.
        pub members: Vec<Device>,
        /// Where `[family]` stands.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A drive.
    pub struct Device by id {
        /// The word for it; the family's id if it is alone.
        pub id: String,
        /// The name people order it by.
        pub name: String,
        /// The name in other languages, by language.
        pub names: Translations,
        /// The vendor's name.
        pub vendor: String,
        /// What it is, in one line.
        pub title: Option<String>,
        /// What it is, in a paragraph.
        pub about: Option<String>,
        /// The order numbers that share this description.
        pub models: Vec<String>,
        /// The group a configuration tool lists it under.
        pub group: String,
        /// The type as an ESI names it.
        pub type_name: String,
        /// The device profile it follows.
        pub profile: Option<u32>,
        /// One letter for each port as an ESI has it.
        pub physics: String,
        /// The current that it takes from the E-bus, in milliamperes; what it gives if negative.
        pub ebus_current: Option<i32>,
        /// Whether masters must read and write process data with a command each, LRD and LWR instead of LRW.
        pub no_lrw: bool,
        /// Where to read about it.
        pub url: Option<String>,
        /// Where to read about it in other languages, by language.
        pub urls: Translations,
        /// The picture that tools show beside its name.
        pub image: Option<Picture>,
        /// What 0x1018 and the EEPROM say.
        pub identity: Identity,
        /// The EEPROM.
        pub eeprom: Eeprom,
        /// The documents that facts are taken from; the first is the main one.
        pub documents: Vec<Document>,
        /// The axes, in order; one at least.
        pub axes: Vec<Axis>,
        /// How the axes share the dictionary and depend on each other.
        pub arrangement: Arrangement,
        /// What is in the slots of axes, by number; none if the ESI has all axes in one dictionary.
        pub modules: Vec<Module>,
        /// Places for modules that are described elsewhere.
        pub slots: Vec<Slot>,
        /// What each axis has: objects and PDOs, by the index on the first axis.
        pub repetitions: Vec<Repetition>,
        /// Titles of ranges of the dictionary, by index.
        pub areas: Vec<Area>,
        /// What values mean that several entries share.
        pub enumerations: Vec<Enumeration>,
        /// The object dictionary, by index.
        pub objects: Vec<Object>,
        /// The process data objects, by index: what the master sends, then what the device sends.
        pub pdos: Vec<Pdo>,
        /// The sync managers, by number.
        pub sync_managers: Vec<SyncManager>,
        /// The mailbox.
        pub mailbox: Option<Mailbox>,
        /// How long a master waits, if that is said.
        pub timeouts: Option<Timeouts>,
        /// The words made of bits.
        pub words: Vec<Word>,
        /// The states of a drive, in the order of the standard.
        pub states: Vec<State>,
        /// The commands of the controlword.
        pub commands: Vec<Command>,
        /// The changes of state, by number.
        pub transitions: Vec<Transition>,
        /// What the drive does with what is not allowed, if that is said.
        pub device_control: Option<DeviceControl>,
        /// The EtherCAT states.
        pub communication_states: Vec<CommunicationState>,
        /// The changes of the EtherCAT state.
        pub communication_transitions: Vec<CommunicationTransition>,
        /// The modes of operation, by code.
        pub modes: Vec<Mode>,
        /// The changes of mode that the device knows.
        pub mode_changes: Vec<ModeChange>,
        /// What stops the drive.
        pub stop_options: Vec<StopOption>,
        /// The error codes, by code.
        pub errors: Vec<ErrorCode>,
        /// Codes of the vendor's own system, by code.
        pub vendor_codes: Vec<VendorCode>,
        /// The messages of the diagnosis history, by text id.
        pub diagnosis: Vec<DiagnosisMessage>,
        /// Units and scaling.
        pub units: Vec<Unit>,
        /// Ways to keep time with the master, the default first.
        pub sync_modes: Vec<SyncMode>,
        /// How often set values may come.
        pub cycle_times: Vec<CycleTime>,
        /// The time from a set value to its effect.
        pub dead_time: Option<DeadTime>,
        /// Lights.
        pub leds: Vec<Led>,
        /// Sockets.
        pub connectors: Vec<Connector>,
        /// Settings outside the dictionary.
        pub parameters: Vec<Parameter>,
        /// How the vendor's parameters lie in the dictionary.
        pub coordinates: Option<Coordinates>,
        /// Ways to find the reference position, by number.
        pub homing_methods: Vec<HomingMethod>,
        /// Registers of the EtherCAT slave controller, by address.
        pub registers: Vec<Register>,
        /// Why the device refuses or leaves an EtherCAT state, by code.
        pub al_status_codes: Vec<AlStatusCode>,
        /// Why the device ends SDO transfers, by code.
        pub abort_codes: Vec<AbortCode>,
        /// The bytes of messages.
        pub telegrams: Vec<Telegram>,
        /// Choices of process data and mode.
        pub configurations: Vec<Configuration>,
        /// Figures that the device keeps to or asks for.
        pub limits: Vec<Limit>,
        /// What is to be set in the master.
        pub master_settings: Vec<MasterSetting>,
        /// Things to do in order.
        pub procedures: Vec<Procedure>,
        /// What no source states.
        pub assumptions: Vec<Assumption>,
        /// Weaknesses of the sources that no rule can see.
        pub remarks: Vec<Remark>,
        /// Answers to findings of rules.
        pub errata: Vec<Erratum>,
        /// Every table of the description.
        #[cfg_attr(feature = "json", serde(skip))]
        pub written: Tables,
        /// Where the facts of `[device]` are from.
        pub source: Option<Source>,
        /// Where `[device]` stands.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }
}

table! {
    /// `[family]`: what the members of a family have in common.
    pub struct Shared {
        /// The name of the family.
        pub name: String,
        /// What its members share, and what tells them apart.
        pub about: Option<String>,
    }
}

/// What a key says that is left out.
pub(crate) fn yes() -> bool {
    true
}
