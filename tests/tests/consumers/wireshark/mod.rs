//! The dissectors, in Wireshark: what it finds in captures is what the JSON model says.

mod capture;
mod images;
mod mail;

use std::collections::BTreeMap;
use std::path::Path;

use devc::emit::wireshark::Wireshark;
use devc::emit::{Emitter, Options};
use serde_json::Value as Json;

use crate::model::{Subject, list, name, number, text};
use crate::tools::{run, tool};
use capture::{Capture, Mailbox};

/// Wireshark with the dissector of a member.
struct Reader {
    tool: &'static str,
    folder: tempfile::TempDir,
    /// What its filters begin with.
    prefix: String,
}

/// The values of a field in a frame, in order.
type Values = Vec<String>;

impl Reader {
    /// None where there is no Wireshark.
    fn of(subject: &Subject, member: &Json) -> Option<Self> {
        let tool = tool(&["tshark"])?;
        let id = text(member, "id");
        let folder = tempfile::tempdir().unwrap();
        let files = Wireshark.emit(&subject.family, &Options::default());
        std::fs::write(folder.path().join("device.lua"), &files.0[&format!("{id}.lua")]).unwrap();
        let own = if subject.id == id { id.to_owned() } else { format!("{}_{id}", subject.id) };
        Some(Self { tool, folder, prefix: format!("devc_{}", own.replace('-', "_")) })
    }

    /// For each frame that the dissector has something to say of, the values of fields.
    fn read(&self, capture: &Capture, options: &[&str], fields: &[String]) -> BTreeMap<usize, Vec<Values>> {
        std::fs::write(self.folder.path().join("capture"), capture.bytes()).unwrap();
        dissected(self.tool, self.folder.path(), &self.prefix, options, fields)
    }
}

/// What Wireshark makes of the file `capture` with the script `device.lua`.
fn dissected(
    tool: &str,
    folder: &Path,
    prefix: &str,
    options: &[&str],
    fields: &[String],
) -> BTreeMap<usize, Vec<Values>> {
    let fields: Vec<String> = fields.iter().map(|field| format!("{prefix}.{field}")).collect();
    let mut arguments = vec!["-r", "capture", "-X", "lua_script:device.lua", "-Y", prefix, "-T", "fields"];
    arguments.extend(["-E", "separator=/t", "-E", "aggregator=|", "-e", "frame.number"]);
    arguments.extend(fields.iter().flat_map(|field| ["-e", field]));
    let options: Vec<String> = options.iter().map(|option| format!("{prefix}.{option}")).collect();
    arguments.extend(options.iter().flat_map(|option| ["-o", option]));
    let output = run(folder, tool, &arguments);
    let text = String::from_utf8(output.stdout).unwrap();
    let frames = text.lines().map(|line| {
        let mut columns = line.split('\t');
        let frame = columns.next().unwrap().parse().unwrap();
        let values = |column: &str| match column {
            "" => Vec::new(),
            column => column.split('|').map(str::to_owned).collect(),
        };
        (frame, columns.map(values).collect::<Vec<Values>>())
    });
    frames.collect()
}

/// The filter of an entry, behind that of the device: axis where there are several, object, entry where there are several.
fn filter(member: &Json, (index, subindex): (usize, usize), mapped: &str) -> String {
    let part = |id: &str| {
        let name = name(id, &[]);
        if name.starts_with(|c: char| c.is_ascii_digit()) { format!("n{name}") } else { name }
    };
    let object = list(member, "objects").iter().find(|object| number(object, "index") == index);
    let Some(object) = object else { return part(mapped) };
    let entries = list(object, "entries");
    let entry = entries.iter().find(|entry| number(&entry["address"], "subindex") == subindex).unwrap();
    let axes = list(member, "axes");
    let axis = object["axis"].as_u64().filter(|_| axes.len() > 1);
    let axis = axis.map(|axis| part(text(&axes[usize::try_from(axis).unwrap()], "name")) + ".");
    let own = if entries.len() > 1 { format!(".{}", part(text(entry, "id"))) } else { String::new() };
    format!("{}{}{own}", axis.unwrap_or_default(), part(text(object, "id")))
}

/// Where a member has its mail.
fn mailbox(member: &Json) -> Mailbox {
    let of = |role: &str| {
        let managers = list(member, "sync_managers");
        let manager = managers.iter().find(|it| text(it, "role") == role).unwrap();
        u16::try_from(number(manager, "address")).unwrap()
    };
    Mailbox { out: of("mailbox_out"), back: of("mailbox_in") }
}
