use devc_runtime::Device;

#[derive(Device)]
#[device(pth = "devices/c887", member = "c887", modul = "hexapod")]
pub struct Slips;

#[derive(Device)]
#[device(path = "devices/c887", member = 5, module = "type", runtime = "crate rt")]
pub struct Values;

#[derive(Device)]
#[device(path = "devices/c887", path = "devices/s700" module = a::b, member)]
pub struct Twice;

/// A macro is not expanded in an attribute.
#[derive(Device)]
#[device(path = concat!("devices/", "c887"))]
pub struct Composed;

#[derive(Device)]
#[device]
pub struct Bare;

#[derive(Device)]
#[device("devices/c887")]
pub struct Unnamed;

#[derive(Device)]
#[device(path = )]
pub struct Empty;

#[derive(Device)]
#[device(path "devices/c887", , 5 = 5)]
pub struct Marks;

fn main() {}
