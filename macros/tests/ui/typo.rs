use devc_runtime::Device;

#[derive(Device)]
#[device(path = "macros/tests/ui/typo")]
pub struct Drive;

fn main() {
    let _ = Drive::PRODUCT_CODE;
}
