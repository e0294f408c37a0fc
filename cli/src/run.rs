//! `devc run`

mod bus;
mod fault;
mod told;

use std::fs::File;
use std::io::BufWriter;
use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use devc::source::Disk;
use devc_virtual::{Interface, Subdevice, Trace, Wire};

use self::bus::Bus;
use self::fault::{Fault, time};
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
        for path in descriptions(&self.paths, report)? {
            let compilation = devc::compile(&Disk, &path);
            report.diagnostics(&compilation);
            outcome = outcome.max(verdict(&compilation, false));
            let Some(family) = &compilation.family else { continue };
            known.extend(family.members.iter().map(|device| device.id.clone()));
            let wanted = |id: &String| self.member.is_empty() || self.member.contains(id);
            for device in family.members.iter().filter(|device| wanted(&device.id)) {
                names.push(device.id.clone());
                subdevices.push(Subdevice::of(device));
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
        let told = Told::new(names, &subdevices, self.cycle_report);
        let faults = self.fault.iter().map(|fault| told.find(fault)).collect::<Result<_, _>>()?;
        let there = self.trace.as_ref().filter(|path| path.symlink_metadata().is_ok());
        if let Some(path) = there {
            return Err(Failure::new(format!("`{}` is there already", path.display()))
                .help("move it away, or name another file with `--trace`"));
        }
        let interface = self.open()?;
        let trace = self.trace.as_ref().map(|path| self.begin(path)).transpose()?;
        report.message(&told.greeting(&self.interface));
        let mut bus = Bus::new(Wire::new(subdevices), interface, trace, faults);
        bus.serve(self.duration, told, report)?;
        Ok(outcome)
    }

    fn open(&self) -> Result<Interface, Failure> {
        Interface::open(&self.interface).map_err(|error| {
            let what = format!("cannot open the network interface `{}`: {}", self.interface, reason(&error));
            Failure::new(what).help(
                "run it as root, or give the right to the command: `sudo setcap cap_net_raw+ep` and its path; \
                 `ip link` lists the interfaces",
            )
        })
    }

    fn begin(&self, path: &PathBuf) -> Result<Trace<BufWriter<File>>, Failure> {
        let comment = format!("devc {}", env!("CARGO_PKG_VERSION"));
        let file = File::create_new(path).map(BufWriter::new);
        file.and_then(|file| Trace::begin(file, &self.interface, &comment))
            .map_err(|error| Failure::at("write", path, &error))
    }
}
