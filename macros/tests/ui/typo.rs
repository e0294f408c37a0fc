use devc_runtime::Device;

#[derive(Device)]
#[device(path = "typo")]
pub struct Drive;

fn main() {
    let _ = Drive::PRODUCT_CODE;
}
