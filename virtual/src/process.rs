//! Process data between sync managers and the firmware: what several of a direction carry is one image, in the order of their
//! numbers.

use devc_runtime::esm::{Areas, Configured, Role};

use crate::Firmware;
use crate::esc::Controller;

/// The sync managers of process data, with what they have exchanged.
#[derive(Debug)]
pub(crate) struct Process {
    /// Those from the master, by number, each with what came last.
    outputs: Vec<(usize, Vec<u8>)>,
    /// Those to the master.
    inputs: Vec<usize>,
    received: Vec<u8>,
    sent: Vec<u8>,
}

impl Process {
    /// Nothing has been exchanged yet.
    pub(crate) fn new(areas: Areas) -> Self {
        let numbers = |role| areas.of(role).map(|(number, _)| number);
        let outputs = numbers(Role::Outputs).map(|number| (number, Vec::new())).collect();
        Self { outputs, inputs: numbers(Role::Inputs).collect(), received: Vec::new(), sent: Vec::new() }
    }

    /// The settings of them all.
    pub(crate) fn settings(&self, controller: &Controller) -> Vec<Configured> {
        let numbers = self.outputs.iter().map(|(number, _)| number).chain(&self.inputs);
        let all = controller.settings();
        numbers.map(|number| all.get(*number).copied().unwrap_or_default()).collect()
    }

    /// Process data is no longer exchanged.
    pub(crate) fn stop(&mut self) {
        self.outputs.iter_mut().for_each(|(_, last)| last.clear());
    }

    /// The outputs, if any of them are new and all have come once.
    pub(crate) fn take(&mut self, controller: &mut Controller) -> Option<&[u8]> {
        let Controller { memory, managers, .. } = controller;
        let (mut is_new, mut is_whole) = (false, true);
        self.received.clear();
        for (number, last) in &mut self.outputs {
            let Some(manager) = managers.get_mut(*number) else { continue };
            if let Some(data) = manager.take(memory) {
                last.clear();
                last.extend(data);
                is_new = true;
            }
            is_whole &= last.len() == length(manager.settings());
            self.received.extend(&*last);
        }
        (is_new && is_whole).then_some(&self.received)
    }

    /// Lets the firmware give inputs, if a sync manager is free to take some.
    pub(crate) fn give(&mut self, controller: &mut Controller, firmware: &mut impl Firmware) {
        let Controller { memory, managers, .. } = controller;
        let there = || self.inputs.iter().filter_map(|number| managers.get(*number));
        if !there().any(|manager| manager.is_free()) {
            return;
        }
        let bytes = there().map(|manager| length(manager.settings())).sum();
        self.sent.resize(bytes, 0);
        firmware.inputs(&mut self.sent);
        let mut rest = self.sent.as_slice();
        for number in &self.inputs {
            let Some(manager) = managers.get_mut(*number) else { continue };
            let Some((own, others)) = rest.split_at_checked(length(manager.settings())) else { return };
            rest = others;
            if manager.is_free() {
                manager.give(memory, own);
            }
        }
    }
}

/// What a sync manager carries; one that is off carries nothing.
fn length(settings: Configured) -> usize {
    if settings.is_on { settings.length.into() } else { 0 }
}
