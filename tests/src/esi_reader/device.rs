//! A device, without its dictionary.

use super::clocks::{self, OpMode};
use super::dictionary::{self, Dictionary};
use super::info::{set_number, timeouts};
use super::node::{
    Node, attribute, bytes, children, content, english, flag, number, only, optional, optional_english,
    optional_number, optional_text, text,
};
use super::texts::{Message, messages, translations};

/// A device.
#[derive(Debug)]
pub struct Device {
    /// One letter for each port.
    pub physics: String,
    /// Its type.
    pub type_name: String,
    /// Its product code.
    pub product_code: u32,
    /// Its revision.
    pub revision: u32,
    /// The revisions that tools hide.
    pub hidden: Vec<u32>,
    /// For how many milliseconds a master waits, by element.
    pub timeouts: Vec<(String, u32)>,
    /// Its sync units.
    pub sync_units: Vec<String>,
    /// Its name.
    pub name: String,
    /// Where to read about it.
    pub url: Option<String>,
    /// Texts in other languages than English: the name of the element, the number of the language, and the text.
    pub translations: Vec<(String, u16, String)>,
    /// The current from the E-bus, in milliamperes.
    pub ebus_current: Option<i32>,
    /// Whether masters must not use LRW.
    pub no_lrw: Option<u8>,
    /// Where the number is that people set: an address, and whether the AL status code has it.
    pub set_number: (Option<u16>, Option<String>),
    /// The messages of its diagnosis history.
    pub messages: Vec<Message>,
    /// The type of its group.
    pub group: String,
    /// Number and additional information of its profile.
    pub profile: (Option<u32>, Option<u32>),
    /// Number, additional information and name of each channel of the profile.
    pub channels: Vec<(u32, Option<u32>, Option<String>)>,
    /// Its object dictionary.
    pub dictionary: Dictionary,
    /// Its mapping units.
    pub fmmus: Vec<Fmmu>,
    /// Its sync managers.
    pub sync_managers: Vec<SyncManager>,
    /// What the master sends.
    pub rx_pdos: Vec<Pdo>,
    /// What the device sends.
    pub tx_pdos: Vec<Pdo>,
    /// The protocols of its mailbox, in order.
    pub protocols: Vec<String>,
    /// What it can do with CoE.
    pub coe: Option<CoE>,
    /// What it can do with EoE: IP and MAC address.
    pub eoe: (Option<u8>, Option<u8>),
    /// What a master writes at start-up.
    pub init_commands: Vec<InitCommand>,
    /// Its ways to keep time.
    pub op_modes: Vec<OpMode>,
    /// Its EEPROM.
    pub eeprom: Option<Eeprom>,
}

/// A mapping unit.
#[derive(Debug)]
pub struct Fmmu {
    /// What it is for.
    pub kind: String,
    /// The sync manager it is for.
    pub sync_manager: Option<usize>,
}

/// A sync manager.
#[derive(Debug)]
pub struct SyncManager {
    /// What it is for.
    pub kind: String,
    /// The first byte.
    pub address: u16,
    /// The smallest length.
    pub min_size: Option<u16>,
    /// The length by default.
    pub size: u16,
    /// The greatest length.
    pub max_size: Option<u16>,
    /// The control byte.
    pub control: u8,
    /// Whether it is on.
    pub enabled: bool,
    /// Whether it is on in Operational only.
    pub op_only: bool,
}

/// A PDO.
#[derive(Debug)]
pub struct Pdo {
    /// Its index.
    pub index: u16,
    /// Its name.
    pub name: String,
    /// Whether its mapping cannot be changed.
    pub fixed: bool,
    /// Whether it cannot be taken out.
    pub mandatory: bool,
    /// The sync manager it is assigned to at start-up.
    pub sync_manager: Option<usize>,
    /// The sync unit it belongs to.
    pub sync_unit: Option<usize>,
    /// The PDOs it cannot go with.
    pub excludes: Vec<u16>,
    /// What is in it.
    pub entries: Vec<PdoEntry>,
}

/// An entry of a PDO.
#[derive(Debug)]
pub struct PdoEntry {
    /// The object; 0 for padding.
    pub index: u16,
    /// The entry of the object.
    pub subindex: Option<u8>,
    /// The width in bits.
    pub bits: u32,
    /// Its name.
    pub name: Option<String>,
    /// Its basic type.
    pub data_type: Option<String>,
}

/// A write at start-up.
#[derive(Debug, PartialEq, Eq)]
pub struct InitCommand {
    /// The change of state during which it is made.
    pub transition: String,
    /// Index and subindex.
    pub address: (u16, u8),
    /// What is written.
    pub data: Vec<u8>,
}

/// What a device can do with CoE.
#[derive(Debug)]
pub struct CoE {
    /// Whether the dictionary can be read out.
    pub sdo_info: bool,
    /// Whether the assignment can be written.
    pub pdo_assign: bool,
    /// Whether mappings can be written.
    pub pdo_config: bool,
    /// Whether an object can be transferred as a whole.
    pub complete_access: bool,
    /// Whether long transfers are possible.
    pub segmented: bool,
}

/// The EEPROM.
#[derive(Debug)]
pub struct Eeprom {
    /// Its size in bytes.
    pub size: u32,
    /// Its first bytes.
    pub config_data: Vec<u8>,
}

