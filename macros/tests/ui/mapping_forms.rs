use devc_runtime::pdo::Pdo;

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Unit;

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub struct Tuple(pub u16);

#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub enum Choice {
    A,
}

/// All that is wrong with a struct is told at once.
#[derive(Clone, Copy, Pdo)]
#[pdo(mapping = 5, per_axis = false, gap = -1)]
#[pdo(runtime = devc_runtime::pdo::<u8>, entry)]
pub struct Several<T: Copy> {
    #[pdo(gap)]
    pub alone: T,
    #[pdo(gap = 256)]
    pub many: T,
    #[pdo(gap = "8")]
    pub text: T,
    #[pdo(OBJECT, OTHER)]
    pub two: T,
    #[pdo(OBJECT OTHER)]
    pub uncomma: T,
    #[pdo(gaps = 4, gap = 8, gap = 8)]
    pub settings: T,
}

/// A macro makes it, and what is wrong is what is handed to it.
macro_rules! mapping {
    ($name:ident, $free:expr, $($field:ident: $type:ty, $gap:expr);*) => {
        #[derive(Clone, Copy, Pdo)]
        #[pdo(mapping = $free)]
        pub struct $name {
            $(#[pdo(gap = $gap)] pub $field: $type,)*
        }
    };
}

mapping!(Made, free(), position: i32, 8; velocity: i32, 0);

fn main() {}
