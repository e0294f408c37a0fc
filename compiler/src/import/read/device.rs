//! A device: identity, mailbox, clocks, EEPROM.

use super::element::{At, Element};
use super::esi::{
    Alternative, Channel, Device, Eeprom, Head, InitCmd, Mailbox, ModeManager, OpMode, Signal, Timeout,
};
use super::number::{bytes, number, truth};
use super::{diagnosis, dictionary, process_data, words};
use crate::model::{CheckedCode, CheckedRevision, are_ports};
use crate::raw::MOST_OF_PICTURE;

pub(super) fn head(device: &Element<'_>) -> Head {
    let kind = device.child("Type");
    let code = |name| kind.and_then(|kind| kind.attribute_as(name, number));
    let type_name = kind.map(|kind| kind.text().to_owned()).unwrap_or_default();
    let name = words::name(device, "Name").unwrap_or_else(|| type_name.clone());
    Head {
        at: device.at(),
        product_code: code("ProductCode"),
        revision: code("RevisionNo").unwrap_or(0),
        type_name,
        name,
    }
}

pub(super) fn device(device: &Element<'_>) -> Device {
    let profiles: Vec<&Element<'_>> = device.all("Profile").collect();
    let profile = profiles.iter().find_map(|profile| profile_number(profile));
    let channels = profiles.iter().flat_map(|it| it.all("ChannelInfo")).map(|it| channel(it, profile));
    let dictionaries = profiles.iter().flat_map(|profile| profile.all("Dictionary"));
    let (objects, excess): (Vec<_>, Vec<_>) = dictionaries.map(dictionary::objects).unzip();
    Device {
        head: head(device),
        names: words::others(device, "Name"),
        url: words::name(device, "URL"),
        urls: words::others(device, "URL"),
        ebus_current: device.child("Info").and_then(ebus_current),
        group: device.child("GroupType").map(|group| group.text().to_owned()),
        physics: device
            .attribute_as("Physics", |text| Some(text.to_ascii_uppercase()).filter(|it| are_ports(it))),
        profile,
        add_info: profiles.iter().find_map(|profile| placed(profile, "AddInfo")),
        channel_count: profiles.iter().find_map(|profile| placed(profile, "ChannelCount")),
        channels: channels.collect(),
        fmmus: device.all("Fmmu").map(process_data::fmmu).collect(),
        sync_managers: device.all("Sm").map(process_data::sm).collect(),
        rx_pdos: device.all("RxPdo").filter_map(process_data::pdo).collect(),
        tx_pdos: device.all("TxPdo").filter_map(process_data::pdo).collect(),
        mailbox: device.child("Mailbox").map(mailbox),
        timeouts: device.child("Info").map(timeouts).unwrap_or_default(),
        replaces: device.all("HideType").filter_map(|it| it.attribute_as("RevisionNo", number)).collect(),
        check_product_code: checked(device, "CheckProductCode", &CheckedCode::ALL, CheckedCode::name),
        check_revision: checked(device, "CheckRevisionNo", &CheckedRevision::ALL, CheckedRevision::name),
        requested_id: says(device.child("Info"), "IdentificationReg134"),
        id_address: device.child("Info").and_then(|info| info.child_as("IdentificationAdo", number)),
        no_lrw: device.child("Type").and_then(|it| it.attribute_as("UseLrdLwr", truth)).unwrap_or(false),
        sync_units: device.all("Su").map(|it| it.text().to_owned()).collect(),
        op_modes: device.child("Dc").into_iter().flat_map(|dc| dc.all("OpMode")).map(op_mode).collect(),
        alternatives: alternatives(device),
        eeprom: device.child("Eeprom").map(eeprom),
        picture: device.child_as("ImageData16x14", picture),
        slots: Vec::new(),
        plugged: Vec::new(),
        open_slots: Vec::new(),
        hides_mapping: false,
        objects: objects.into_iter().flatten().collect(),
        messages: profiles.iter().flat_map(|profile| diagnosis::messages(profile)).collect(),
        excess: excess.into_iter().flatten().next(),
    }
}

/// What a master is to compare.
fn checked<T: Copy>(device: &Element<'_>, name: &str, all: &[T], word: fn(T) -> &'static str) -> Option<T> {
    let of = |text: &str| all.iter().copied().find(|it| word(*it) == text);
    device.child("Type")?.attribute_as(name, of)
}

