use devc_runtime::Device;
use devc_runtime::pdo::ProcessImage;

#[derive(Device)]
#[device(path = "devices/c887")]
pub struct C887;

#[derive(Device)]
#[device(path = "devices/s700", member = "s700")]
pub struct S700;

#[derive(Device)]
#[device(path = "devices/pmc-sc6", member = "double")]
pub struct Sc6;

/// Both PDOs of an axis, and one twice.
#[derive(Clone, Copy, ProcessImage)]
pub struct Exclusive {
    pub cyclic: [c887::RxPdo1600; 6],
    #[image(axis = c887::Axis::W)]
    pub profile: c887::RxPdo1601,
    #[image(axis = c887::Axis::Y)]
    pub again: c887::RxPdo1600,
}

/// More axes than there are.
#[derive(Clone, Copy, ProcessImage)]
pub struct Beyond {
    #[image(axis = c887::Axis::W)]
    pub axes: [c887::TxPdo1A00; 2],
}

/// What goes the other way, and what is another device's.
#[derive(Clone, Copy, ProcessImage)]
pub struct Mixed {
    pub outputs: c887::RxPdo1600,
    pub inputs: c887::TxPdo1A00,
    pub others: s700::RxPdo1701,
}

/// More PDOs and more bytes than the drive takes.
#[derive(Clone, Copy, ProcessImage)]
pub struct Several {
    pub motion_task: s700::RxPdo1710,
    pub macro_program: s700::RxPdo1714,
    pub interface: s700::RxPdo1708,
}

/// One axis of two, where both are always there.
#[derive(Clone, Copy, ProcessImage)]
pub struct Half {
    pub a: sc6::RxPdo1600,
}

/// No PDO at all.
#[derive(Clone, Copy, ProcessImage)]
pub struct Number {
    pub position: i32,
}

#[derive(Clone, Copy, ProcessImage)]
pub struct Nothing;

#[derive(Clone, Copy, ProcessImage)]
pub struct Empty {}

#[derive(Clone, Copy, ProcessImage)]
pub struct Unknown {
    #[image(axes = 1)]
    pub position: c887::RxPdo1600,
}

#[derive(Clone, Copy, ProcessImage)]
pub struct Uncounted {
    pub axes: [c887::RxPdo1600; c887::Axis::ALL.len()],
}

fn main() {}
