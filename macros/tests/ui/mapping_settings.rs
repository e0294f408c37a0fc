use devc_runtime::Device;
use devc_runtime::pdo::Pdo;

#[derive(Device)]
#[device(path = "devices/s700", member = "s700")]
pub struct S700;

#[derive(Clone, Copy, Pdo)]
pub struct Unnamed {
    pub controlword: s700::Controlword,
}

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Nothing {}

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Uncounted {
    #[pdo(gap = 0)]
    pub controlword: s700::Controlword,
}

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Unknown {
    #[pdo(gap = 8, s700::objects::CONTROLWORD, gaps = 4)]
    pub controlword: s700::Controlword,
}

fn main() {}
