mod fieldbus {
    pub use devc_runtime as runtime;
}

use fieldbus::runtime::Device;

#[derive(Device)]
#[device(path = "devices/c887", runtime = "crate::fieldbus::runtime", module = "hexapod")]
pub struct Controller;

fn main() {
    assert_eq!(hexapod::objects::controlword(hexapod::Axis::Y).address().index, 0x6840);
    assert_eq!(Controller::NAME, "C-887.53x");
}
