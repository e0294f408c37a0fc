use devc_runtime::Device;

#[derive(Device)]
pub struct C887;

fn main() {}
