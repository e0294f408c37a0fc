//! Structs and attributes as they may be written.
#![expect(unreachable_pub, reason = "a device is public, a test is not")]

use devc_runtime::Device;

mod fieldbus {
    pub(crate) use devc_runtime as runtime;
}

#[derive(Debug, Device)]
#[device(path = "../devices/c887")]
pub struct C887;

#[derive(Debug, Device)]
#[device(path = "../devices/c887", runtime = "crate::forms::fieldbus::runtime", module = "hexapod")]
pub struct Controller;

#[test]
fn a_device_becomes_a_module() {
    let outputs = c887::Outputs::unpack([0; 42]);
    assert_eq!(outputs.pack(), [0; 42]);
    assert_eq!(C887::PRODUCT_CODE, 3);
}

#[test]
fn runtime_and_module_have_names() {
    assert_eq!(hexapod::objects::controlword(hexapod::Axis::Y).address().index, 0x6840);
    assert_eq!(Controller::NAME, "C-887.53x");
}
