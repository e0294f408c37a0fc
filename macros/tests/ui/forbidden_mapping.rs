use devc_runtime::Device;
use devc_runtime::pdo::Pdo;

#[derive(Device)]
#[device(path = "devices/s700", member = "s700")]
pub struct S700;

#[derive(Device)]
#[device(path = "devices/pmc-sc6", member = "double")]
pub struct Sc6;

/// Another type, what cannot be received, what is not there, and what is another device's.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Wrong {
    pub controlword: u32,
    #[pdo(s700::objects::STATUSWORD)]
    pub statusword: s700::Statusword,
    #[pdo(s700::objects::MANUFACTURER_DEVICE_NAME)]
    pub name: [u8; 4],
    pub no_such_object: i32,
    #[pdo(sc6::objects::target_position(sc6::Axis::A))]
    pub position: i32,
}

/// 68 bytes, where there is room for 64.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Long {
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub a: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub b: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub c: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub d: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub e: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub f: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub g: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub h: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub i: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub j: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub k: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub l: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub m: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub n: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub o: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub p: i32,
    #[pdo(s700::objects::POSITION_SETPOINT)]
    pub q: i32,
}

/// For one axis of two.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = sc6::FreeRxPdo1600)]
pub struct One {
    #[pdo(sc6::objects::controlword(sc6::Axis::A))]
    pub controlword: sc6::Controlword,
}

/// A PDO whose mapping is fixed.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::RxPdo1701)]
pub struct Fixed {
    pub controlword: s700::Controlword,
}

/// 65 bytes with the gaps.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600, gap = 8)]
pub struct Gaps {
    #[pdo(gap = 248)]
    pub controlword: s700::Controlword,
    #[pdo(s700::objects::POSITION_SETPOINT, gap = 216)]
    pub position: i32,
}

fn main() {}
