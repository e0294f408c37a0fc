//! Frames to virtual drives: those of a master that is wrong, and bytes that nobody would send.

use std::sync::LazyLock;
use std::time::Duration;

use bolero::TypeGenerator;
use devc::text::characters::hazard;
use devc_runtime::esm::{Area, Areas, Role};
use devc_virtual::drive::{Drive, Model};
use devc_virtual::{Firmware as _, Subdevice, Wire};

use crate::run::holds;
use crate::subjects::{ALL, SHIPPED, compile};

/// What a master does with the drives on a wire.
#[derive(Debug, TypeGenerator)]
struct Input {
    drives: Vec<u8>,
    /// How far the first drive is brought before: its sync managers, and the states up to this one.
    start: u8,
    steps: Vec<Step>,
}

#[derive(Debug, TypeGenerator)]
enum Step {
    Frame(Vec<Sent>),
    /// Bytes that are no frame of datagrams, behind a head that says they are.
    Bytes(Vec<u8>),
    /// Bytes without a head.
    Noise(Vec<u8>),
    /// A frame of datagrams with a byte changed, and an end.
    Broken {
        sent: Vec<Sent>,
        at: u16,
        byte: u8,
        end: u16,
    },
    Mail(Vec<u8>),
    Control(u16),
    Wait(u16),
}

#[derive(Debug, Clone, TypeGenerator)]
struct Sent {
    command: u8,
    station: Station,
    place: Place,
    length: u8,
    data: Vec<u8>,
}

#[derive(Debug, Clone, TypeGenerator)]
enum Station {
    First,
    Position(u8),
    Any(u16),
}

/// Where a datagram goes to: the registers that map memory, mail, process data, and any other.
#[derive(Debug, Clone, TypeGenerator)]
enum Place {
    Register(u16),
    Fmmu(u8),
    Manager(u8),
    Clock(u8),
    Eeprom(u8),
    Memory(u16),
    Any(u16),
}

const STATION: u16 = 0x1001;
const APWR: u8 = 2;
const FPWR: u8 = 5;
const BRD: u8 = 7;

/// The shipped drives with images of their EEPROMs, made once: a model is kept for ever.
static DRIVES: LazyLock<Vec<(Model, Vec<u8>)>> = LazyLock::new(|| {
    let families = ALL.iter().take(SHIPPED).map(|files| compile(files).family.expect("no errors"));
    let drives = families.flat_map(|family| {
        let drive = |device| (Model::new(device), devc::sii::image_of_any_size(device, &[8, 12, 0, 0, 0, 0]));
        family.members.iter().map(drive).collect::<Vec<_>>()
    });
    drives.collect()
});

#[test]
fn frames() {
    holds("frames", 150, |input: &Input| {
        let mut bench = Bench::new(&input.drives);
        bench.bring(input.start);
        for step in &input.steps {
            bench.take(step);
        }
        bench.goes_on();
    });
}

struct Bench {
    wire: Wire<Drive>,
    mailbox: Area,
}

/// Where each sync manager lies and how long it is, with its control byte.
fn managers(areas: Areas, lengths: &[usize]) -> [((u16, u16), u8); 4] {
    let control =
        [(Role::MailboxOut, 0x26), (Role::MailboxIn, 0x22), (Role::Outputs, 0x64), (Role::Inputs, 0x20)];
    control.map(|(role, control)| match areas.of(role).next() {
        Some((_, area)) if control & 0x02 != 0 => ((area.address, area.length.1), control),
        Some((number, area)) => ((area.address, lengths[number] as u16), control),
        None => ((0, 0), control),
    })
}

impl Bench {
    fn new(drives: &[u8]) -> Self {
        let drive = |number: &u8| {
            let (model, image) = &DRIVES[usize::from(*number) % DRIVES.len()];
            Subdevice::new(Drive::new(*model), image.clone())
        };
        let numbers = if drives.is_empty() { &[0] } else { drives };
        let mut subdevices: Vec<Subdevice<Drive>> = numbers.iter().take(3).map(drive).collect();
        let (areas, _) = subdevices[0].firmware.expected();
        let mailbox = areas.of(Role::MailboxOut).next().expect("every shipped drive has a mailbox").1;
        let mut bench = Self { wire: Wire::new(subdevices), mailbox };
        bench.write(APWR, 0, 0x0010, &STATION.to_le_bytes());
        bench
    }

    /// Sets what a master sets at start-up, as far as `start` says, and asks for the states.
    fn bring(&mut self, start: u8) {
        let (areas, lengths) = self.wire.subdevices_mut()[0].firmware.expected();
        let managers = managers(areas, &lengths);
        for (number, ((address, length), control)) in (0_u16..).zip(managers) {
            let [a, b] = address.to_le_bytes();
            let [c, d] = length.to_le_bytes();
            self.write(FPWR, STATION, 0x0800 + 8 * number, &[a, b, c, d, control, 0, 1, 0]);
        }
        for ((number, kind), ((address, length), _)) in [(0_u16, 2), (1, 1)].into_iter().zip(&managers[2..]) {
            let [a, b] = address.to_le_bytes();
            let [c, d] = length.to_le_bytes();
            let logical = 0x10 + 0x10 * number as u8;
            self.write(
                FPWR,
                STATION,
                0x0600 + 16 * number,
                &[0, logical, 0, 0, c, d, 0, 7, a, b, 0, kind, 1, 0, 0, 0],
            );
        }
        for state in [2, 4, 8].into_iter().take(usize::from(start % 4)) {
            self.write(FPWR, STATION, 0x0120, &[state, 0]);
            let mut outputs = frame(&[(12, [0, 0x10, 0, 0], vec![0; managers[2].0.1.into()])]);
            self.pass(&mut outputs);
        }
    }

