//! What an ESI file says, as plain structs: each thing with its place in the file.

use super::element::At;
pub(crate) use super::objects::{Choice, Datum, Flags, Object, Property, Shape, Value, Written};
use crate::model::{CheckedCode, CheckedRevision, Language, Oversampling};

/// A text in other languages than English.
pub(crate) type Texts = Vec<(Language, String)>;

/// A file.
#[derive(Debug, Default)]
pub(crate) struct Esi {
    pub(crate) vendor_id: Option<u32>,
    pub(crate) vendor_name: Option<String>,
}

/// What tells a device from the others of its file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Head {
    pub(crate) at: At,
    pub(crate) type_name: String,
    pub(crate) product_code: Option<u32>,
    pub(crate) revision: u32,
    pub(crate) name: String,
}

/// A device.
#[derive(Debug, Default)]
pub(crate) struct Device {
    pub(crate) head: Head,
    pub(crate) names: Texts,
    pub(crate) url: Option<String>,
    pub(crate) urls: Texts,
    pub(crate) ebus_current: Option<i32>,
    pub(crate) group: Option<String>,
    pub(crate) physics: Option<String>,
    pub(crate) profile: Option<u32>,
    pub(crate) add_info: Option<(u32, At)>,
    pub(crate) channels: Vec<Channel>,
    pub(crate) channel_count: Option<(usize, At)>,
    pub(crate) fmmus: Vec<Fmmu>,
    pub(crate) sync_managers: Vec<Sm>,
    pub(crate) rx_pdos: Vec<Pdo>,
    pub(crate) tx_pdos: Vec<Pdo>,
    pub(crate) mailbox: Option<Mailbox>,
    pub(crate) timeouts: Vec<Timeout>,
    /// The revisions that it takes the place of.
    pub(crate) replaces: Vec<u32>,
    /// What a master is to compare: the product code and the revision.
    pub(crate) check_product_code: Option<CheckedCode>,
    pub(crate) check_revision: Option<CheckedRevision>,
    pub(crate) requested_id: bool,
    pub(crate) id_address: Option<u16>,
    pub(crate) no_lrw: bool,
    /// What the sync units are called, in their order.
    pub(crate) sync_units: Vec<String>,
    pub(crate) op_modes: Vec<OpMode>,
    /// Choices of PDOs with names.
    pub(crate) alternatives: Vec<Alternative>,
    pub(crate) eeprom: Option<Eeprom>,
    /// The picture that tools show, a BMP file.
    pub(crate) picture: Option<Vec<u8>>,
    /// What the slots or axes are called, if the file says it.
    pub(crate) slots: Vec<String>,
    /// The modules that are in the slots, one for each; none if that is open.
    pub(crate) plugged: Vec<Plug>,
    /// Slots whose modules are to be chosen.
    pub(crate) open_slots: Vec<OpenSlot>,
    /// Whether it says of no value if it can be mapped.
    pub(crate) hides_mapping: bool,
    pub(crate) objects: Vec<Object>,
    pub(crate) messages: Vec<Message>,
    /// The first object that was one too many.
    pub(crate) excess: Option<At>,
}

/// What the profile says of a channel.
#[derive(Debug)]
pub(crate) struct Channel {
    pub(crate) at: At,
    pub(crate) name: Option<String>,
    pub(crate) add_info: Option<u32>,
}

/// How long a master waits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Timeout {
    pub(crate) at: At,
    /// The key of a description.
    pub(crate) key: &'static str,
    pub(crate) milliseconds: u32,
}

/// A module in a slot.
#[derive(Debug)]
pub(crate) struct Plug {
    pub(crate) at: At,
    pub(crate) ident: u32,
    pub(crate) name: String,
    /// How far apart the objects and the PDOs of the slots are.
    pub(crate) index_step: u16,
    pub(crate) pdo_step: u16,
}

/// A slot whose module is to be chosen.
#[derive(Debug, Default)]
pub(crate) struct OpenSlot {
    pub(crate) at: At,
    pub(crate) name: Option<String>,
    pub(crate) names: Texts,
    pub(crate) min: u16,
    pub(crate) max: u16,
    pub(crate) index_step: u16,
    pub(crate) pdo_step: u16,
    pub(crate) modules: Vec<u32>,
    pub(crate) default: Option<u32>,
    /// What classes of modules fit, each with its name.
    pub(crate) classes: Vec<(String, Option<String>, Texts)>,
}

#[derive(Debug, Default)]
pub(crate) struct Fmmu {
    pub(crate) at: At,
    pub(crate) name: String,
    pub(crate) sm: Option<u8>,
    /// The number of the sync unit.
    pub(crate) su: Option<u8>,
}

