//! What is said of devices while they run.

use std::time::Duration;

use devc_runtime::cia402::State;
use devc_virtual::drive::{AxisStatus, Drive};
use devc_virtual::{Clocks, Cycles, Event, Subdevice, state_name};

use super::fault::{Deed, Due, Fault};
use super::table::{Shown, mode, position_of};
use crate::outcome::Failure;

/// The devices by name, and what was said of them last.
pub(super) struct Told {
    names: Vec<String>,
    axes: Vec<Vec<Axis>>,
    reports_cycles: bool,
    /// What was said last of the cycles of each, where a table shows it.
    cycles: Vec<Option<String>>,
    /// Whether a table shows what the axes do.
    has_table: bool,
}

/// An axis, as it was told last.
struct Axis {
    name: String,
    told: (State, i8, u16),
}

impl Told {
    pub(super) fn new(
        names: Vec<String>,
        subdevices: &[Subdevice<Drive>],
        reports_cycles: bool,
        has_table: bool,
    ) -> Self {
        let axes = subdevices.iter().map(|subdevice| {
            let axes = subdevice.firmware.axes().into_iter();
            axes.map(|axis| Axis { told: key(&axis), name: axis.name }).collect()
        });
        let cycles = vec![None; names.len()];
        Self { axes: axes.collect(), names, reports_cycles, cycles, has_table }
    }

    pub(super) fn greeting(&self, interface: &str) -> String {
        format!("{} on {interface}, waiting for a master", self.names.join(", "))
    }

    /// The device and the axis that something is to happen to.
    pub(super) fn find(&self, fault: &Fault, deed: Deed) -> Result<Due, Failure> {
        if deed == Deed::Pulse && !(1..=2).contains(&fault.code) {
            return Err(Failure::new(format!(
                "an axis has the touch probes 1 and 2, and not {}",
                fault.code
            )));
        }
        let Fault { code, after, .. } = *fault;
        let mut found = Vec::new();
        let mut choices = Vec::new();
        for (position, (name, axes)) in self.names.iter().zip(&self.axes).enumerate() {
            for (number, axis) in axes.iter().enumerate() {
                let is_device = fault.device.as_ref().is_none_or(|device| device == name);
                if is_device && axis.name.eq_ignore_ascii_case(&fault.axis) {
                    found.push(Due { position, axis: number, deed, code, after });
                }
                choices.push(format!("  {name}.{}", axis.name));
            }
        }
        match found.len() {
            1 => found.pop().ok_or_else(|| Failure::new("no axis")),
            count => {
                let many = if count == 0 { "no axis has" } else { "several axes have" };
                let what = format!("{many} the name `{}` that is asked for; there are", fault.axis);
                Err(Failure::new(what).choices(&choices))
            }
        }
    }

    /// An event as a line.
    pub(super) fn event(&self, at: Duration, position: Option<usize>, event: &Event) -> String {
        self.line(at, position, &event.to_string())
    }

    /// The name of a device.
    pub(super) fn name(&self, position: usize) -> &str {
        self.names.get(position).map_or("", String::as_str)
    }

    /// What has changed on the axes of a device.
    pub(super) fn axes(&mut self, at: Duration, position: usize, status: &[AxisStatus]) -> Vec<String> {
        let mut lines = Vec::new();
        for (number, status) in status.iter().enumerate() {
            let Some(axis) = self.axes.get_mut(position).and_then(|axes| axes.get_mut(number)) else { break };
            if axis.told == key(status) {
                continue;
            }
            axis.told = key(status);
            if self.has_table && status.error == 0 {
                continue;
            }
            let error = match status.error {
                0 => String::new(),
                code => format!(", error 0x{code:04X}"),
            };
            let mode = Some(mode(status)).filter(|mode| !mode.is_empty());
            let mode = mode.map_or(String::new(), |mode| format!(", {mode}"));
            let what =
                format!("{}{}{mode}{error}, at {}", axis_name(status), status.state, position_of(status));
            lines.push(self.line(at, Some(position), &what));
        }
        lines
    }

    /// How regularly process data came, if that is wanted and any came: a line, if there is no table for it.
    pub(super) fn cycles(
        &mut self,
        at: Duration,
        position: usize,
        cycles: &Cycles,
        clocks: Clocks,
    ) -> Option<String> {
        if !self.reports_cycles {
            return None;
        }
        let what = cycles.mean().map(|mean| {
            let (number, shortest, longest) = (cycles.number(), cycles.shortest(), cycles.longest());
            let signals = signals(clocks);
            format!("{number} cycles of {mean:.1?}, from {shortest:.1?} to {longest:.1?}{signals}")
        });
        if self.has_table {
            *self.cycles.get_mut(position)? = what;
            return None;
        }
        Some(self.line(at, Some(position), &what?))
    }

    /// The devices as a table shows them.
    pub(super) fn shown<'s>(&'s self, subdevices: &[Subdevice<Drive>]) -> Vec<Shown<'s>> {
        let told = self.names.iter().zip(&self.cycles).zip(subdevices);
        let shown = told.map(|((name, cycles), subdevice)| Shown {
            name,
            state: state_name(subdevice.state()),
            axes: subdevice.firmware.axes(),
            cycles: cycles.as_deref(),
        });
        shown.collect()
    }

    fn line(&self, at: Duration, position: Option<usize>, what: &str) -> String {
        let seconds = at.as_secs_f64();
        match position.and_then(|position| Some((position, self.names.get(position)?))) {
            Some((position, name)) => format!("{seconds:9.3} s  {position} {name}: {what}"),
            None => format!("{seconds:9.3} s  {what}"),
        }
    }
}

/// How often the signals of the clocks come.
fn signals(clocks: Clocks) -> String {
    let signals = [("SYNC0", clocks.sync0), ("SYNC1", clocks.sync1)];
    let signals = signals.into_iter().filter_map(|(name, cycle)| Some((name, cycle?)));
    let told = signals.map(|(name, cycle)| match cycle {
        _ if clocks.are_missed => format!("; {name} never comes"),
        Duration::ZERO => format!("; {name} once"),
        cycle => format!("; {name} every {cycle:?}"),
    });
    told.collect()
}

const fn key(status: &AxisStatus) -> (State, i8, u16) {
    (status.state, status.mode, status.error)
}

fn axis_name(status: &AxisStatus) -> String {
    if status.name.is_empty() { String::new() } else { format!("{}: ", status.name) }
}
