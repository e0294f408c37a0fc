use devc_runtime::Device;

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct C887;

fn main() {
    let outputs = c887::Outputs::unpack([0; 42]);
    assert_eq!(outputs.pack(), [0; 42]);
    assert_eq!(C887::PRODUCT_CODE, 3);
}
