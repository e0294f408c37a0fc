//! The drive behind an EtherCAT subdevice controller.

use std::time::Duration;

use devc::model;
use devc_runtime::coe::{MailboxError, Protocol};
use devc_runtime::esm::{AlControl, AlState, AlStatus, AlStatusCode, Areas, Change, Configured};

use super::application::Application;
use super::effects::Effect;
use super::stored::Order;
use super::{Drive, MANAGERS, files};
use crate::{Clocks, Event, Firmware};

impl Firmware for Drive {
    fn request(&mut self, control: AlControl, managers: &[Configured]) {
        let lengths = self.lengths();
        let mut application = Application {
            has_outputs: self.outputs.is_some(),
            clocks: self.facts.clocks.judge(self.clocks),
            are_signals_missed: self.clocks.are_missed,
        };
        let change = self.states.request(control, managers, &lengths, &mut application);
        self.changed(change);
    }

    fn clocked(&mut self, clocks: Clocks) {
        self.clocks = clocks;
    }

    fn expected(&mut self) -> (Areas, Vec<usize>) {
        (self.facts.areas, self.lengths().to_vec())
    }

    fn status(&self) -> (AlStatus, AlStatusCode) {
        (self.states.status(), self.states.code())
    }

    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize {
        let protocol = message.get(5).map_or(Protocol::COE, |last| Protocol(last & 0x0F));
        match (self.states.communication(), self.states.state()) {
            (Some(state), _) if protocol == Protocol::COE && self.facts.speaks(model::Protocol::Coe) => {
                self.mailbox.answer(message, state, answer)
            }
            (None, state) if state != AlState::Bootstrap => 0,
            _ => self.refuse(protocol, message, answer),
        }
    }

    fn more_mail(&mut self, answer: &mut [u8]) -> usize {
        if self.states.communication().is_none() {
            return 0;
        }
        let length = self.mailbox.proceed(answer);
        if length > 0 {
            return length;
        }
        self.errors.next().map_or(0, |emergency| self.mailbox.emergency(&emergency, answer))
    }

    fn outputs(&mut self, image: &[u8]) {
        match self.states.state() {
            AlState::Operational => self.take(image),
            AlState::SafeOperational => self.outputs = Some(image.to_vec()),
            _ => {}
        }
    }

    fn inputs(&mut self, image: &mut [u8]) {
        // an image of another length is one that the state machine has not let pass
        let _ = self.mailbox.server.pack_inputs(image);
    }

    fn watchdog_expired(&mut self) {
        let change = self.states.watchdog_expired();
        self.changed(change);
    }

    fn step(&mut self, elapsed: Duration) {
        self.act();
        self.cycle(elapsed.as_secs_f64());
    }

    fn take_events(&mut self) -> Vec<Event> {
        std::mem::take(&mut self.events)
    }
}

impl Drive {
    /// Answers a message of a protocol that the drive does not serve; tells the length of the answer.
    fn refuse(&mut self, protocol: Protocol, message: &[u8], answer: &mut [u8]) -> usize {
        let Some(counter) = self.mailbox.accept(message) else { return 0 };
        let error = if protocol == Protocol::FOE && self.facts.speaks(model::Protocol::Foe) {
            let content = message.split_first_chunk().and_then(|([low, high], rest)| {
                rest.get(4..)?.get(..u16::from_le_bytes([*low, *high]).into())
            });
            match files::refuse(content.unwrap_or_default(), counter, answer) {
                Some(length) => return length,
                None => MailboxError::TOO_SHORT,
            }
        } else {
            MailboxError::UNSUPPORTED_PROTOCOL
        };
        error.encode(counter, answer).unwrap_or(0)
    }

    fn lengths(&mut self) -> [usize; MANAGERS] {
        self.mailbox.server.carried()
    }

    /// What a change of the EtherCAT state brings with it.
    fn changed(&mut self, change: Option<Change>) {
        let Some(Change { from, to }) = change else { return };
        if from == AlState::Init {
            self.mailbox.restart();
            self.errors.forget();
        }
        if from == AlState::Operational {
            self.lose_master();
        }
        if to == AlState::Operational {
            self.events.extend(self.facts.clocks.complaint(self.clocks));
        }
        match (to, self.outputs.take()) {
            (AlState::Operational, Some(image)) => self.take(&image),
            _ => self.outputs = None,
        }
    }

    /// Does what writes have set off.
    fn act(&mut self) {
        for effect in std::mem::take(&mut self.mailbox.server.hooks.waiting) {
            match effect {
                Effect::Triggered(address, trigger) => {
                    if trigger.clears_errors {
                        self.axes.iter_mut().for_each(|axis| axis.error = 0);
                        self.errors.clear();
                    }
                    self.events.push(Event::Triggered { address, action: trigger.action.clone() });
                }
                Effect::Ordered(order) => {
                    let values = &mut self.mailbox.server.values;
                    self.facts.parameters.carry_out(order, values, &mut self.stored);
                    let is_stored = matches!(order, Order::Store(_));
                    self.events.push(if is_stored { Event::Stored } else { Event::Restored });
                }
            }
        }
    }

    /// Outputs go to the dictionary as they are mapped at present; the axes find them there.
    fn take(&mut self, image: &[u8]) {
        // as above
        let _ = self.mailbox.server.unpack_outputs(image);
    }
}
