//! Captures: what a master and a device at one station say to each other, as frames in a file.

/// The place of a station.
pub(crate) const STATION: u16 = 0x1001;

/// Commands of datagrams.
pub(crate) const FPRD: u8 = 4;
pub(crate) const FPWR: u8 = 5;
pub(crate) const LRW: u8 = 12;

/// Where mail lies, by the description.
#[derive(Clone, Copy)]
pub(crate) struct Mailbox {
    pub(crate) out: u16,
    pub(crate) back: u16,
}

/// A file in the format of libpcap.
pub(crate) struct Capture {
    file: Vec<u8>,
    /// The number of the last frame.
    pub(crate) frames: usize,
    station: u16,
}

impl Capture {
    pub(crate) fn new() -> Self {
        let mut file = 0xA1B2_C3D4_u32.to_le_bytes().to_vec();
        file.extend([2, 0, 4, 0]);
        file.extend([0; 8]);
        file.extend(0xFFFF_u32.to_le_bytes());
        file.extend(1_u32.to_le_bytes());
        Self { file, frames: 0, station: STATION }
    }

    /// From here on another device is spoken to.
    pub(crate) fn at(&mut self, station: u16) {
        self.station = station;
    }

    /// A datagram of its own, to `address` or register `offset`; how many have taken it.
    pub(crate) fn datagram(&mut self, command: u8, address: u16, offset: u16, data: &[u8], counter: u16) {
        let length = u16::try_from(data.len()).unwrap();
        let mut frame = [0xFF; 6].to_vec();
        frame.extend([2, 0, 0, 0, 0, 1, 0x88, 0xA4]);
        frame.extend(((length + 12) | 0x1000).to_le_bytes());
        frame.extend([command, 0]);
        frame.extend(address.to_le_bytes());
        frame.extend(offset.to_le_bytes());
        frame.extend(length.to_le_bytes());
        frame.extend([0, 0]);
        frame.extend(data);
        frame.extend(counter.to_le_bytes());
        frame.resize(frame.len().max(60), 0);
        let length = u32::try_from(frame.len()).unwrap().to_le_bytes();
        self.frames += 1;
        self.file.extend(u32::try_from(self.frames).unwrap().to_le_bytes());
        self.file.extend([0; 4]);
        self.file.extend([length, length].concat());
        self.file.extend(frame);
    }

    pub(crate) fn write(&mut self, register: u16, data: &[u8]) {
        self.datagram(FPWR, self.station, register, data, 0);
    }

    pub(crate) fn read(&mut self, register: u16, data: &[u8]) {
        self.datagram(FPRD, self.station, register, data, 1);
    }

    /// A unit of logical memory: outputs are what the device writes to its memory.
    pub(crate) fn unit(&mut self, number: u16, logical: u32, length: usize, physical: u16, is_output: bool) {
        let mut unit = logical.to_le_bytes().to_vec();
        unit.extend(u16::try_from(length).unwrap().to_le_bytes());
        unit.extend([0, 7]);
        unit.extend(physical.to_le_bytes());
        unit.extend([0, if is_output { 2 } else { 1 }, 1, 0, 0, 0]);
        self.write(0x600 + 16 * number, &unit);
    }

    /// What the mailbox of a service of CoE holds.
    fn mail(service: u16, content: &[u8]) -> Vec<u8> {
        let mut mail = u16::try_from(content.len() + 2).unwrap().to_le_bytes().to_vec();
        mail.extend([0, 0, 0, 0x13]);
        mail.extend((service << 12).to_le_bytes());
        mail.extend(content);
        mail.resize(mail.len().max(64), 0);
        mail
    }

    pub(crate) fn request(&mut self, mailbox: Mailbox, sdo: &[u8]) {
        self.write(mailbox.out, &Self::mail(2, sdo));
    }

    pub(crate) fn response(&mut self, mailbox: Mailbox, sdo: &[u8]) {
        self.read(mailbox.back, &Self::mail(3, sdo));
    }

    pub(crate) fn emergency(&mut self, mailbox: Mailbox, code: u16) {
        let content = [&code.to_le_bytes()[..], &[0x21, 1, 2, 3, 4, 5]].concat();
        self.read(mailbox.back, &Self::mail(1, &content));
    }

    /// A write that the device takes.
    pub(crate) fn download(&mut self, mailbox: Mailbox, address: (usize, usize), data: &[u8]) {
        self.request(mailbox, &sdo(1, address, data));
        self.response(mailbox, &sdo(3, address, &[]));
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.file
    }
}

/// An SDO with a specifier; data of four bytes and less are in it, longer ones behind their length.
pub(crate) fn sdo(specifier: u8, (index, subindex): (usize, usize), data: &[u8]) -> Vec<u8> {
    let (length, short) = (data.len(), (1..=4).contains(&data.len()));
    let unused = if short { u8::try_from(4 - length).unwrap() << 2 } else { 0 };
    let mut sdo = vec![specifier << 5 | unused | if short { 3 } else { u8::from(length > 4) }];
    sdo.extend(u16::try_from(index).unwrap().to_le_bytes());
    sdo.push(u8::try_from(subindex).unwrap());
    if length > 4 {
        sdo.extend(u32::try_from(length).unwrap().to_le_bytes());
    }
    sdo.extend(data);
    sdo.resize(sdo.len().max(8), 0);
    sdo
}
