//! A controller with its firmware.

use std::time::Duration;

use devc_runtime::esm::{AlControl, AlState, AlStatus, AlStatusCode, Areas, Configured, Role};

use crate::cycles::Cycles;
use crate::esc::Controller;
use crate::event::{Event, faults};
use crate::frame::Datagram;
use crate::process::Process;
use crate::{Clocks, Firmware, mail};

/// A subdevice: the controller on the wire, and behind it the firmware.
///
/// The controller answers at once, while a frame passes. The firmware comes after that, by [`Subdevice::work`].
#[derive(Debug)]
pub struct Subdevice<F> {
    /// The firmware.
    pub firmware: F,
    controller: Controller,
    /// The sync managers of mail from the master and to it; beyond all where there is none.
    mailboxes: [usize; 2],
    process: Process,
    /// Where it is on the wire, among how many.
    place: (usize, usize),
    /// What AL status shows.
    status: (AlStatus, AlStatusCode),
    /// The sync managers of process data as the firmware has judged them.
    judged: Vec<Configured>,
    /// The last message out, for a master that did not see it; and the next one, while it is made.
    last_mail: Vec<u8>,
    draft: Vec<u8>,
    cycles: Cycles,
    /// The time that the firmware has not been told of yet.
    elapsed: Duration,
}

impl<F: Firmware> Subdevice<F> {
    /// A subdevice with this firmware and this image in its EEPROM (ETG.1000.6, subdevice information interface).
    pub fn new(mut firmware: F, eeprom: Vec<u8>) -> Self {
        let (areas, _) = firmware.expected();
        let mut controller = Controller::new(eeprom, end(areas));
        let status = firmware.status();
        controller.show_status(status.0, status.1);
        let (last_mail, draft) = (Vec::new(), Vec::new());
        let mailbox = |role| areas.of(role).next().map_or(usize::MAX, |(number, _)| number);
        Self {
            mailboxes: [Role::MailboxOut, Role::MailboxIn].map(mailbox),
            process: Process::new(areas),
            place: (0, 1),
            firmware,
            controller,
            status,
            judged: Vec::new(),
            last_mail,
            draft,
            cycles: Cycles::default(),
            elapsed: Duration::ZERO,
        }
    }

    /// Switched off and on again, with its firmware as it is then. What is in the EEPROM stays.
    pub fn restart(&mut self, firmware: F) {
        let (position, count) = self.place;
        *self = Self::new(firmware, self.controller.image());
        self.place(position, count);
    }

    /// The state that AL status shows; none if it shows none.
    pub fn state(&self) -> Option<AlState> {
        state_of(self.status.0)
    }

    /// The cycles of process data, since they were asked for last.
    pub const fn take_cycles(&mut self) -> Cycles {
        self.cycles.take()
    }

    /// The signals of the distributed clocks that a master has activated.
    pub fn clocks(&self) -> Clocks {
        self.controller.clocks()
    }

    /// Another level at the input of a latch, 0 or 1, at this moment.
    pub fn latch(&mut self, number: u16, is_high: bool) {
        self.controller.latch(number, is_high);
    }

