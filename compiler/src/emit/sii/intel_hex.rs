//! Intel hex: what programmers of EEPROMs read.

use std::fmt::Write;

/// Types of records.
const DATA: u8 = 0x00;
const END: u8 = 0x01;
const UPPER_ADDRESS: u8 = 0x04;

/// The bytes from address 0 on: records of 16 bytes, the upper half of the address where it changes, and the end.
pub(super) fn text(bytes: &[u8]) -> String {
    let mut text = String::new();
    let mut upper = 0;
    for (row, data) in (0_u32..).zip(bytes.chunks(16)) {
        let [high, low] =
            [(row * 16) >> 16, (row * 16) & 0xFFFF].map(|half| u16::try_from(half).unwrap_or(0));
        if high != upper {
            record(&mut text, 0, UPPER_ADDRESS, &high.to_be_bytes());
            upper = high;
        }
        record(&mut text, low, DATA, data);
    }
    record(&mut text, 0, END, &[]);
    text
}

/// A record: length, address, type, data, and what makes the sum of its bytes 0.
fn record(text: &mut String, address: u16, kind: u8, data: &[u8]) {
    let mut bytes = vec![u8::try_from(data.len()).unwrap_or(u8::MAX)];
    bytes.extend(address.to_be_bytes());
    bytes.push(kind);
    bytes.extend(data);
    let sum = bytes.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte));
    bytes.push(sum.wrapping_neg());
    text.push(':');
    for byte in bytes {
        // Writing to a String cannot fail.
        let _ = write!(text, "{byte:02X}");
    }
    text.push('\n');
}
