use devc_runtime::Device;

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct C887;

fn main() {
    let position = c887::objects::position_actual_value(c887::Axis::X);
    position.encode(5);
    let target = c887::objects::target_position(c887::Axis::X);
    target.encode(5_i16);
}