    fn take(&mut self, step: &Step) {
        match step {
            Step::Frame(sent) => {
                let sent: Vec<_> = sent.iter().map(|sent| self.datagram(sent)).take(15).collect();
                let mut there = frame(&sent);
                let before = heads(&there);
                self.pass(&mut there);
                assert_eq!(heads(&there), before, "a datagram came back as another");
            }
            Step::Bytes(bytes) => {
                let length = (bytes.len() as u16 | 0x1000).to_le_bytes();
                self.pass(&mut [&[0xFF; 12][..], &[0x88, 0xA4], &length, bytes].concat());
            }
            Step::Noise(bytes) => self.pass(&mut bytes.clone()),
            Step::Broken { sent, at, byte, end } => {
                let sent: Vec<_> = sent.iter().map(|sent| self.datagram(sent)).take(15).collect();
                let mut frame = frame(&sent);
                let (at, end) = (usize::from(*at) % frame.len(), usize::from(*end) % (2 * frame.len()));
                frame[at] = *byte;
                frame.truncate(end);
                self.pass(&mut frame);
            }
            Step::Mail(message) => {
                let Area { address, length } = self.mailbox;
                let mut message = message.clone();
                message.resize(length.1.into(), 0);
                self.write(FPWR, STATION, address, &message);
                self.pass(&mut frame(&[(4, place(STATION, 0x080D), vec![0])]));
            }
            Step::Control(control) => self.write(FPWR, STATION, 0x0120, &control.to_le_bytes()),
            Step::Wait(time) => self.wire.advance(Duration::from_micros((*time).into()) * 16),
        }
    }

    fn datagram(&self, sent: &Sent) -> (u8, [u8; 4], Vec<u8>) {
        let station = match sent.station {
            Station::First => STATION,
            Station::Position(position) => u16::from(position % 4).wrapping_neg(),
            Station::Any(station) => station,
        };
        let offset = match sent.place {
            Place::Register(register) => register % 0x0A00,
            Place::Fmmu(place) => 0x0600 + u16::from(place),
            Place::Manager(place) => 0x0800 + u16::from(place % 0x80),
            Place::Clock(place) => 0x0900 + u16::from(place),
            Place::Eeprom(place) => 0x0500 + u16::from(place % 16),
            Place::Memory(place) => 0x1000 + place % 0x2000,
            Place::Any(place) => place,
        };
        let mut data = sent.data.clone();
        data.resize(sent.length.into(), 0);
        (sent.command % 16, place(station, offset), data)
    }

    fn write(&mut self, command: u8, station: u16, register: u16, data: &[u8]) {
        self.pass(&mut frame(&[(command, place(station, register), data.to_vec())]));
    }

    fn pass(&mut self, frame: &mut [u8]) {
        self.wire.pass(frame);
        self.wire.advance(Duration::from_micros(50));
        for (_, event) in self.wire.take_events() {
            let text = event.to_string();
            assert!(!text.is_empty() && text.chars().all(|c| hazard(c).is_none()), "{text:?}");
        }
    }

    /// Whatever came, all drives still answer, and each is in a state.
    fn goes_on(&mut self) {
        let count = self.wire.subdevices().len();
        let mut frame = frame(&[(BRD, [0; 4], vec![0])]);
        self.pass(&mut frame);
        assert_eq!(usize::from(frame[27]), count);
        for subdevice in self.wire.subdevices() {
            assert!(subdevice.state().is_some());
        }
    }
}

fn place(station: u16, offset: u16) -> [u8; 4] {
    let ([a, b], [c, d]) = (station.to_le_bytes(), offset.to_le_bytes());
    [a, b, c, d]
}

/// An Ethernet frame with these datagrams (ETG.1000.4, DLPDU).
fn frame(datagrams: &[(u8, [u8; 4], Vec<u8>)]) -> Vec<u8> {
    let mut body = Vec::new();
    for (number, (command, address, data)) in datagrams.iter().enumerate() {
        let more = if number + 1 < datagrams.len() { 0x8000 } else { 0 };
        body.extend([*command, number as u8]);
        body.extend(address);
        body.extend((data.len() as u16 | more).to_le_bytes());
        body.extend([0, 0]);
        body.extend(data);
        body.extend([0, 0]);
    }
    let mut frame = vec![0xFF; 12];
    frame.extend([0x88, 0xA4]);
    frame.extend((body.len() as u16 & 0x07FF | 0x1000).to_le_bytes());
    frame.extend(body);
    frame
}

/// Commands, numbers and lengths of the datagrams of a frame.
fn heads(frame: &[u8]) -> Vec<(u8, u8, usize)> {
    let (mut heads, mut place) = (Vec::new(), 16);
    while let Some(head) = frame.get(place..place + 10) {
        let length = usize::from(u16::from_le_bytes([head[6], head[7]]) & 0x07FF);
        heads.push((head[0], head[1], length));
        place += 12 + length;
    }
    heads
}
