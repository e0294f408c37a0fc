//! The frame of a cycle, and a device that is ready for it.

use std::time::Duration;

use devc_runtime::esm::Role;
use devc_virtual::Wire;
use devc_virtual::drive::Drive;

/// How often a master sends it.
pub(crate) const PERIOD: Duration = Duration::from_millis(1);

const LRW: u8 = 12;
const FRMW: u8 = 14;
const APWR: u8 = 2;

/// Process data in one LRW, and the time of the first clock for all.
pub(crate) fn frame_of_a_cycle(bytes: usize) -> Vec<u8> {
    frame(&[(LRW, [0; 4], vec![0; bytes]), (FRMW, [1, 0x10, 0x10, 0x09], vec![0; 8])])
}

/// Brings the only device of a wire to Operational, and tells the lengths of its process data.
pub(crate) fn bring_to_operational(wire: &mut Wire<Drive>) -> (usize, usize) {
    let (areas, lengths) = {
        let subdevice = wire.subdevices_mut().first_mut().expect("a subdevice");
        devc_virtual::Firmware::expected(&mut subdevice.firmware)
    };
    let mut write = |register: u16, data: &[u8]| {
        let [low, high] = register.to_le_bytes();
        let mut frame = frame(&[(APWR, [0, 0, low, high], data.to_vec())]);
        wire.pass(&mut frame);
        wire.advance(PERIOD);
    };
    let of = |role| {
        areas
            .of(role)
            .next()
            .map_or((0, 0, 0), |(number, area)| (area.address, area.length.1, lengths[number] as u16))
    };
    let [out, into, outputs, inputs] =
        [Role::MailboxOut, Role::MailboxIn, Role::Outputs, Role::Inputs].map(of);
    let managers = [
        ((out.0, out.1), 0x26),
        ((into.0, into.1), 0x22),
        ((outputs.0, outputs.2), 0x64),
        ((inputs.0, inputs.2), 0x20),
    ];
    write(0x0010, &[0x01, 0x10]);
    for (number, ((address, length), control)) in (0_u16..).zip(managers) {
        let ([a, b], [c, d]) = (address.to_le_bytes(), length.to_le_bytes());
        write(0x0800 + 8 * number, &[a, b, c, d, control, 0, 1, 0]);
    }
    let fmmus = [(0, outputs.2, outputs.0, 2), (outputs.2, inputs.2, inputs.0, 1)];
    for (number, (logical, length, address, kind)) in (0_u16..).zip(fmmus) {
        let [a, b] = logical.to_le_bytes();
        let ([c, d], [e, f]) = (length.to_le_bytes(), address.to_le_bytes());
        write(0x0600 + 16 * number, &[a, b, 0, 0, c, d, 0, 7, e, f, 0, kind, 1, 0, 0, 0]);
    }
    write(0x0120, &[2, 0]);
    write(0x0120, &[4, 0]);
    write(outputs.0, &vec![0; outputs.2.into()]);
    write(0x0120, &[8, 0]);
    (outputs.2.into(), inputs.2.into())
}

/// An Ethernet frame with these datagrams: command, address, data.
fn frame(datagrams: &[(u8, [u8; 4], Vec<u8>)]) -> Vec<u8> {
    let mut body = Vec::new();
    for (number, (command, address, data)) in datagrams.iter().enumerate() {
        let more = if number + 1 < datagrams.len() { 0x8000 } else { 0 };
        body.extend([*command, 0]);
        body.extend(address);
        body.extend((data.len() as u16 | more).to_le_bytes());
        body.extend([0, 0]);
        body.extend(data);
        body.extend([0, 0]);
    }
    let mut frame = [[0xFF; 6], [0x10; 6]].concat();
    frame.extend([0x88, 0xA4]);
    frame.extend((body.len() as u16 | 0x1000).to_le_bytes());
    frame.extend(body);
    frame
}
