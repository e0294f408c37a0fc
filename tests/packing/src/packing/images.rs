//! The four images: their fields for the ways to convert them, and what has to come of bytes that count up from 1.

/// Hands each image to a macro, behind what is for the macro itself: its name, its bytes, its PDO and how many of them
/// there are; then each field of the PDO with its type, its first byte and its number of bytes.
macro_rules! images {
    ($way:ident $($own:tt)*) => {
        // C-887, RxPDO 0x1600 of each axis
        $way! {
            $($own)* C887Outputs, 42 = [C887Out, 7; 6]:
            controlword: u16 at 0, 2; mode: i8 at 2, 1; position: i32 at 3, 4;
        }
        // C-887, TxPDO 0x1A00 of each axis
        $way! {
            $($own)* C887Inputs, 66 = [C887In, 11; 6]:
            statusword: u16 at 0, 2; mode: i8 at 2, 1; position: i32 at 3, 4; following_error: i32 at 7, 4;
        }
        // S700, TxPDO 0x1B0B
        $way! {
            $($own)* S700Inputs, 40 = [S700In, 40; 1]:
            position_1: i32 at 0, 4; position_2: i32 at 4, 4; velocity: i32 at 8, 4; current: i16 at 12, 2;
            statusword: u16 at 14, 2; errors: i32 at 16, 4; warnings: i32 at 20, 4; digital_io: u32 at 24, 4;
            analog_1: i16 at 28, 2; analog_2: i16 at 30, 2; following_error: i32 at 32, 4;
            motion_task: i32 at 36, 4;
        }
        // PMC SC6, double axis, TxPDO 0x1A00 of each axis
        $way! {
            $($own)* PilzInputs, 58 = [PilzIn, 29; 2]:
            statusword: u16 at 0, 2; mode: i8 at 2, 1; position: i32 at 3, 4; velocity: i32 at 7, 4;
            torque: i16 at 11, 2; following_error: i32 at 13, 4; digital_inputs: u32 at 17, 4;
            additional_position: i32 at 21, 4; statusword_2: u16 at 25, 2; statusword_user: u16 at 27, 2;
        }
    };
}

/// The values of an image in the PDOs of a way's own.
macro_rules! values {
    ($image:ident = [$pdo:ident; $count:literal]: $($field:ident)*) => {
        pub type $image = [$pdo; $count];

        impl Values for $image {
            const ZERO: Self = [const { $pdo { $($field: 0,)* } }; $count];

            fn fields(&self) -> Vec<i64> {
                self.iter().flat_map(|pdo| [$(pdo.$field.into()),*]).collect()
            }
        }
    };
}

pub(super) use {images, values};

/// A frame whose bytes count up from 1. Of the digital inputs and outputs of the S700, bytes 24 to 27, only the lower
/// half is used.
pub fn frame<const N: usize>() -> [u8; N] {
    std::array::from_fn(|byte| if N == 40 && (byte == 26 || byte == 27) { 0 } else { byte as u8 + 1 })
}

/// The fields of the last PDO of an image of so many bytes, in the order of the manual, if the frame is [`frame`].
pub fn last_fields(bytes: usize) -> &'static [i64] {
    match bytes {
        42 => &[0x2524, 0x26, 0x2A29_2827],
        66 => &[0x3938, 0x3A, 0x3E3D_3C3B, 0x4241_403F],
        40 => &[
            0x0403_0201,
            0x0807_0605,
            0x0C0B_0A09,
            0x0E0D,
            0x100F,
            0x1413_1211,
            0x1817_1615,
            0x1A19,
            0x1E1D,
            0x201F,
            0x2423_2221,
            0x2827_2625,
        ],
        58 => &[
            0x1F1E,
            0x20,
            0x2423_2221,
            0x2827_2625,
            0x2A29,
            0x2E2D_2C2B,
            0x3231_302F,
            0x3635_3433,
            0x3837,
            0x3A39,
        ],
        _ => &[],
    }
}
