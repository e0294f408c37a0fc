use devc_runtime::Device;

#[derive(Device)]
#[device(path = "devices/c888")]
pub struct C888;

fn main() {
    let _ = C888::PRODUCT_CODE;
}
