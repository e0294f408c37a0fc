use devc_runtime::Device;

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct Tuple(u8);

#[derive(Device)]
#[device(path = "devices/c887")]
pub enum Choice {
    A,
}

#[derive(Device)]
#[device(path = "devices/c887")]
pub union Either {
    a: u8,
}

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct Generic<const AXES: usize>;

#[derive(Device)]
#[device(path = "devices/c887")]
pub(crate) struct Inner;

/// Everything at once.
#[derive(Device)]
#[device(pth = "devices/c887")]
struct Everything<'a> {
    text: &'a str,
}

fn main() {}
