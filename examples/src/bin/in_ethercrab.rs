//! Process data as `ethercrab` takes it: that master asks for traits, and the feature `ethercrab` brings them along.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use devc_generated::c887::{Controlword, Inputs, Outputs};
use ethercrab_wire::{EtherCrabWireRead, EtherCrabWireReadSized, EtherCrabWireWrite, WireError};

/// What a program around that master does each cycle, with any of its types: inputs come, outputs go.
fn cycle<I: EtherCrabWireReadSized, O: EtherCrabWireWrite>(
    received: &[u8],
    sent: &mut [u8],
    control: impl FnOnce(I) -> O,
) -> Result<(), WireError> {
    control(I::unpack_from_slice(received)?).pack_to_slice(sent)?;
    Ok(())
}

/// Each axis keeps its place.
fn hold(inputs: Inputs) -> Outputs {
    let mut outputs = Outputs::unpack([0; 42]);
    for (output, input) in outputs.axes.iter_mut().zip(inputs.axes) {
        output.controlword = Controlword(0x000F);
        output.modes_of_operation = input.modes_of_operation_display;
        output.target_position = input.position_actual_value;
    }
    outputs
}

fn main() -> Result<(), WireError> {
    let received: [u8; 66] = core::array::from_fn(|byte| byte as u8);
    let mut sent = [0; 42];
    cycle(&received, &mut sent, hold)?;
    let inputs = Inputs::unpack_from_slice(&received)?;
    let outputs = Outputs::unpack(sent);
    for (input, output) in inputs.axes.iter().zip(outputs.axes) {
        println!("is at {}, is told {}", input.position_actual_value, output.target_position);
    }
    Ok(())
}
