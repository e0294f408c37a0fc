//! A control program sets up the hexapod C-887 through the mailbox, in millimetres and degrees: each entry knows what its
//! numbers count. The device is its dictionary in the same process; only bytes go from one to the other.
#![expect(clippy::print_stdout, reason = "an example shows what happens")]

use std::error::Error;

use devc_generated::c887::dictionary::Dictionary;
use devc_generated::c887::objects::software_position_limit::max_position_limit;
use devc_generated::c887::objects::work_coordinate_system::{AXIS_U, AXIS_X};
use devc_generated::c887::{Axis, C887};
use devc_runtime::object::{Entry, Readable, Value, Writable};
use devc_runtime::sdo::{CommunicationState::PreOperational, Server};
use devc_runtime::unit::{Angle, Length, Measurand, Motion};

/// What a master does mailbox transfers with.
struct Device(Server<Dictionary>);

impl Device {
    fn write<T: Value, A: Writable, M, Q: Measurand>(
        &mut self,
        entry: Entry<C887, T, A, M, Q>,
        value: T,
    ) -> Result<(), Box<dyn Error>> {
        let data = entry.encode(value);
        println!("    {entry} = {:02X?}", data.as_ref());
        Ok(self.0.download(entry.address(), PreOperational, data.as_ref())?)
    }

    fn read<T: Value, A: Readable, M, Q: Measurand>(
        &mut self,
        entry: Entry<C887, T, A, M, Q>,
    ) -> Result<T, Box<dyn Error>> {
        let mut buffer = [0; 8];
        Ok(entry.decode(self.0.upload(entry.address(), PreOperational, &mut buffer)?)?)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut device = Device(Server::new(Dictionary::DEFAULT, ()));

    println!("the origin: 15 mm along X, turned by -2° about X");
    device.write(AXIS_X, AXIS_X.exact(Length::millimetres(15))?)?;
    device.write(AXIS_U, AXIS_U.exact(Angle::degrees(-2))?)?;
    // a length is no angle: `AXIS_U.exact(Length::millimetres(15))` does not compile

    println!("the limits: 22.5 mm or 15°, whichever the axis has");
    for axis in Axis::ALL {
        let limit = max_position_limit(axis);
        let value = match limit.unit() {
            Motion::Linear(unit) => unit.exact(Length::micrometres(22_500))?,
            Motion::Rotary(unit) => unit.exact(Angle::degrees(15))?,
        };
        device.write(limit, value)?;
        println!("  {axis:?} ends at {}", limit.physical(device.read(limit)?));
    }

    println!("too far: {:?}", AXIS_X.exact(Length::metres(3000)));
    println!("too fine: {:?}", AXIS_X.exact(Length::nanometres(1)));
    Ok(())
}
