use devc_runtime::pdo::ProcessImage;

#[derive(Clone, Copy, ProcessImage)]
pub struct Tuple(pub u8, pub u8);

#[derive(Clone, Copy, ProcessImage)]
pub enum Choice {
    A,
}

#[derive(Clone, Copy, ProcessImage)]
pub union Either {
    a: u8,
}

#[derive(Clone, Copy, ProcessImage)]
pub struct Generic<'a, T, const AXES: usize>
where
    T: Copy,
{
    pub axes: [&'a T; AXES],
}

/// All that is wrong with a struct is told at once.
#[derive(Clone, Copy, ProcessImage)]
#[image(runtime = 5, axis = 1)]
pub struct Several<T> {
    #[image(axis)]
    pub alone: T,
    #[image(axis = )]
    pub empty: T,
    #[image(axis = 1, axis = 2)]
    pub twice: T,
    #[image(1)]
    pub unnamed: T,
    #[image = 1]
    pub unbraced: T,
    pub none: [T; 0],
    pub many: [T; 256],
    pub computed: [T; 2 + 1],
    #[image(axes = 1)]
    #[image(axis = 1 2)]
    pub both: [T; N],
}

const N: usize = 3;

fn main() {}