/// Whether there is an element, and says that something holds.
fn says(parent: Option<&Element<'_>>, name: &str) -> bool {
    parent.and_then(|parent| parent.child_as(name, truth)).unwrap_or(false)
}

fn ebus_current(info: &Element<'_>) -> Option<i32> {
    info.child("Electrical")?.child_as("EBusCurrent", number)
}

/// How long a master waits, by the keys of a description.
fn timeouts(info: &Element<'_>) -> Vec<Timeout> {
    let kinds = [
        ("StateMachine", "PreopTimeout", "pre-op"),
        ("StateMachine", "SafeopOpTimeout", "safe-op-op"),
        ("StateMachine", "BackToInitTimeout", "back-to-init"),
        ("StateMachine", "BackToSafeopTimeout", "back-to-safe-op"),
        ("Mailbox", "RequestTimeout", "request"),
        ("Mailbox", "ResponseTimeout", "response"),
    ];
    let read = |(part, name, key)| {
        let timeout = info.child(part)?.child("Timeout")?;
        let milliseconds = timeout.child_as(name, number)?;
        Some(Timeout { at: timeout.child(name)?.at(), key, milliseconds })
    };
    kinds.into_iter().filter_map(read).collect()
}

/// A number with its place.
fn placed<T: TryFrom<i128>>(parent: &Element<'_>, name: &str) -> Option<(T, At)> {
    Some((parent.child_as(name, number)?, parent.child(name)?.at()))
}

/// A channel says once more what its profile says.
fn channel(element: &Element<'_>, profile: Option<u32>) -> Channel {
    element.child_as("ProfileNo", |text| number(text).filter(|number| Some(*number) == profile));
    let add_info = element.child_as("AddInfo", number);
    Channel { at: element.at(), name: words::name(element, "DisplayName"), add_info }
}

/// The number of the profile, which may stand in its channel.
fn profile_number(profile: &Element<'_>) -> Option<u32> {
    profile
        .child_as("ProfileNo", number)
        .or_else(|| profile.child("ChannelInfo")?.child_as("ProfileNo", number))
}

fn mailbox(element: &Element<'_>) -> Mailbox {
    let acknowledged = element.attribute_as("DataLinkLayer", |text| truth(text).filter(|on| *on));
    let known = ["AoE", "CoE", "EoE", "FoE", "SoE", "VoE"];
    let protocols = element.children().iter().map(Element::name).filter(|name| known.contains(name));
    let protocols: Vec<String> = protocols.map(str::to_owned).collect();
    protocols.iter().for_each(|name| _ = element.child(name));
    let coe = element.child("CoE");
    coe.into_iter().for_each(|coe| coe.says_usual("SdoUploadWithMaxLength"));
    let others = [
        ("CoE", "PdoUpload", "pdo-upload"),
        ("AoE", "AdsRouter", "aoe-router"),
        ("AoE", "GenerateOwnNetId", "aoe-generates-net-id"),
        ("AoE", "InitializeOwnNetId", "aoe-initialize-net-id"),
        ("EoE", "IP", "eoe-ip"),
        ("EoE", "MAC", "eoe-mac"),
    ];
    let other = |(protocol, name, key)| Some((key, element.child(protocol)?.attribute_as(name, truth)?));
    let flag = |name| coe.and_then(|coe| coe.attribute_as(name, truth)).unwrap_or(false);
    let commands = coe.into_iter().flat_map(|coe| coe.all("InitCmd")).filter_map(init_cmd).collect();
    Mailbox {
        at: element.at(),
        protocols,
        acknowledged: acknowledged.is_some(),
        sdo_info: flag("SdoInfo"),
        pdo_assign: flag("PdoAssign"),
        pdo_config: flag("PdoConfig"),
        complete_access: flag("CompleteAccess"),
        segmented: flag("SegmentedSdo"),
        others: others.into_iter().filter_map(other).collect(),
        diagnosis: flag("DiagHistory"),
        commands,
    }
}

fn init_cmd(element: &Element<'_>) -> Option<InitCmd> {
    let index = element.child_as("Index", number)?;
    let subindex = element.child_as("SubIndex", number).unwrap_or(0);
    let data = element.child_as("Data", bytes)?;
    let transitions = element.all("Transition").map(|it| it.text().to_owned()).collect();
    Some(InitCmd {
        at: element.at(),
        transitions,
        index,
        subindex,
        data,
        complete_access: element.attribute_as("CompleteAccess", truth).unwrap_or(false),
        comment: words::name(element, "Comment"),
        facts: element.facts(),
    })
}

