//! A master in a few lines: a drive with its mailbox and process data, without a wire between.

use std::time::Duration;

use devc::model::{Address, Configuration, Device, Direction, Role, SyncManager};
use devc_runtime::coe::{Emergency, Envelope, Request, Response, Service};
use devc_runtime::esm::{AlControl, AlState, AlStatusCode, Configured};
use devc_runtime::{object, sdo::AbortCode};
use devc_virtual::Firmware;
use devc_virtual::drive::Drive;

use crate::shared::{Layout, model, number, on};
pub(crate) use crate::shared::{device, devices};

/// A drive, and what a master has of it.
pub(crate) struct Bench {
    pub(crate) drive: Drive,
    pub(crate) device: &'static Device,
    pub(crate) outputs: Layout,
    pub(crate) inputs: Layout,
    image: Vec<u8>,
    received: Vec<u8>,
    counter: u8,
}

pub(crate) const INIT: AlState = AlState::Init;
pub(crate) const PRE_OP: AlState = AlState::PreOperational;
pub(crate) const SAFE_OP: AlState = AlState::SafeOperational;
pub(crate) const OP: AlState = AlState::Operational;

impl Bench {
    /// In Init.
    pub(crate) fn new(device: &'static Device, chosen: Option<&Configuration>) -> Self {
        let outputs = Layout::new(device, Direction::Rx, chosen);
        let inputs = Layout::new(device, Direction::Tx, chosen);
        let (image, received) = (vec![0; outputs.bytes()], vec![0; inputs.bytes()]);
        let drive = Drive::new(model(device));
        Self { drive, device, outputs, inputs, image, received, counter: 0 }
    }

    /// In Operational, with the process data that the device starts with.
    pub(crate) fn operational(device: &'static Device) -> Self {
        let mut bench = Self::new(device, None);
        bench.start(None);
        bench
    }

    /// Up to Operational, with the writes of a configuration where they belong.
    pub(crate) fn start(&mut self, chosen: Option<&Configuration>) {
        for (transition, state) in [("IP", PRE_OP), ("PS", SAFE_OP), ("SO", OP)] {
            let writes = chosen.into_iter().flat_map(|it| &it.startup);
            for write in writes.filter(|write| write.transition == transition) {
                assert_eq!(
                    self.download(write.address, &write.data),
                    Ok(()),
                    "{}: {write:?}",
                    self.device.name
                );
            }
            if state == OP {
                self.cycle();
            }
            self.request(state).expect("nothing is wrong");
        }
        self.cycles(3);
    }

    /// The sync managers as the description has them, as long as what is mapped.
    pub(crate) fn managers(&self) -> [Configured; 4] {
        let of = |role, length: Option<usize>| {
            let manager: &SyncManager = self.device.sync_manager(role).expect("there is one");
            let length = length.map_or(manager.size, |length| length as u16);
            let is_on = length > 0;
            Configured { address: manager.address, length, control: manager.control, is_on }
        };
        [
            of(Role::MailboxOut, None),
            of(Role::MailboxIn, None),
            of(Role::Outputs, Some(self.outputs.bytes())),
            of(Role::Inputs, Some(self.inputs.bytes())),
        ]
    }

    /// Asks for a state; the code if it is refused.
    pub(crate) fn request(&mut self, state: AlState) -> Result<(), AlStatusCode> {
        let managers = self.managers();
        self.request_with(state, &managers)
    }

    pub(crate) fn request_with(
        &mut self,
        state: AlState,
        managers: &[Configured; 4],
    ) -> Result<(), AlStatusCode> {
        self.drive.request(AlControl::request(state, true), managers);
        let (status, code) = self.drive.status();
        if status.0 == state as u16 { Ok(()) } else { Err(code) }
    }

