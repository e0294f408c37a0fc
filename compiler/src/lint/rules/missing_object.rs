use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Index, Place, Protocol, Section};
use crate::source::Location;

rule! {
    /// Some objects come with what a device can do: a CoE mailbox brings device type and identity, a drive after
    /// CiA 402 its controlword and statusword, modes of operation the objects that select and show them,
    /// distributed clocks the synchronisation parameters. Masters read and write them without asking.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    ///
    /// [objects.0x1000]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [mailbox]
    /// protocols = ["CoE"]
    ///
    /// [objects.0x1000]
    /// [objects.0x1018]
    /// ```
    pub(super) static RULE = "missing-object", Dictionary, Warning,
        "an object that comes with a feature is missing";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for need in needs(device) {
        let missing = need.objects.iter().filter(|index| device.object(Index(**index)).is_none());
        let missing: Vec<Index> = missing.map(|index| Index(*index)).collect();
        if !missing.is_empty() {
            let headers = missing.iter().map(|index| format!("`[objects.{index}]`"));
            let help = format!("add {}", lookup::list(headers));
            let missing = lookup::list(&missing);
            let message = format!("{} needs {missing}, which the dictionary does not have", need.who);
            let diagnostic = Diagnostic::new(&RULE, message, need.at, format!("needs {missing}"));
            report.push(need.subject, diagnostic.note(need.clause).help(help));
        }
    }
}

/// A feature with the objects that come with it.
struct Need {
    subject: Place,
    who: String,
    at: Location,
    objects: &'static [u16],
    clause: &'static str,
}

fn needs(device: &Device) -> impl Iterator<Item = Need> {
    let mailbox = device.mailbox.iter().filter(|mailbox| mailbox.protocols.contains(&Protocol::Coe));
    let mailbox = mailbox.map(|mailbox| Need {
        subject: Section::Mailbox.at("protocols"),
        who: "a CoE mailbox".to_owned(),
        at: mailbox.origin.value("protocols"),
        objects: &[0x1000, 0x1018],
        clause: "ETG.1000.6 demands device type and identity of every device with CoE",
    });
    let drive = (device.profile == Some(402)).then(|| Need {
        subject: Section::Device.at("profile"),
        who: "profile 402".to_owned(),
        at: device.origin.value("profile"),
        objects: &[0x6040, 0x6041],
        clause: "CiA 402 demands controlword and statusword of every drive",
    });
    let messages = device.diagnosis.first().map(|message| Need {
        subject: Section::Diagnosis.at(format_args!("0x{:04X}", message.text_id)),
        who: "a diagnosis message".to_owned(),
        at: message.origin.header(),
        objects: &[0x10F3],
        clause: "ETG.1020 keeps diagnosis messages in 0x10F3, which names them by their text ids",
    });
    let modes = device.modes.iter().find(|mode| mode.code != 0).map(|mode| Need {
        subject: Section::Modes.at(mode.code),
        who: format!("mode {}", mode.code),
        at: mode.origin.header(),
        objects: &[0x6060, 0x6061, 0x6502],
        clause: "CiA 402 selects a mode by 0x6060, shows it in 0x6061 and lists those there are in 0x6502",
    });
    let clocks = device.sync_modes.iter().find(|mode| mode.assign_activate != 0).map(|mode| Need {
        subject: Section::SyncModes.at(&mode.id),
        who: "synchronisation by distributed clocks".to_owned(),
        at: mode.origin.value("assign-activate"),
        objects: &[0x1C32, 0x1C33],
        clause: "ETG.1020 has the parameters of synchronisation in 0x1C32 and 0x1C33",
    });
    mailbox.chain(drive).chain(messages).chain(modes).chain(clocks).collect::<Vec<_>>().into_iter()
}
