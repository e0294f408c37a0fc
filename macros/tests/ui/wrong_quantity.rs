use devc_runtime::Device;
use devc_runtime::unit::{Angle, Length};

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct C887;

use c887::{Axis, objects};

fn main() {
    let origin = objects::work_coordinate_system::AXIS_X.saturating(Angle::degrees(15));
    let target = objects::target_position(Axis::X).saturating(Length::millimetres(15));
    let controlword = objects::controlword(Axis::X).saturating(Length::millimetres(15));
}
