//! A drive in Operational, cycle by cycle.

use devc::model::{Address, Configuration, DataType, Device, Direction};
use ethercrab::subdevice_group::Op;

use crate::bus::{Bytes, Group, Master, operational};
use crate::shared::{Layout, number, on};

pub(crate) struct Session<'m> {
    pub(crate) device: &'static Device,
    master: &'m Master,
    group: Group<Op>,
    outputs: Layout,
    inputs: Layout,
    image: Vec<u8>,
    received: Vec<u8>,
}

impl<'m> Session<'m> {
    pub(crate) async fn begin(
        master: &'m Master,
        device: &'static Device,
        chosen: Option<&Configuration>,
    ) -> Self {
        let group = operational(master, chosen).await;
        let outputs = Layout::new(device, Direction::Rx, chosen);
        let inputs = Layout::new(device, Direction::Tx, chosen);
        let (image, received) = (vec![0; outputs.bytes()], vec![0; inputs.bytes()]);
        Self { device, master, group, outputs, inputs, image, received }
    }

    pub(crate) fn axes(&self) -> std::ops::Range<usize> {
        0..self.device.axes.len()
    }

    /// Whether an entry of an axis is in the process data that the master sends.
    pub(crate) fn sends(&self, axis: usize, index: u16) -> bool {
        self.outputs.place(on(self.device, axis, index, 0)).is_some()
    }

    pub(crate) async fn cycles(&mut self, count: usize) {
        for _ in 0..count {
            let response = self.group.tx_rx(self.master).await.expect("a cycle");
            // it reads and writes: 1 + 2
            assert_eq!(response.working_counter, 3, "{}", self.device.name);
            let drive = self.group.subdevice(self.master, 0).expect("the first");
            let mut io = drive.io_raw_mut();
            self.received.copy_from_slice(io.inputs());
            io.outputs().copy_from_slice(&self.image);
        }
    }

    /// Sends a value: in process data if it is mapped, else by the mailbox.
    pub(crate) async fn set(&mut self, axis: usize, index: u16, value: i64) {
        let address = on(self.device, axis, index, 0);
        if !self.outputs.write(&mut self.image, address, value) {
            let length = self.entry(address).bytes() as usize;
            let drive = self.group.subdevice(self.master, 0).expect("the first");
            let data = &value.to_le_bytes()[..length];
            let written = drive.sdo_write(address.index.0, address.subindex, data).await;
            written.unwrap_or_else(|error| panic!("{address} of {}: {error:?}", self.device.name));
        }
    }

    /// Receives a value in the same way.
    pub(crate) async fn get(&mut self, axis: usize, index: u16) -> i64 {
        let address = on(self.device, axis, index, 0);
        let is_signed = matches!(self.entry(address), DataType::Int(_));
        if let Some(bits) = self.inputs.read(&self.received, address) {
            return number(&bits, is_signed);
        }
        let bytes = self.upload(address).await.unwrap_or_else(|error| panic!("{address}: {error:?}"));
        let bits: Vec<bool> = (0..bytes.len() * 8).map(|bit| bytes[bit / 8] >> (bit % 8) & 1 == 1).collect();
        number(&bits, is_signed)
    }

    pub(crate) async fn upload(&mut self, address: Address) -> Result<Vec<u8>, ethercrab::error::Error> {
        let drive = self.group.subdevice(self.master, 0).expect("the first");
        drive.sdo_read::<Bytes>(address.index.0, address.subindex).await.map(|Bytes(bytes)| bytes)
    }

    fn entry(&self, address: Address) -> DataType {
        self.device.entry(address).expect("it is in the dictionary").data_type
    }

    /// Gives all axes a controlword.
    pub(crate) async fn command(&mut self, word: i64) {
        for axis in self.axes() {
            self.set(axis, 0x6040, word).await;
        }
        self.cycles(4).await;
    }

    pub(crate) async fn all_show(&mut self, id: &str) {
        for axis in self.axes() {
            self.shows(axis, id).await;
        }
    }

    /// That an axis shows a state, by the pattern that the description has for it.
    pub(crate) async fn shows(&mut self, axis: usize, id: &str) {
        let state = self.device.states.iter().find(|it| it.id == id).expect("it has the state");
        let pattern = state.pattern.as_ref().expect("it is shown");
        let word = self.get(axis, 0x6041).await as u16;
        assert_eq!(word & pattern.mask(), pattern.value(), "{}, axis {axis}: {id}", self.device.name);
    }

    /// Through the states to Operation enabled.
    pub(crate) async fn enable(&mut self) {
        for (word, state) in
            [(0x06, "ready-to-switch-on"), (0x07, "switched-on"), (0x0F, "operation-enabled")]
        {
            self.command(word).await;
            self.all_show(state).await;
        }
    }

    pub(crate) async fn select(&mut self, mode: i64) {
        for axis in self.axes() {
            self.set(axis, 0x6060, mode).await;
        }
        self.cycles(5).await;
        for axis in self.axes() {
            assert_eq!(self.get(axis, 0x6061).await, mode, "{}, axis {axis}", self.device.name);
        }
    }
}
