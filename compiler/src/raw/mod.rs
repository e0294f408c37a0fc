//! The format as written: one struct for each table, with what each key means, and no logic.
//!
//! The doc comments here are the reference of the format; `compiler/docs/format.md` is made from them.

mod compose;
mod configuration;
mod control;
pub(crate) mod decode;
mod device;
mod entity;
mod error;
mod fact;
mod front;
mod homing;
mod like;
mod literal;
mod mode;
mod object;
mod parameter;
mod pdo;
mod read;
mod register;
#[cfg(feature = "schema")]
pub mod schema;
mod state;
mod timing;
mod unit;
mod word;

pub use configuration::RawConfiguration;
pub use control::{RawDeviceControl, RawRefusal};
pub use device::{RawAxes, RawDocument, RawEeprom, RawFamily, RawHead, RawIdentity, RawShift};
pub use entity::{Entity, ObjectEntity};
pub use error::{RawError, RawVendorCode};
pub use fact::{RawAssumed, RawErratum, RawFacts, RawRemark, RawRemarkKind};
pub use front::{RawConnector, RawLed, RawLedPattern, RawLimit, RawMasterSetting, RawProcedure, RawStep};
pub use homing::{RawAlternative, RawDirection, RawHomingMethod};
pub use literal::{Duration, Fraction, Hex, Literal, OneOrMore};
pub use mode::{RawHomingBits, RawMode, RawModeChange, RawMotionCommand, RawStopOption};
pub use object::{Ignored, RawAccess, RawCategory, RawEntry, RawKind, RawMappable, RawObject, RawTrigger};
pub use parameter::{RawAxisGroup, RawCoordinates, RawGroup, RawParameter};
pub use pdo::{RawMailbox, RawMapped, RawPdo, RawSyncManager};
pub use read::read;
pub use register::{RawAlStatusCode, RawRegister, RawRegisterAccess, RawTelegram};
pub use state::{
    RawAnswer, RawCommand, RawCommunicationState, RawCommunicationTransition, RawEvent, RawScope, RawState,
    RawTransition,
};
pub use timing::{RawCycleTime, RawDeadTime, RawSyncMode, RawSyncSignal};
pub use unit::{RawAxisUnit, RawPath, RawUnit};
pub use word::{RawField, RawWord};

use serde::Deserialize;

use crate::diagnostic::Level;
use crate::source::Location;

/// A description, decoded table by table; every entity with the place it was written at.
#[derive(Debug)]
pub struct RawDevice {
    /// The name of the description's folder, with the member's for a family.
    pub id: String,
    /// `[device]`.
    pub head: Entity<RawHead>,
    /// `[identity]`.
    pub identity: Entity<RawIdentity>,
    /// `[eeprom]`.
    pub eeprom: Option<Entity<RawEeprom>>,
    /// `[axes]`.
    pub axes: Option<Entity<RawAxes>>,
    /// `[mailbox]`.
    pub mailbox: Option<Entity<RawMailbox>>,
    /// `[coordinates]`.
    pub coordinates: Option<Entity<RawCoordinates>>,
    /// `[dead-time]`.
    pub dead_time: Option<Entity<RawDeadTime>>,
    /// `[documents]`.
    pub documents: Vec<Entity<RawDocument>>,
    /// `[areas]`.
    pub areas: Vec<Entity<RawArea>>,
    /// `[objects]`.
    pub objects: Vec<ObjectEntity>,
    /// `[rx-pdos]`.
    pub rx_pdos: Vec<Entity<RawPdo>>,
    /// `[tx-pdos]`.
    pub tx_pdos: Vec<Entity<RawPdo>>,
    /// `[sync-managers]`.
    pub sync_managers: Vec<Entity<RawSyncManager>>,
    /// `[words]`.
    pub words: Vec<Entity<RawWord>>,
    /// `[states]`.
    pub states: Vec<Entity<RawState>>,
    /// `[commands]`.
    pub commands: Vec<Entity<RawCommand>>,
    /// `[transitions]`.
    pub transitions: Vec<Entity<RawTransition>>,
    /// `[device-control]`.
    pub device_control: Option<Entity<RawDeviceControl>>,
    /// `[communication-states]`.
    pub communication_states: Vec<Entity<RawCommunicationState>>,
    /// `[communication-transitions]`.
    pub communication_transitions: Vec<Entity<RawCommunicationTransition>>,
    /// `[modes]`.
    pub modes: Vec<Entity<RawMode>>,
    /// `[[mode-changes]]`.
    pub mode_changes: Vec<Entity<RawModeChange>>,
    /// `[[stop-options]]`.
    pub stop_options: Vec<Entity<RawStopOption>>,
    /// `[errors]`.
    pub errors: Vec<Entity<RawError>>,
    /// `[vendor-codes]`.
    pub vendor_codes: Vec<Entity<RawVendorCode>>,
    /// `[units]`.
    pub units: Vec<Entity<RawUnit>>,
    /// `[sync-modes]`.
    pub sync_modes: Vec<Entity<RawSyncMode>>,
    /// `[cycle-times]`.
    pub cycle_times: Vec<Entity<RawCycleTime>>,
    /// `[leds]`.
    pub leds: Vec<Entity<RawLed>>,
    /// `[connectors]`.
    pub connectors: Vec<Entity<RawConnector>>,
    /// `[parameters]`.
    pub parameters: Vec<Entity<RawParameter>>,
    /// `[homing-methods]`.
    pub homing_methods: Vec<Entity<RawHomingMethod>>,
    /// `[registers]`.
    pub registers: Vec<Entity<RawRegister>>,
    /// `[al-status-codes]`.
    pub al_status_codes: Vec<Entity<RawAlStatusCode>>,
    /// `[telegrams]`.
    pub telegrams: Vec<Entity<RawTelegram>>,
    /// `[configurations]`.
    pub configurations: Vec<Entity<RawConfiguration>>,
    /// `[limits]`.
    pub limits: Vec<Entity<RawLimit>>,
    /// `[[master-settings]]`.
    pub master_settings: Vec<Entity<RawMasterSetting>>,
    /// `[procedures]`.
    pub procedures: Vec<Entity<RawProcedure>>,
    /// `[[remarks]]`.
    pub remarks: Vec<Entity<RawRemark>>,
    /// `[[errata]]`.
    pub errata: Vec<Entity<RawErratum>>,
    /// `[lints]`: levels by rule or group.
    pub lints: Vec<LintSetting>,
}

/// `[areas."<index>..=<index>"]`: a title for a range of the dictionary.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawArea {
    /// The title.
    pub name: String,
    /// What the objects in it are for.
    pub about: Option<String>,
}

/// A level set in `[lints]`.
#[derive(Debug, Clone, PartialEq)]
pub struct LintSetting {
    /// The rule or group.
    pub name: String,
    /// The level: `allow`, `warn` or `deny`.
    pub level: Level,
    /// Where the rule is named.
    pub at: Location,
}