    /// What has happened since this was asked for last.
    pub fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.controller.events)
    }

    pub(crate) fn place(&mut self, position: usize, count: usize) {
        self.place = (position, count);
        self.controller.place(position, count);
    }

    pub(crate) fn pass(&mut self, datagram: &mut Datagram<'_>) -> bool {
        self.controller.pass(datagram)
    }

    /// Time goes on for the controller: its clock, its watchdog, its EEPROM.
    pub fn elapse(&mut self, elapsed: Duration) {
        self.controller.elapse(u64::try_from(elapsed.as_nanos()).unwrap_or(u64::MAX));
        self.elapsed = self.elapsed.saturating_add(elapsed);
    }

    /// The firmware takes what has come, goes on by the time that has gone by, and gives what it has.
    pub fn work(&mut self) {
        let elapsed = std::mem::take(&mut self.elapsed);
        if let Some(control) = self.controller.al_control.take() {
            self.request(AlControl(control));
        }
        self.exchange_mail();
        if self.is_exchanging() && self.is_as_judged() {
            self.take_outputs();
        }
        self.watch_outputs();
        self.firmware.step(elapsed);
        self.controller.events.extend(self.firmware.take_events());
        self.follow(None);
        if self.is_exchanging() && self.is_as_judged() {
            self.process.give(&mut self.controller, &mut self.firmware);
        }
    }

    fn request(&mut self, control: AlControl) {
        let managers = self.controller.settings();
        self.firmware.clocked(self.controller.clocks());
        self.firmware.request(control, &managers);
        if !self.is_exchanging() {
            self.judged = self.process.settings(&self.controller);
        }
        self.follow(Some(control));
    }

    /// Shows the status of the firmware, and tells what has changed, by itself or as it was asked for.
    fn follow(&mut self, asked: Option<AlControl>) {
        let (before, (status, code)) = (self.status, self.firmware.status());
        self.status = (status, code);
        self.controller.show_status(status, code);
        let (old, state) = (state_of(before.0), state_of(status));
        let is_new = (status, code) != before;
        let event = match asked {
            Some(asked) if code != AlStatusCode::NONE && AlState::of(asked.number()) != state => {
                let faults = faults(code, self.firmware.expected(), &self.controller.settings());
                Some(Event::Refused { asked: AlState::of(asked.number()), code, faults })
            }
            None if is_new && code != AlStatusCode::NONE => Some(Event::Fell { state, code }),
            _ if old != state => Some(Event::Changed { state }),
            _ => None,
        };
        if old != state && !matches!(state, Some(AlState::SafeOperational | AlState::Operational)) {
            self.controller.stop();
            self.process.stop();
            self.cycles.stop();
        }
        if state == Some(AlState::Init) {
            self.last_mail.clear();
        }
        self.controller.events.extend(event);
    }

    /// Takes a message and answers it, if the answer has a place; else it waits. Without a message, says what is left to say.
    fn exchange_mail(&mut self) {
        let Controller { memory, managers, events, .. } = &mut self.controller;
        let Ok([out, into]) = managers.get_disjoint_mut(self.mailboxes) else { return };
        if into.take_repeat() && !self.last_mail.is_empty() {
            into.give(memory, &self.last_mail);
            return;
        }
        if !into.is_free() || self.status.0.0 & 0x0F == AlState::Init as u16 {
            return;
        }
        self.draft.resize(into.settings().length.into(), 0);
        let length = match out.take(memory) {
            Some(message) => self.firmware.mail(message, &mut self.draft),
            None => self.firmware.more_mail(&mut self.draft),
        };
        if length == 0 {
            return;
        }
        self.draft.truncate(length);
        events.extend(mail::complaint(&self.draft));
        into.give(memory, &self.draft);
        std::mem::swap(&mut self.last_mail, &mut self.draft);
    }

    /// Whether process data is exchanged: in Safe-Operational and Operational.
    fn is_exchanging(&self) -> bool {
        matches!(self.state(), Some(AlState::SafeOperational | AlState::Operational))
    }

    /// Whether process data is as long as the firmware expects. A master that changes a sync manager of process data has to
    /// leave Safe-Operational before.
    fn is_as_judged(&mut self) -> bool {
        let is_as_judged = self.judged == self.process.settings(&self.controller);
        if !is_as_judged {
            self.controller.events.push(Event::ManagersChanged);
        }
        is_as_judged
    }

    fn take_outputs(&mut self) {
        if let Some(image) = self.process.take(&mut self.controller) {
            self.firmware.outputs(image);
        }
        if let Some(at) = self.controller.outputs_at.take() {
            self.cycles.count(at);
        }
    }

    fn watch_outputs(&mut self) {
        if self.controller.watchdog.is_expired() && self.state() == Some(AlState::Operational) {
            let timeout = Duration::from_nanos(self.controller.watchdog.timeout_ns());
            self.controller.events.push(Event::WatchdogExpired { timeout });
            self.firmware.watchdog_expired();
        }
    }
}

/// The first address behind all sync managers at their longest: mail has one buffer, process data three.
fn end(areas: Areas) -> u32 {
    let managers = areas.managers.iter().map(|manager| {
        let buffers = if matches!(manager.role, Role::Outputs | Role::Inputs) { 3 } else { 1 };
        (manager.area, buffers)
    });
    let boot = areas.boot.into_iter().flatten().map(|area| (area, 1));
    let ends = managers
        .chain(boot)
        .map(|(area, buffers)| u32::from(area.address) + u32::from(area.length.1) * buffers);
    ends.max().unwrap_or(0)
}

fn state_of(status: AlStatus) -> Option<AlState> {
    AlState::of((status.0 & 0x0F) as u8)
}
