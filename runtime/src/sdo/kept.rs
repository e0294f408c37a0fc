//! The structs that keep the values of a dictionary, each field in a line.

use super::Slot;

/// A value that a field keeps.
pub trait Kept {
    /// The value in its place.
    fn slot(&mut self) -> Slot<'_>;
}

macro_rules! numbers {
    ($($number:ty, $slot:ident;)+) => {
        $(
            impl Kept for $number {
                #[inline]
                fn slot(&mut self) -> Slot<'_> {
                    Slot::$slot(self)
                }
            }
        )+
    };
}
numbers! {
    bool, Bool;
    i8, I8;
    i16, I16;
    i32, I32;
    i64, I64;
    u8, U8;
    u16, U16;
    u32, U32;
    u64, U64;
    f32, F32;
    f64, F64;
}

impl<const N: usize> Kept for [u8; N] {
    #[inline]
    fn slot(&mut self) -> Slot<'_> {
        Slot::Bytes(self)
    }
}

impl Kept for &'static str {
    #[inline]
    fn slot(&mut self) -> Slot<'_> {
        Slot::Text(self)
    }
}

/// Makes the struct that keeps the values of a dictionary, or of one of its axes: for each field its number, its name,
/// its type, its default and how it keeps them.
///
/// | kept | a field has |
/// |---|---|
/// | `value` | one value |
/// | `items` | an array of values |
/// | `list` | a [`List`](crate::sdo::List) |
/// | `record` | a struct that [`record!`](crate::record) makes |
///
/// ```
/// use devc_runtime::sdo::{Place, Slot};
///
/// devc_runtime::dictionary! {
///     /// Every object whose value can change.
///     pub struct Dictionary, "What holds from the start on.";
///     /// `0x1000:00` Device type.
///     0 device_type: u32 = 0x0002_0192, value;
///     /// `0x5000` Set-points.
///     1 set_points: [i32; 2] = [0; 2], items;
/// }
///
/// let mut values = Dictionary::DEFAULT;
/// assert_eq!(values.field(Place { field: 1, item: 1, axis: 0 }), Some(Slot::I32(&mut 0)));
/// assert_eq!(values.field(Place { field: 1, item: 2, axis: 0 }), None);
/// ```
#[macro_export]
macro_rules! dictionary {
    (
        $(#[$about:meta])*
        pub struct $name:ident, $default_about:literal;
        $($(#[$doc:meta])* $number:literal $field:ident: $type:ty = $default:expr, $kept:ident;)*
        $(axes $axis:ty, $count:literal = $axes:expr;)?
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name {
            $($(#[$doc])* pub $field: $type,)*
            $(
                /// What each axis has, in order.
                pub axes: [$axis; $count],
            )?
        }

        impl $name {
            #[doc = $default_about]
            pub const DEFAULT: Self = Self { $($field: $default,)* $(axes: { let axes: [$axis; $count] = $axes; axes },)? };

            /// The value at a place, if there is one.
            pub fn field(&mut self, place: $crate::sdo::Place) -> ::core::option::Option<$crate::sdo::Slot<'_>> {
                match place.field {
                    $($number => $crate::kept!($kept self.$field, place.item),)*
                    _ => {
                        $(
                            let axes: &mut [$axis] = &mut self.axes;
                            if let Some(axis) = axes.get_mut(usize::from(place.axis)) {
                                return axis.field(place);
                            }
                        )?
                        ::core::option::Option::None
                    }
                }
            }
        }

        impl ::core::default::Default for $name {
            fn default() -> Self {
                Self::DEFAULT
            }
        }
    };
}

/// Makes the struct that keeps the values of an object: for each its place among them, its name and its type.
///
/// ```
/// use devc_runtime::sdo::Slot;
///
/// devc_runtime::record! {
///     /// `0x1018` Identity object.
///     pub struct IdentityObject;
///     /// `0x1018:01` Vendor ID.
///     0 vendor_id: u32;
///     /// `0x1018:02` Product code.
///     1 product_code: u32;
/// }
///
/// let mut identity = IdentityObject { vendor_id: 0x076D, product_code: 3 };
/// assert_eq!(identity.field(1), Some(Slot::U32(&mut 3)));
/// ```
#[macro_export]
macro_rules! record {
    (
        $(#[$about:meta])*
        pub struct $name:ident;
        $($(#[$doc:meta])* $number:literal $field:ident: $type:ty;)*
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name {
            $($(#[$doc])* pub $field: $type,)*
        }

        impl $name {
            /// The value at a place, if there is one.
            pub fn field(&mut self, item: u8) -> ::core::option::Option<$crate::sdo::Slot<'_>> {
                match item {
                    $($number => ::core::option::Option::Some($crate::sdo::Kept::slot(&mut self.$field)),)*
                    _ => ::core::option::Option::None,
                }
            }
        }
    };
}

/// The value at a position of a field, by how the field keeps its values.
#[doc(hidden)]
#[macro_export]
macro_rules! kept {
    (value $field:expr, $item:expr) => {
        ::core::option::Option::Some($crate::sdo::Kept::slot(&mut $field))
    };
    (items $field:expr, $item:expr) => {
        $field.get_mut(usize::from($item)).map($crate::sdo::Kept::slot)
    };
    (list $field:expr, $item:expr) => {
        match $item {
            0 => ::core::option::Option::Some($crate::sdo::Slot::U8(&mut $field.count)),
            item => $field.item(item).map($crate::sdo::Kept::slot),
        }
    };
    (record $field:expr, $item:expr) => {
        $field.field($item)
    };
}
