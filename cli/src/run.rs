//! `devc run`

mod bus;
mod ending;
mod fault;
mod link;
mod screen;
mod store;
mod table;
mod told;

use std::fs::File;
use std::io::BufWriter;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use devc::source::Disk;
use devc_virtual::{Subdevice, Trace, Wire};

use self::bus::Bus;
use self::ending::Ending;
use self::fault::{Deed, Fault, time};
use self::store::Store;
use self::told::Told;
use super::outcome::{Failure, Outcome, reason};
use super::paths::descriptions;
use super::report::{Report, verdict};

/// Put devices on a network interface, as virtual drives that EtherCAT masters find, configure and move.
///
/// Each description is a device, or several if it is one of a family, in the order given: the first is next to the master.
/// They run until the command is ended, and say what masters do, above all what they do wrong.
#[derive(Debug, Args)]
pub(super) struct Run {
    /// Folders with a `device.toml`, or TOML files.
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,

    /// The network interface to which a master is connected; takes the right to open raw sockets, as root has it.
    #[arg(long, short, value_name = "NAME")]
    interface: String,

    /// Of families, only these members, separated by commas.
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    member: Vec<String>,

    /// Say once a second how regularly process data comes.
    #[arg(long)]
    cycle_report: bool,

    /// Provoke a fault, after a time: `X=0x7305@5s`, or `c887.X=0x7305@5s` where several devices have such an axis.
    #[arg(long, value_name = "AXIS=CODE@TIME")]
    fault: Vec<Fault>,

    /// Give a pulse to a touch probe, 1 or 2, after a time: `X=1@5s`, as with faults.
    #[arg(long, value_name = "AXIS=PROBE@TIME")]
    probe: Vec<Fault>,

    /// Keep in a file what masters store in the devices (0x1010), for the next run.
    #[arg(long, value_name = "FILE")]
    store: Option<PathBuf>,

    /// Write all frames into a file that Wireshark opens.
    #[arg(long, value_name = "FILE")]
    trace: Option<PathBuf>,

    /// End by itself after a time, such as `10s`.
    #[arg(long = "for", value_name = "TIME", value_parser = time)]
    duration: Option<Duration>,
}

impl Run {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let mut outcome = Outcome::Clean;
        let (mut known, mut names, mut subdevices) = (Vec::new(), Vec::new(), Vec::new());
        let store = self.store.as_deref().map(Store::open).transpose()?;
        for path in descriptions(&self.paths, report)? {
            let compilation = devc::compile(&Disk, &path);
            report.diagnostics(&compilation);
            outcome = outcome.max(verdict(&compilation, false));
            let Some(family) = &compilation.family else { continue };
            known.extend(family.members.iter().map(|device| device.id.clone()));
            let wanted = |id: &String| self.member.is_empty() || self.member.contains(id);
            for device in family.members.iter().filter(|device| wanted(&device.id)) {
                let stored =
                    store.as_ref().map(|store| store.of(names.len(), &device.id)).unwrap_or_default();
                names.push(device.id.clone());
                subdevices.push(Subdevice::with_stored(device, stored));
            }
        }
        if outcome != Outcome::Clean {
            return Ok(outcome);
        }
        if let Some(unknown) = self.member.iter().find(|member| !known.contains(member)) {
            let what = format!("no description has a member `{unknown}`; there are");
            let choices: Vec<String> = known.iter().map(|id| format!("  {id}")).collect();
            return Err(Failure::new(what).choices(&choices));
        }
        let told = Told::new(names, &subdevices, self.cycle_report, report.is_live());
        let faults = self.fault.iter().map(|fault| told.find(fault, Deed::Fault));
        let probes = self.probe.iter().map(|probe| told.find(probe, Deed::Pulse));
        let dues = faults.chain(probes).collect::<Result<_, _>>()?;
        let there = self.trace.as_ref().filter(|path| path.symlink_metadata().is_ok());
        if let Some(path) = there {
            return Err(Failure::new(format!("`{}` is there already", path.display()))
                .help("move it away, or name another file with `--trace`"));
        }
        let interface = link::open(&self.interface)?;
        let trace = self.trace.as_ref().map(|path| self.begin(path)).transpose()?;
        let ending = Ending::after(self.duration)
            .map_err(|error| Failure::new(format!("cannot wait for Ctrl-C: {}", reason(&error))))?;
        report.message(&told.greeting(&self.interface));
        link::remark(&self.interface).iter().for_each(|remark| report.message(remark));
        let mut bus = Bus::new(Wire::new(subdevices), interface, (trace, store), dues);
        bus.serve(&ending, told, report)?;
        Ok(outcome)
    }

    fn begin(&self, path: &PathBuf) -> Result<Trace<BufWriter<File>>, Failure> {
        let comment = format!("devc {}", env!("CARGO_PKG_VERSION"));
        let file = File::create_new(path).map(BufWriter::new);
        file.and_then(|file| Trace::begin(file, &self.interface, &comment))
            .map_err(|error| Failure::at("write", path, &error))
    }
}