    fn exchange<T>(
        &mut self,
        request: Request<'_>,
        read: impl Fn(Response<'_>) -> T,
    ) -> Result<T, AbortCode> {
        self.counter = self.counter % 7 + 1;
        let (mut message, mut answer) = ([0; 128], [0; 128]);
        let envelope = Envelope { counter: self.counter, ..Envelope::new(Service::SDO_REQUEST) };
        let length = request.encode(envelope, &mut message).expect("it fits");
        let length = self.drive.mail(&message[..length], &mut answer);
        let (_, body) = Envelope::open(&answer[..length]).expect("there is an answer");
        match Response::decode(body).expect("it is one") {
            Response::Abort { code, .. } => Err(code),
            response => Ok(read(response)),
        }
    }

    pub(crate) fn download(&mut self, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        let (address, size) = (object::Address::new(address.index.0, address.subindex), data.len() as u32);
        self.exchange(Request::Download { address, is_complete: false, size: Some(size), data }, |_| ())
    }

    pub(crate) fn upload(&mut self, address: Address) -> Result<Vec<u8>, AbortCode> {
        let address = object::Address::new(address.index.0, address.subindex);
        self.exchange(Request::Upload { address, is_complete: false }, |response| match response {
            Response::Uploaded { data, .. } => data.to_vec(),
            other => panic!("{other:?}"),
        })
    }

    /// What the drive says unasked.
    pub(crate) fn emergencies(&mut self) -> Vec<(u16, u8)> {
        let (mut said, mut answer) = (Vec::new(), [0; 128]);
        loop {
            let length = self.drive.more_mail(&mut answer);
            if length == 0 {
                return said;
            }
            let (envelope, body) = Envelope::open(&answer[..length]).expect("it is a message");
            assert_eq!(envelope.service, Service::EMERGENCY);
            let emergency = Emergency::decode(body).expect("it is an emergency");
            said.push((emergency.code, emergency.register));
        }
    }

    /// An address on an axis by that on the first.
    pub(crate) fn on(&self, axis: usize, index: u16, subindex: u8) -> Address {
        on(self.device, axis, index, subindex)
    }

    /// Whether an axis has an entry.
    pub(crate) fn has(&self, axis: usize, index: u16, subindex: u8) -> bool {
        self.device.entry(self.on(axis, index, subindex)).is_some()
    }

    /// Sends a value: in process data if it is mapped, else by the mailbox.
    pub(crate) fn set(&mut self, address: Address, value: i64) {
        if !self.outputs.write(&mut self.image, address, value) {
            let entry = self.device.entry(address).expect("it is in the dictionary");
            let length = entry.data_type.bytes() as usize;
            let written = self.download(address, &value.to_le_bytes()[..length]);
            assert_eq!(written, Ok(()), "{address} of {}", self.device.name);
        }
    }

    /// Receives a value: from process data if it is mapped, else by the mailbox.
    pub(crate) fn get(&mut self, address: Address) -> i64 {
        let entry = self.device.entry(address).expect("it is in the dictionary");
        let is_signed = matches!(entry.data_type, devc::model::DataType::Int(_));
        let bits = self.inputs.read(&self.received, address).unwrap_or_else(|| {
            let bytes = self.upload(address).expect("it can be read");
            (0..bytes.len() * 8).map(|bit| bytes[bit / 8] >> (bit % 8) & 1 == 1).collect()
        });
        number(&bits, is_signed)
    }

    /// A millisecond: outputs, what the drive does, inputs.
    pub(crate) fn cycle(&mut self) {
        self.drive.outputs(&self.image);
        self.drive.step(Duration::from_millis(1));
        self.drive.inputs(&mut self.received);
    }

    pub(crate) fn cycles(&mut self, count: usize) {
        for _ in 0..count {
            self.cycle();
        }
    }

    pub(crate) fn axes(&self) -> std::ops::Range<usize> {
        0..self.device.axes.len()
    }

    /// The statusword of an axis.
    pub(crate) fn statusword(&mut self, axis: usize) -> u16 {
        self.get(self.on(axis, 0x6041, 0)) as u16
    }

    /// Gives all axes a controlword for a few cycles.
    pub(crate) fn command(&mut self, word: u16) {
        for axis in self.axes() {
            self.set(self.on(axis, 0x6040, 0), word.into());
        }
        self.cycles(3);
    }

    /// Whether an axis shows a state, by the pattern that the description has for it.
    pub(crate) fn shows(&mut self, axis: usize, state: &str) -> bool {
        let word = self.statusword(axis);
        let state = self.device.states.iter().find(|it| it.id == state).expect("it has the state");
        let pattern = state.pattern.as_ref().expect("it is shown");
        word & pattern.mask() == pattern.value()
    }

    pub(crate) fn all_show(&mut self, state: &str) {
        for axis in self.axes() {
            let word = self.statusword(axis);
            assert!(self.shows(axis, state), "{}, axis {axis}: {word:#06X} is not {state}", self.device.name);
        }
    }

    /// Through the states to Operation enabled.
    pub(crate) fn enable(&mut self) {
        for (word, state) in
            [(0x06, "ready-to-switch-on"), (0x07, "switched-on"), (0x0F, "operation-enabled")]
        {
            self.command(word);
            self.all_show(state);
        }
    }

    /// Selects a mode on all axes that have the object.
    pub(crate) fn select(&mut self, mode: i16) {
        for axis in self.axes() {
            self.set(self.on(axis, 0x6060, 0), mode.into());
        }
        self.cycles(4);
        for axis in self.axes() {
            let display = self.get(self.on(axis, 0x6061, 0));
            assert_eq!(display, i64::from(mode), "{}, axis {axis}", self.device.name);
        }
    }
}