#[derive(Debug, Default)]
pub(crate) struct Sm {
    pub(crate) at: At,
    pub(crate) name: String,
    pub(crate) address: Option<u16>,
    pub(crate) default_size: Option<u16>,
    pub(crate) min_size: Option<u16>,
    pub(crate) max_size: Option<u16>,
    pub(crate) control: Option<u8>,
    pub(crate) enable: Option<bool>,
    pub(crate) op_only: bool,
    pub(crate) r#virtual: bool,
}

#[derive(Debug, Default)]
pub(crate) struct Pdo {
    pub(crate) at: At,
    pub(crate) index: u16,
    pub(crate) name: Option<String>,
    pub(crate) names: Texts,
    pub(crate) fixed: bool,
    pub(crate) mandatory: bool,
    pub(crate) sm: Option<u8>,
    /// The number of its sync unit.
    pub(crate) su: Option<u8>,
    pub(crate) r#virtual: bool,
    pub(crate) oversampling: Option<Oversampling>,
    pub(crate) excludes: Vec<(u16, At)>,
    pub(crate) entries: Vec<PdoEntry>,
}

#[derive(Debug, Default)]
pub(crate) struct PdoEntry {
    pub(crate) at: At,
    /// 0 for padding.
    pub(crate) index: u16,
    pub(crate) subindex: u8,
    pub(crate) bits: u16,
    pub(crate) name: Option<String>,
    pub(crate) names: Texts,
    pub(crate) data_type: Option<String>,
    pub(crate) comment: Option<String>,
}

#[derive(Debug, Default)]
pub(crate) struct Mailbox {
    pub(crate) at: At,
    /// The protocols by the names of their elements.
    pub(crate) protocols: Vec<String>,
    /// Whether the file says that mail is acknowledged.
    pub(crate) acknowledged: bool,
    pub(crate) sdo_info: bool,
    pub(crate) pdo_assign: bool,
    pub(crate) pdo_config: bool,
    pub(crate) complete_access: bool,
    pub(crate) segmented: bool,
    /// Abilities that it may be silent about, by the keys of a description.
    pub(crate) others: Vec<(&'static str, bool)>,
    /// Whether it says that there is a list of diagnosis messages.
    pub(crate) diagnosis: bool,
    pub(crate) commands: Vec<InitCmd>,
}

#[derive(Debug, Default)]
pub(crate) struct InitCmd {
    pub(crate) at: At,
    pub(crate) transitions: Vec<String>,
    pub(crate) index: u16,
    pub(crate) subindex: u8,
    pub(crate) data: Vec<u8>,
    /// Whether it writes an object as a whole.
    pub(crate) complete_access: bool,
    pub(crate) comment: Option<String>,
    /// How many facts it is.
    pub(crate) facts: usize,
}

#[derive(Debug, Default)]
pub(crate) struct OpMode {
    pub(crate) at: At,
    pub(crate) name: String,
    pub(crate) description: Option<String>,
    pub(crate) assign_activate: u16,
    pub(crate) sync0: Option<Signal>,
    pub(crate) sync1: Option<Signal>,
    pub(crate) managers: Vec<ModeManager>,
}

/// What a sync manager does in a mode.
#[derive(Debug, Default)]
pub(crate) struct ModeManager {
    pub(crate) at: At,
    /// Its place among the sync managers.
    pub(crate) number: u8,
    pub(crate) sync_type: Option<u16>,
    /// The PDOs that it carries, and how often each is there.
    pub(crate) pdos: Vec<(u16, Option<u16>)>,
}

#[derive(Debug, Default)]
pub(crate) struct Signal {
    pub(crate) at: At,
    /// The period in nanoseconds; 0 leaves it to the factor.
    pub(crate) cycle: i64,
    pub(crate) factor: Option<i32>,
    pub(crate) shift: i64,
    pub(crate) shift_factor: Option<i32>,
    pub(crate) of_inputs: bool,
}

/// A choice of PDOs with a name.
#[derive(Debug, Default)]
pub(crate) struct Alternative {
    pub(crate) at: At,
    pub(crate) name: String,
    /// The PDOs by the place of their sync manager.
    pub(crate) managers: Vec<(u8, Vec<u16>)>,
    /// How many facts it is.
    pub(crate) facts: usize,
}

/// A message of the diagnosis history.
#[derive(Debug, Default)]
pub(crate) struct Message {
    pub(crate) at: At,
    pub(crate) text_id: u32,
    pub(crate) text: String,
    pub(crate) texts: Texts,
    pub(crate) class: Option<&'static str>,
    pub(crate) about: Option<String>,
    pub(crate) remedy: Option<String>,
}

#[derive(Debug, Default)]
pub(crate) struct Eeprom {
    pub(crate) at: At,
    pub(crate) size: Option<u32>,
    pub(crate) config_data: Vec<u8>,
    pub(crate) bootstrap: Vec<u8>,
}
