use devc_runtime::Device;

#[derive(Device)]
#[device(path = "devices/c887")]
struct C887;

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct Drive {
    position: i32,
}

fn main() {}