fn op_mode(element: &Element<'_>) -> OpMode {
    OpMode {
        at: element.at(),
        name: words::name(element, "Name").unwrap_or_default(),
        description: words::name(element, "Desc"),
        assign_activate: element.child_as("AssignActivate", number).unwrap_or(0),
        sync0: signal(element, "CycleTimeSync0", "ShiftTimeSync0"),
        sync1: signal(element, "CycleTimeSync1", "ShiftTimeSync1"),
        managers: mode_managers(element),
    }
}

/// What the sync managers do; a file may say it of one in several pieces.
fn mode_managers(mode: &Element<'_>) -> Vec<ModeManager> {
    let mut managers: Vec<ModeManager> = Vec::new();
    for manager in mode.all("Sm").filter_map(mode_manager) {
        match managers.iter_mut().find(|known| known.number == manager.number) {
            Some(known) => {
                known.pdos.extend(manager.pdos);
                known.sync_type = known.sync_type.or(manager.sync_type);
            }
            None => managers.push(manager),
        }
    }
    managers
}

fn mode_manager(element: &Element<'_>) -> Option<ModeManager> {
    let pdos = element.all("Pdo").filter_map(|pdo| {
        let factor = pdo.attribute_as("OSFac", number);
        Some((number(pdo.text())?, factor))
    });
    Some(ModeManager {
        at: element.at(),
        number: element.attribute_as("No", number)?,
        sync_type: element.child_as("SyncType", number),
        pdos: pdos.collect(),
    })
}

fn signal(mode: &Element<'_>, cycle: &str, shift: &str) -> Option<Signal> {
    let period = mode.child_as(cycle, number);
    let delay = mode.child_as(shift, number);
    let element = mode.children().iter().find(|child| [cycle, shift].contains(&child.name()))?;
    let factor = |name| mode.child(name).and_then(|it| it.attribute_as("Factor", number));
    let of_inputs = mode.child(shift).and_then(|it| it.attribute_as("Input", truth)).unwrap_or(false);
    Some(Signal {
        at: element.at(),
        cycle: period.unwrap_or(0),
        factor: factor(cycle),
        shift: delay.unwrap_or(0),
        shift_factor: factor(shift),
        of_inputs,
    })
}

/// Choices of PDOs, which the standard has no element for: those that TwinCAT offers.
fn alternatives(device: &Element<'_>) -> Vec<Alternative> {
    let named =
        |parent: &'_ Element<'_>, name: &str| parent.children().iter().position(|it| it.name() == name);
    let has = |info: &Element<'_>| {
        let own = named(info, "VendorSpecific").and_then(|place| info.children().get(place));
        let own = own.and_then(|own| own.children().get(named(own, "TwinCAT")?));
        own.is_some_and(|own| named(own, "AlternativeSmMapping").is_some())
    };
    let info = device.child("Info").filter(|info| has(info));
    let own = info.and_then(|info| info.child("VendorSpecific")).and_then(|own| own.child("TwinCAT"));
    own.into_iter().flat_map(|own| own.all("AlternativeSmMapping")).filter_map(alternative).collect()
}

fn alternative(element: &Element<'_>) -> Option<Alternative> {
    let manager = |sm: &Element<'_>| {
        let pdos = sm.all("Pdo").filter_map(|pdo| number(pdo.text())).collect();
        Some((sm.attribute_as("No", number)?, pdos))
    };
    // The one that the file calls the default is what is assigned without it.
    element.attribute("Default");
    Some(Alternative {
        at: element.at(),
        name: words::name(element, "Name")?,
        managers: element.all("Sm").filter_map(manager).collect(),
        facts: element.facts(),
    })
}

/// A picture as a description can have it.
fn picture(text: &str) -> Option<Vec<u8>> {
    bytes(text).filter(|bytes| bytes.starts_with(b"BM") && bytes.len() <= MOST_OF_PICTURE)
}

fn eeprom(element: &Element<'_>) -> Eeprom {
    element.says_usual("AssignToPdi");
    let config_data = element.child_as("ConfigData", bytes).unwrap_or_default();
    let bootstrap = element.child_as("BootStrap", bytes).unwrap_or_default();
    Eeprom { at: element.at(), size: element.child_as("ByteSize", number), config_data, bootstrap }
}
