use crate::diagnostic::{Diagnostic, rule};
use crate::lint::images::{self, Image};
use crate::lint::{Report, lookup};
use crate::model::{Address, Configuration, Device, Index, Mode, Role};

rule! {
    /// In a cyclic mode, offsets are added to the set value: a velocity offset is the feed-forward of a position, a torque
    /// offset holds a load. If a mode uses one that neither the process data of its configuration carry nor a write sets, it
    /// stays what it was, most often 0, and what a master computes for it gets lost.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6040 = {}
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x607A = {}
    /// 0x60B1 = { pdo = "rx" }
    /// 0x6502 = {}
    ///
    /// [rx-pdos.0x1600]
    /// name = "Set values"
    /// entries = ["controlword", "target-position"]
    ///
    /// [modes.8]
    /// objects = ["target-position", "velocity-offset"]
    ///
    /// [configurations.position]
    /// name = "Cyclic position"
    /// mode = 8
    /// outputs = ["0x1600"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6040 = {}
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x607A = {}
    /// 0x60B1 = { pdo = "rx" }
    /// 0x6502 = {}
    ///
    /// [rx-pdos.0x1600]
    /// name = "Set values"
    /// entries = ["controlword", "target-position", "velocity-offset"]
    ///
    /// [modes.8]
    /// objects = ["target-position", "velocity-offset"]
    ///
    /// [configurations.position]
    /// name = "Cyclic position"
    /// mode = 8
    /// outputs = ["0x1600"]
    /// ```
    pub(super) static RULE = "unmapped-set-value", ProcessData, Warning,
        "a configuration brings no value that its mode adds to the set value";
}

/// What is added to a set value, by CiA 402: offsets of position, velocity and torque.
const OFFSETS: [Index; 3] = [Index(0x60B0), Index(0x60B1), Index(0x60B2)];

pub(super) fn check(device: &Device, report: &mut Report) {
    for image in images::images(device).filter(|image| image.role == Role::Outputs) {
        let Some(configuration) = image.configuration else { continue };
        let chosen = |mode: &&Mode| configuration.mode == Some(mode.code) && mode.cyclic;
        let Some(mode) = device.modes.iter().find(chosen) else { continue };
        let missing: Vec<Address> = missing(device, mode, configuration, &image).collect();
        if !missing.is_empty() {
            report.push(image.place(), told(configuration, mode, &image, &missing));
        }
    }
}

/// The offsets that a mode uses and nothing brings. An object that no PDO can carry is set by other means anyway.
fn missing<'d>(
    device: &'d Device,
    mode: &'d Mode,
    configuration: &'d Configuration,
    image: &'d Image<'d>,
) -> impl Iterator<Item = Address> + 'd {
    let is_mappable = |address: Address| {
        let entry = device.object(address.index).and_then(|object| object.entry(address.subindex));
        entry.is_some_and(|entry| entry.functional && entry.pdo.rx())
    };
    let offsets = mode.objects.iter().copied().filter(|address| OFFSETS.contains(&address.index));
    offsets.filter(move |address| is_mappable(*address)).filter(move |address| {
        let is_carried = image.mapped().any(|(_, _, mapped)| mapped.address == Some(*address));
        let is_written = configuration.startup.iter().any(|write| write.address == *address);
        !is_carried && !is_written
    })
}

fn told(configuration: &Configuration, mode: &Mode, image: &Image<'_>, missing: &[Address]) -> Diagnostic {
    let message = format!(
        "`{}` brings no {}, which mode {} adds to its set value",
        configuration.name,
        lookup::list(missing.iter().map(|address| address.index)),
        mode.code
    );
    let at = image.assigned().unwrap_or_else(|| configuration.origin.header());
    Diagnostic::new(&RULE, message, at, "not among these")
        .label(mode.origin.value("objects"), "used by the mode")
        .help("map it, write it before, or leave it out of what the mode uses")
}