pub(super) fn read(node: Node<'_, '_>) -> Result<Device, String> {
    let kind = only(node, "Type")?;
    let profile = only(node, "Profile")?;
    let mailbox = optional(node, "Mailbox")?;
    let coe = mailbox.map(|mailbox| optional(mailbox, "CoE")).transpose()?.flatten();
    let clocks = optional(node, "Dc")?;
    Ok(Device {
        physics: node.attribute("Physics").ok_or("a device without Physics")?.to_owned(),
        type_name: content(kind),
        product_code: attribute(kind, "ProductCode")?.ok_or("a type without ProductCode")?,
        revision: attribute(kind, "RevisionNo")?.ok_or("a type without RevisionNo")?,
        hidden: children(node, "HideType")
            .map(|it| attribute(it, "RevisionNo")?.ok_or_else(|| "a HideType without RevisionNo".to_owned()))
            .collect::<Result<_, _>>()?,
        timeouts: timeouts(node)?,
        sync_units: children(node, "Su").map(content).collect(),
        name: english(node, "Name")?,
        url: optional_english(node, "URL")?,
        translations: translations(node),
        ebus_current: optional(node, "Info")?
            .and_then(|info| only(info, "Electrical").ok())
            .map(|it| number(it, "EBusCurrent"))
            .transpose()?,
        no_lrw: attribute(kind, "UseLrdLwr")?,
        set_number: set_number(node)?,
        messages: messages(profile)?,
        group: text(node, "GroupType")?,
        profile: (optional_number(profile, "ProfileNo")?, optional_number(profile, "AddInfo")?),
        channels: children(profile, "ChannelInfo").map(channel).collect::<Result<_, _>>()?,
        dictionary: dictionary::read(only(profile, "Dictionary")?)?,
        fmmus: children(node, "Fmmu").map(fmmu).collect::<Result<_, _>>()?,
        sync_managers: children(node, "Sm").map(sync_manager).collect::<Result<_, _>>()?,
        rx_pdos: children(node, "RxPdo").map(pdo).collect::<Result<_, _>>()?,
        tx_pdos: children(node, "TxPdo").map(pdo).collect::<Result<_, _>>()?,
        protocols: mailbox.into_iter().flat_map(|mailbox| mailbox.children()).filter_map(protocol).collect(),
        coe: coe.map(abilities),
        eoe: match mailbox.map(|mailbox| optional(mailbox, "EoE")).transpose()?.flatten() {
            Some(eoe) => (attribute(eoe, "IP")?, attribute(eoe, "MAC")?),
            None => (None, None),
        },
        init_commands: coe
            .into_iter()
            .flat_map(|coe| children(coe, "InitCmd"))
            .map(init_command)
            .collect::<Result<_, _>>()?,
        op_modes: clocks
            .into_iter()
            .flat_map(|clocks| children(clocks, "OpMode"))
            .map(clocks::op_mode)
            .collect::<Result<_, _>>()?,
        eeprom: optional(node, "Eeprom")?.map(eeprom).transpose()?,
    })
}

fn channel(node: Node<'_, '_>) -> Result<(u32, Option<u32>, Option<String>), String> {
    Ok((number(node, "ProfileNo")?, optional_number(node, "AddInfo")?, optional_text(node, "DisplayName")?))
}

fn fmmu(node: Node<'_, '_>) -> Result<Fmmu, String> {
    Ok(Fmmu { kind: content(node), sync_manager: attribute(node, "Sm")? })
}

fn sync_manager(node: Node<'_, '_>) -> Result<SyncManager, String> {
    Ok(SyncManager {
        kind: content(node),
        address: attribute(node, "StartAddress")?.ok_or("an Sm without StartAddress")?,
        size: attribute(node, "DefaultSize")?.ok_or("an Sm without DefaultSize")?,
        min_size: attribute(node, "MinSize")?,
        max_size: attribute(node, "MaxSize")?,
        control: attribute(node, "ControlByte")?.ok_or("an Sm without ControlByte")?,
        enabled: flag(node, "Enable"),
        op_only: flag(node, "OpOnly"),
    })
}

fn pdo(node: Node<'_, '_>) -> Result<Pdo, String> {
    Ok(Pdo {
        index: number(node, "Index")?,
        name: english(node, "Name")?,
        fixed: flag(node, "Fixed"),
        mandatory: flag(node, "Mandatory"),
        sync_manager: attribute(node, "Sm")?,
        sync_unit: attribute(node, "Su")?,
        excludes: children(node, "Exclude").map(super::node::value).collect::<Result<_, _>>()?,
        entries: children(node, "Entry").map(entry).collect::<Result<_, _>>()?,
    })
}

fn entry(node: Node<'_, '_>) -> Result<PdoEntry, String> {
    Ok(PdoEntry {
        index: number(node, "Index")?,
        subindex: optional_number(node, "SubIndex")?,
        bits: number(node, "BitLen")?,
        name: optional_english(node, "Name")?,
        data_type: optional_text(node, "DataType")?,
    })
}

fn protocol(node: Node<'_, '_>) -> Option<String> {
    node.is_element().then(|| node.tag_name().name().to_owned())
}

fn init_command(node: Node<'_, '_>) -> Result<InitCommand, String> {
    Ok(InitCommand {
        transition: text(node, "Transition")?,
        address: (number(node, "Index")?, number(node, "SubIndex")?),
        data: bytes(only(node, "Data")?)?,
    })
}

fn abilities(node: Node<'_, '_>) -> CoE {
    CoE {
        sdo_info: flag(node, "SdoInfo"),
        pdo_assign: flag(node, "PdoAssign"),
        pdo_config: flag(node, "PdoConfig"),
        complete_access: flag(node, "CompleteAccess"),
        segmented: flag(node, "SegmentedSdo"),
    }
}

fn eeprom(node: Node<'_, '_>) -> Result<Eeprom, String> {
    Ok(Eeprom { size: number(node, "ByteSize")?, config_data: bytes(only(node, "ConfigData")?)? })
}
