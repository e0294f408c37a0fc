//! A firmware that serves the object dictionary of the C-887: what a master writes into the mailbox goes in as bytes,
//! and the answer comes out as bytes. The table of entries, their rights, types, lengths and defaults are the
//! description's; the firmware adds what only it knows.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::c887::dictionary::{Dictionary, NAMES};
use devc_generated::c887::objects::{buffered_parameters, position_actual_value, software_position_limit};
use devc_generated::c887::{Axis, Controlword};
use devc_runtime::coe::Mailbox;
use devc_runtime::object::{Address, Value};
use devc_runtime::sdo::{AbortCode, CommunicationState, Hooks, Server};

/// What the firmware has besides the values of the dictionary.
struct Firmware {
    encoders: [i32; 6],
}

impl Hooks<Dictionary> for Firmware {
    /// A position is measured when it is asked for.
    fn before_upload(&mut self, values: &mut Dictionary, address: Address) -> Result<(), AbortCode> {
        for ((axis, of_axis), position) in Axis::ALL.into_iter().zip(&mut values.axes).zip(self.encoders) {
            if address == position_actual_value(axis).address() {
                of_axis.position_actual_value = position;
            }
        }
        Ok(())
    }

    /// A limit is refused if nothing is left between it and the other one.
    fn before_download(
        &mut self,
        values: &mut Dictionary,
        address: Address,
        data: &[u8],
    ) -> Result<(), AbortCode> {
        for (axis, of_axis) in Axis::ALL.into_iter().zip(&values.axes) {
            let [min, _] = of_axis.software_position_limit;
            if address == software_position_limit::max_position_limit(axis).address()
                && i32::from_slice(data)? < min
            {
                return Err(AbortCode::MAXIMUM_BELOW_MINIMUM);
            }
        }
        Ok(())
    }

    /// Writing 1 sets something off; the firmware writes 0 when it is done.
    fn after_download(&mut self, values: &mut Dictionary, address: Address) {
        let start = &mut values.buffered_parameters.work_coordinates;
        if address == buffered_parameters::WORK_COORDINATES.address() && *start == 1 {
            println!("    (the firmware moves the origin to {:?})", values.work_coordinate_system);
            self.encoders = [0; 6];
            *start = 0;
        }
    }
}

/// Mailbox header, CoE header, SDO: in pre-operational.
const REQUESTS: [(&str, &[u8]); 8] = [
    ("the device's name", &[10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x40, 0x08, 0x10, 0, 0, 0, 0, 0]),
    ("the rest of it", &[10, 0, 0, 0, 0, 0x23, 0, 0x20, 0x60, 0, 0, 0, 0, 0, 0, 0]),
    ("where Y is", &[10, 0, 0, 0, 0, 0x33, 0, 0x20, 0x40, 0x64, 0x68, 0, 0, 0, 0, 0]),
    ("work coordinates on", &[10, 0, 0, 0, 0, 0x43, 0, 0x20, 0x23, 0x10, 0x50, 1, 1, 0, 0, 0]),
    ("a limit of X below 0", &[10, 0, 0, 0, 0, 0x53, 0, 0x20, 0x23, 0x7D, 0x60, 2, 0xFF, 0xFF, 0xFF, 0xFF]),
    ("an axis too many", &[10, 0, 0, 0, 0, 0x63, 0, 0x20, 0x40, 0x64, 0x90, 0, 0, 0, 0, 0]),
    ("a controlword, 4 bytes", &[10, 0, 0, 0, 0, 0x73, 0, 0x20, 0x23, 0x40, 0x60, 0, 0x0F, 0, 0, 0]),
    ("a controlword", &[10, 0, 0, 0, 0, 0x13, 0, 0x20, 0x2B, 0x40, 0x60, 0, 0x0F, 0, 0, 0]),
];

fn main() {
    let firmware = Firmware { encoders: [100, -200, 300, 0, 0, 0] };
    let server = Server::new(Dictionary::DEFAULT, firmware);
    let mut mailbox: Mailbox<Dictionary, Firmware> = Mailbox::with_information(server, &NAMES);
    for (what, request) in REQUESTS {
        println!("{what}");
        println!("    master  {}", hex(request));
        let mut answer = [0; 24];
        let length = mailbox.answer(request, CommunicationState::PreOperational, &mut answer);
        println!("    device  {}", hex(answer.get(..length).unwrap_or_default()));
    }
    let [x, ..] = mailbox.server.values.axes;
    println!("X is told to switch on: {}", x.controlword == Controlword(0x000F) && x.controlword.switch_on());
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X} ")).collect()
}
