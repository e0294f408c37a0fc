//! The drive behind an EtherCAT subdevice controller.

use std::time::Duration;

use devc_runtime::esm::{AlControl, AlState, AlStatus, AlStatusCode, Areas, Change, Configured, Lengths};
use devc_runtime::pdo::{Rx, Tx};

use super::Drive;
use super::application::Application;
use crate::Firmware;

impl Firmware for Drive {
    fn request(&mut self, control: AlControl, managers: &[Configured; 4]) {
        let lengths = self.lengths();
        let mut application = Application { has_outputs: self.outputs.is_some() };
        let change = self.states.request(control, managers, lengths, &mut application);
        self.changed(change);
    }

    fn expected(&mut self) -> (Areas, Lengths) {
        (self.facts.areas, self.lengths())
    }

    fn status(&self) -> (AlStatus, AlStatusCode) {
        (self.states.status(), self.states.code())
    }

    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize {
        match self.states.communication() {
            Some(state) => self.mailbox.answer(message, state, answer),
            None => 0,
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
        self.cycle(elapsed.as_secs_f64());
    }
}

impl Drive {
    fn lengths(&mut self) -> Lengths {
        let server = &mut self.mailbox.server;
        Lengths { outputs: server.image_len::<Rx>(), inputs: server.image_len::<Tx>() }
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
        match (to, self.outputs.take()) {
            (AlState::Operational, Some(image)) => self.take(&image),
            _ => self.outputs = None,
        }
    }

    /// Outputs go to the dictionary as they are mapped at present; the axes find them there.
    fn take(&mut self, image: &[u8]) {
        // as above
        let _ = self.mailbox.server.unpack_outputs(image);
    }
}
