//! What is said of devices while they run.

use std::time::Duration;

use devc_runtime::cia402::State;
use devc_virtual::drive::{AxisStatus, Drive};
use devc_virtual::{Cycles, Event, Subdevice};

use super::Fault;
use crate::outcome::Failure;

/// The devices by name, and what was said of them last.
pub(super) struct Told {
    names: Vec<String>,
    axes: Vec<Vec<Axis>>,
    reports_cycles: bool,
}

/// An axis, as it was told last.
struct Axis {
    name: String,
    told: (State, i8, u16),
}

impl Told {
    pub(super) fn new(names: Vec<String>, subdevices: &[Subdevice<Drive>], reports_cycles: bool) -> Self {
        let axes = subdevices.iter().map(|subdevice| {
            let axes = subdevice.firmware.axes().into_iter();
            axes.map(|axis| Axis { told: key(&axis), name: axis.name }).collect()
        });
        Self { axes: axes.collect(), names, reports_cycles }
    }

    pub(super) fn greeting(&self, interface: &str) -> String {
        format!("{} on {interface}, waiting for a master", self.names.join(", "))
    }

    /// The device and the axis of a fault, with the fault.
    pub(super) fn find(&self, fault: &Fault) -> Result<(usize, usize, Fault), Failure> {
        let mut found = Vec::new();
        let mut choices = Vec::new();
        for (position, (name, axes)) in self.names.iter().zip(&self.axes).enumerate() {
            for (number, axis) in axes.iter().enumerate() {
                let is_device = fault.device.as_ref().is_none_or(|device| device == name);
                if is_device && axis.name.eq_ignore_ascii_case(&fault.axis) {
                    found.push((position, number, fault.clone()));
                }
                choices.push(format!("  {name}.{}", axis.name));
            }
        }
        match found.len() {
            1 => found.pop().ok_or_else(|| Failure::new("no axis")),
            count => {
                let many = if count == 0 { "no axis has" } else { "several axes have" };
                let what = format!("{many} the name `{}` that a fault is for; there are", fault.axis);
                Err(Failure::new(what).choices(&choices))
            }
        }
    }

    /// An event as a line.
    pub(super) fn event(&self, at: Duration, position: Option<usize>, event: &Event) -> String {
        self.line(at, position, &event.to_string())
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
            let error = match status.error {
                0 => String::new(),
                code => format!(", error 0x{code:04X}"),
            };
            let (name, mode) = (axis_name(status), mode(status));
            let what = format!("{name}{}{mode}{error}, at {:.0}", status.state, status.position);
            lines.push(self.line(at, Some(position), &what));
        }
        lines
    }

    /// How regularly process data came, if that is wanted and any came.
    pub(super) fn cycles(
        &self,
        at: Duration,
        position: usize,
        cycles: &Cycles,
        sync0: Option<Duration>,
    ) -> Option<String> {
        let mean = cycles.mean().filter(|_| self.reports_cycles)?;
        let (number, shortest, longest) = (cycles.number(), cycles.shortest(), cycles.longest());
        let sync0 = sync0.map_or(String::new(), |cycle| format!("; SYNC0 every {cycle:?}"));
        let what = format!("{number} cycles of {mean:.1?}, from {shortest:.1?} to {longest:.1?}{sync0}");
        Some(self.line(at, Some(position), &what))
    }

    fn line(&self, at: Duration, position: Option<usize>, what: &str) -> String {
        let seconds = at.as_secs_f64();
        match position.and_then(|position| Some((position, self.names.get(position)?))) {
            Some((position, name)) => format!("{seconds:9.3} s  {position} {name}: {what}"),
            None => format!("{seconds:9.3} s  {what}"),
        }
    }
}

const fn key(status: &AxisStatus) -> (State, i8, u16) {
    (status.state, status.mode, status.error)
}

fn axis_name(status: &AxisStatus) -> String {
    if status.name.is_empty() { String::new() } else { format!("{}: ", status.name) }
}

fn mode(status: &AxisStatus) -> String {
    match (status.mode, status.mode_name.as_str()) {
        (0, "") => String::new(),
        (mode, "") => format!(", mode {mode}"),
        (_, name) => format!(", {name}"),
    }
}
