//! What is tested: every description that devc ships, and some that have what those have not.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use devc::Compilation;
use devc::emit::Emitter;
use devc::emit::esi::Esi as Writer;
use devc::lint::Checked;
use devc::model::{Device, Family};
use devc::source::{Disk, Loader, Memory};
use devc_tests::esi_reader::{self, Esi};

/// A description with a corner of every kind.
const CORNERS: &str = include_str!("corners.toml");

/// Devices that have not the usual four sync managers.
const WIRED: [(&str, &str); 4] = [
    ("without_outputs", include_str!("wired/without_outputs.toml")),
    ("without_inputs", include_str!("wired/without_inputs.toml")),
    ("without_mailbox", include_str!("wired/without_mailbox.toml")),
    ("five_managers", include_str!("wired/five_managers.toml")),
];

/// A family with the file that was written for it.
pub(crate) struct Subject {
    pub(crate) family: Checked<Family>,
    pub(crate) xml: String,
    pub(crate) esi: Esi,
}

impl Subject {
    /// Each device of the model with what the file says of it.
    pub(crate) fn devices(&self) -> impl Iterator<Item = (&Device, &esi_reader::Device)> {
        assert_eq!(self.family.members.len(), self.esi.devices.len(), "devices of {}", self.family.id);
        self.family.members.iter().zip(&self.esi.devices)
    }
}

/// All of them, compiled once.
static SUBJECTS: LazyLock<Vec<Subject>> = LazyLock::new(|| {
    let public = Path::new(env!("CARGO_MANIFEST_DIR")).join("devices/sv660n");
    let folders = shipped().into_iter().chain([public]);
    let mut subjects: Vec<_> = folders.map(|folder| subject(&Disk, &folder)).collect();
    for (id, text) in [("corners", CORNERS)].into_iter().chain(WIRED) {
        let folder = Path::new("/").join(id);
        subjects.push(subject(&Memory::new().with(folder.join("device.toml"), text), &folder));
    }
    subjects
});

/// All of them.
pub(crate) fn subjects() -> &'static [Subject] {
    &SUBJECTS
}

/// Whether a name in a file is that of the model, with the axis behind it where there are several.
pub(crate) fn is_named(model: &Device, read: &str, name: &str, axis: Option<u8>) -> bool {
    match axis.and_then(|axis| model.axes.get(usize::from(axis))).filter(|_| model.axes.len() > 1) {
        Some(axis) => read == format!("{name} ({})", axis.name) || read == name && name.contains(&axis.name),
        None => read == name,
    }
}

/// The one of this id.
pub(crate) fn named(id: &str) -> &'static Subject {
    subjects().iter().find(|subject| subject.family.id == id).unwrap()
}

/// The one with the corners.
pub(crate) fn corners() -> &'static Subject {
    named("corners")
}

/// What comes of a description.
pub(crate) fn compiled(text: &str) -> Compilation {
    devc::compile(&Memory::new().with("/described/device.toml", text), Path::new("/described"))
}

/// The file that is written for a family.
pub(crate) fn xml(family: &Checked<Family>) -> String {
    let files = Writer.emit(family, &devc::emit::Options::default());
    files.text(".xml").expect("an ESI").to_owned()
}

fn subject(loader: &dyn Loader, folder: &Path) -> Subject {
    let compilation = devc::compile(loader, folder);
    let messages: Vec<_> = compilation.diagnostics.iter().map(|it| it.message.as_str()).collect();
    let family = compilation.family.unwrap_or_else(|| panic!("{}: {messages:#?}", folder.display()));
    let xml = xml(&family);
    let esi = esi_reader::read(&xml).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    Subject { family, xml, esi }
}

fn shipped() -> Vec<PathBuf> {
    let devices = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let folders = std::fs::read_dir(&devices).unwrap().map(|entry| entry.unwrap().path());
    let mut described: Vec<_> = folders.filter(|folder| folder.join("device.toml").is_file()).collect();
    described.sort();
    assert!(!described.is_empty(), "no descriptions in {}", devices.display());
    described
}
