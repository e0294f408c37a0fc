//! A master that says just what a test tells it to.

use std::time::Duration;

use devc_virtual::{Subdevice, Wire};

use crate::devices::Any;

/// The commands by their numbers (ETG.1000.4, DLPDU).
pub(crate) const APRD: u8 = 1;
pub(crate) const APWR: u8 = 2;
pub(crate) const APRW: u8 = 3;
pub(crate) const FPRD: u8 = 4;
pub(crate) const FPWR: u8 = 5;
pub(crate) const FPRW: u8 = 6;
pub(crate) const BRD: u8 = 7;
pub(crate) const BWR: u8 = 8;
pub(crate) const BRW: u8 = 9;
pub(crate) const LRD: u8 = 10;
pub(crate) const LWR: u8 = 11;
pub(crate) const LRW: u8 = 12;
pub(crate) const ARMW: u8 = 13;
pub(crate) const FRMW: u8 = 14;

pub(crate) const STATION: u16 = 0x1001;

/// A datagram as it went, or as it came back.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Datagram {
    pub(crate) command: u8,
    pub(crate) address: [u8; 4],
    pub(crate) data: Vec<u8>,
    pub(crate) counter: u16,
    pub(crate) interrupt: u16,
}

impl Datagram {
    pub(crate) fn new(command: u8, first: u16, second: u16, data: &[u8]) -> Self {
        let [a, b] = first.to_le_bytes();
        let [c, d] = second.to_le_bytes();
        Self { command, address: [a, b, c, d], data: data.to_vec(), counter: 0, interrupt: 0 }
    }

    pub(crate) fn logical(command: u8, address: u32, data: &[u8]) -> Self {
        Self { address: address.to_le_bytes(), ..Self::new(command, 0, 0, data) }
    }
}

/// An Ethernet frame with these datagrams.
pub(crate) fn frame(datagrams: &[Datagram]) -> Vec<u8> {
    let mut body = Vec::new();
    for (number, datagram) in datagrams.iter().enumerate() {
        let more = if number + 1 < datagrams.len() { 0x8000 } else { 0 };
        body.extend([datagram.command, number as u8]);
        body.extend(datagram.address);
        body.extend((datagram.data.len() as u16 | more).to_le_bytes());
        body.extend([0, 0]);
        body.extend(&datagram.data);
        body.extend([0, 0]);
    }
    let mut frame = vec![0xFF; 6];
    frame.extend([0x10; 6]);
    frame.extend([0x88, 0xA4]);
    frame.extend((body.len() as u16 | 0x1000).to_le_bytes());
    frame.extend(body);
    frame.resize(frame.len().max(60), 0);
    frame
}

/// The datagrams of a frame of this master.
pub(crate) fn parse(frame: &[u8]) -> Vec<Datagram> {
    let word = |place: usize| u16::from_le_bytes([frame[place], frame[place + 1]]);
    let (mut datagrams, mut place) = (Vec::new(), 16);
    loop {
        let length = usize::from(word(place + 6) & 0x07FF);
        datagrams.push(Datagram {
            command: frame[place],
            address: frame[place + 2..place + 6].try_into().unwrap(),
            data: frame[place + 10..place + 10 + length].to_vec(),
            counter: word(place + 10 + length),
            interrupt: word(place + 8),
        });
        if word(place + 6) & 0x8000 == 0 {
            return datagrams;
        }
        place += 12 + length;
    }
}

/// A wire with a master at it.
pub(crate) struct Bench {
    pub(crate) wire: Wire<Any>,
}

impl Bench {
    pub(crate) fn new(subdevices: Vec<Subdevice<Any>>) -> Self {
        Self { wire: Wire::new(subdevices) }
    }

    /// One device, with its station address.
    pub(crate) fn of(device: crate::devices::Device) -> Self {
        let mut bench = Self::new(vec![device.subdevice()]);
        assert_eq!(bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes()).counter, 1);
        bench
    }

    /// Sends datagrams in a frame, and tells what came back; after that, 100 µs go by.
    pub(crate) fn all(&mut self, datagrams: &[Datagram]) -> Vec<Datagram> {
        let mut frame = frame(datagrams);
        let length = frame.len();
        assert!(self.wire.pass(&mut frame));
        assert_eq!(frame.len(), length);
        assert_eq!(frame[6], 0x12, "the source address tells that it was on its way");
        self.wait(Duration::from_micros(100));
        parse(&frame)
    }

    pub(crate) fn send(&mut self, command: u8, first: u16, second: u16, data: &[u8]) -> Datagram {
        self.all(&[Datagram::new(command, first, second, data)]).remove(0)
    }

    pub(crate) fn logical(&mut self, command: u8, address: u32, data: &[u8]) -> Datagram {
        self.all(&[Datagram::logical(command, address, data)]).remove(0)
    }

    /// Reads from the first device; none if its working counter tells that it did not answer.
    pub(crate) fn read<const N: usize>(&mut self, register: u16) -> Option<[u8; N]> {
        let answer = self.send(FPRD, STATION, register, &[0; N]);
        (answer.counter == 1).then(|| answer.data.try_into().unwrap())
    }

    /// Writes to the first device, and tells whether it took it.
    pub(crate) fn write(&mut self, register: u16, data: &[u8]) -> bool {
        self.send(FPWR, STATION, register, data).counter == 1
    }

    pub(crate) fn wait(&mut self, time: Duration) {
        self.wire.advance(time);
    }

    /// The events that were told, as words.
    pub(crate) fn told(&mut self) -> Vec<String> {
        self.wire.take_events().into_iter().map(|(_, event)| event.to_string()).collect()
    }
}
