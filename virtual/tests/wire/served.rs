//! A firmware of generated code, as a vendor would write it: the dictionary behind a mailbox, and the state machine.

use std::time::Duration;

use devc_runtime::coe::Mailbox;
use devc_runtime::esm::{
    AlControl, AlState, AlStatus, AlStatusCode, Application, Areas, Change, Configured, StateMachine,
};
use devc_runtime::sdo::{Names, Server, Values};
use devc_virtual::Firmware;

pub(crate) struct Served<V> {
    mailbox: Mailbox<V, (), 512>,
    machine: StateMachine,
    areas: Areas,
    application: Outputs,
}

/// What the firmware has to say to changes of the state: outputs begin with Safe-Operational.
#[derive(Default)]
struct Outputs {
    have_come: bool,
}

impl Application for Outputs {
    fn before(&mut self, change: Change) -> Result<(), AlStatusCode> {
        self.have_come &= change.to != AlState::SafeOperational;
        Ok(())
    }

    fn has_outputs(&self) -> bool {
        self.have_come
    }
}

impl<V: Values> Served<V> {
    pub(crate) fn new(values: V, names: Option<&'static Names>, areas: Areas) -> Self {
        let server = Server::new(values, ());
        let mailbox = match names {
            Some(names) => Mailbox::with_information(server, names),
            None => Mailbox::new(server),
        };
        Self { mailbox, machine: StateMachine::new(areas), areas, application: Outputs::default() }
    }

    fn lengths(&mut self) -> [usize; 4] {
        self.mailbox.server.carried()
    }
}

impl<V: Values> Firmware for Served<V> {
    fn request(&mut self, control: AlControl, managers: &[Configured]) {
        let lengths = self.lengths();
        let change = self.machine.request(control, managers, &lengths, &mut self.application);
        if change.is_some_and(|change| change.from == AlState::Init) {
            self.mailbox.restart();
        }
    }

    fn expected(&mut self) -> (Areas, Vec<usize>) {
        (self.areas, self.lengths().to_vec())
    }

    fn status(&self) -> (AlStatus, AlStatusCode) {
        (self.machine.status(), self.machine.code())
    }

    fn mail(&mut self, message: &[u8], answer: &mut [u8]) -> usize {
        let Some(state) = self.machine.communication() else { return 0 };
        self.mailbox.answer(message, state, answer)
    }

    fn more_mail(&mut self, answer: &mut [u8]) -> usize {
        self.mailbox.proceed(answer)
    }

    fn outputs(&mut self, image: &[u8]) {
        self.application.have_come = true;
        self.mailbox.server.unpack_outputs(image).expect("the length was judged");
    }

    fn inputs(&mut self, image: &mut [u8]) {
        self.mailbox.server.pack_inputs(image).expect("the length was judged");
    }

    fn watchdog_expired(&mut self) {
        self.machine.watchdog_expired();
    }

    fn step(&mut self, _elapsed: Duration) {}
}
