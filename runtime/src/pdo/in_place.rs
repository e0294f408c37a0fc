//! Process data where it lies.

use super::ProcessData;
use crate::bytes::{ByteArray, WrongLength};

/// Process data whose fields can be read and written where they lie in the frame, without a copy.
///
/// A view is the bytes themselves, owned or borrowed, with a method for each field. [`view!`](crate::view) makes it.
///
/// ```
/// use devc_runtime::pdo::{InPlace, Rx};
/// # use devc_runtime::Device;
/// # #[derive(Debug, Clone, Copy)]
/// # pub struct C887;
/// # impl Device for C887 {
/// #     const NAME: &'static str = "C-887.53x";
/// #     const VENDOR_ID: u32 = 0x076D;
/// #     const PRODUCT_CODE: u32 = 3;
/// #     const REVISION: u32 = 0;
/// # }
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// pub struct Target {
///     pub controlword: u16,
///     pub position: i32,
/// }
/// # impl Target {
/// #     pub const fn pack(self) -> [u8; 6] {
/// #         let [c0, c1] = self.controlword.to_le_bytes();
/// #         let [p0, p1, p2, p3] = self.position.to_le_bytes();
/// #         [c0, c1, p0, p1, p2, p3]
/// #     }
/// #     pub const fn unpack([c0, c1, p0, p1, p2, p3]: [u8; 6]) -> Self {
/// #         Self { controlword: u16::from_le_bytes([c0, c1]), position: i32::from_le_bytes([p0, p1, p2, p3]) }
/// #     }
/// # }
/// devc_runtime::process_data!(Target: C887, Rx, 6);
/// devc_runtime::view! {
///     pub TargetView of Target, 6;
///     controlword, set_controlword: u16 => 0, 16;
///     position, set_position: i32 => 16, 32;
/// }
///
/// let mut frame = [0; 6];
/// let mut target = TargetView(&mut frame);
/// target.set_position(-1);
/// assert_eq!((target.controlword(), target.position()), (0, -1));
/// assert_eq!(frame, [0, 0, 0xFF, 0xFF, 0xFF, 0xFF]);
/// assert_eq!(Target::view_of(&frame)?.position(), -1);
/// assert!(Target::view_of(&frame[1..]).is_err());
/// # Ok::<(), devc_runtime::bytes::WrongLength>(())
/// ```
pub trait InPlace: ProcessData {
    /// The bytes `B` with the fields as methods: to read if they can be borrowed, to write if they can be borrowed
    /// mutably.
    type View<B>;

    /// The view of the bytes: of `&Self::Image`, of `&mut Self::Image`, or of `Self::Image` itself.
    fn view<B>(bytes: B) -> Self::View<B>;

    /// The view of the part of a frame that belongs to this data; it has to be just as long.
    #[inline]
    fn view_of(frame: &[u8]) -> Result<View<'_, Self>, WrongLength> {
        Self::Image::from_slice(frame).map(Self::view)
    }

    /// The same to write to.
    #[inline]
    fn view_of_mut(frame: &mut [u8]) -> Result<ViewMut<'_, Self>, WrongLength> {
        Self::Image::from_slice_mut(frame).map(Self::view)
    }
}

/// The view to read process data in a frame.
pub type View<'a, P> = <P as InPlace>::View<&'a <P as ProcessData>::Image>;

/// The view to read and write process data in a frame.
pub type ViewMut<'a, P> = <P as InPlace>::View<&'a mut <P as ProcessData>::Image>;

/// Makes the view of process data and [`InPlace`](crate::pdo::InPlace) for it: visibility and name of the view, the
/// data and its bytes, then for each field how it is read, how it is written, its type, its first bit and its bits.
///
/// The data can have whole PDOs as fields, as an image has: then there are the views of these to read and to write,
/// the PDO's type and its first byte. Where there is an array of PDOs, of which each has a name, there is one of views.
#[macro_export]
macro_rules! view {
    (
        $visibility:vis $view:ident of $data:ident, $length:expr;
        $($get:ident, $set:ident: $type:ty => $offset:expr, $bits:expr;)*
    ) => {
        $crate::view!(@struct $visibility $view of $data);

        impl<B: ::core::borrow::Borrow<[u8; $length]>> $view<B> {
            $(
                #[doc = ::core::concat!("[`", ::core::stringify!($data), "::", ::core::stringify!($get), "`]")]
                #[inline]
                pub fn $get(&self) -> $type {
                    let image = ::core::borrow::Borrow::<[u8; $length]>::borrow(&self.0);
                    $crate::pdo::place::load::<$type, { $offset }, { $bits }, { $length }>(image)
                }
            )*
        }

        impl<B: ::core::borrow::BorrowMut<[u8; $length]>> $view<B> {
            $(
                #[doc = ::core::concat!("Sets [`", ::core::stringify!($data), "::", ::core::stringify!($get), "`].")]
                #[inline]
                pub fn $set(&mut self, value: $type) {
                    let image = ::core::borrow::BorrowMut::<[u8; $length]>::borrow_mut(&mut self.0);
                    $crate::pdo::place::store::<$type, { $offset }, { $bits }, { $length }>(image, value);
                }
            )*
        }
    };
    (
        $visibility:vis $view:ident of PDOs in $data:ident, $length:expr;
        $($get:ident, $get_mut:ident: $part:tt => $offset:expr;)*
    ) => {
        $crate::view!(@struct $visibility $view of $data);

        impl<B: ::core::borrow::Borrow<[u8; $length]>> $view<B> {
            $($crate::view!(@part $data, $get: $part => $offset, $length);)*
        }

        impl<B: ::core::borrow::BorrowMut<[u8; $length]>> $view<B> {
            $($crate::view!(@part_mut $data, $get, $get_mut: $part => $offset, $length);)*
        }
    };
    (@part $data:ident, $get:ident: [$pdo:ty; $($axis:ident),+] => $offset:expr, $length:expr) => {
        #[doc = ::core::concat!("[`", ::core::stringify!($data), "::", ::core::stringify!($get), "`]")]
        #[inline]
        pub fn $get(&self) -> [$crate::pdo::View<'_, $pdo>; { $crate::view!(@count $($axis)+) }] {
            let image = ::core::borrow::Borrow::<[u8; $length]>::borrow(&self.0);
            let [$($axis),+] = $crate::pdo::place::row::<
                { <$pdo as $crate::pdo::ProcessData>::LEN }, { $crate::view!(@count $($axis)+) }, { $offset }, { $length },
            >(image);
            [$(<$pdo as $crate::pdo::InPlace>::view($axis)),+]
        }
    };
    (@part $data:ident, $get:ident: $pdo:ty => $offset:expr, $length:expr) => {
        #[doc = ::core::concat!("[`", ::core::stringify!($data), "::", ::core::stringify!($get), "`]")]
        #[inline]
        pub fn $get(&self) -> $crate::pdo::View<'_, $pdo> {
            let image = ::core::borrow::Borrow::<[u8; $length]>::borrow(&self.0);
            <$pdo as $crate::pdo::InPlace>::view($crate::pdo::place::part::<_, { $offset }, { $length }>(image))
        }
    };
    (@part_mut $data:ident, $get:ident, $get_mut:ident: [$pdo:ty; $($axis:ident),+] => $offset:expr, $length:expr) => {
        #[doc = ::core::concat!("[`", ::core::stringify!($data), "::", ::core::stringify!($get), "`], to write to.")]
        #[inline]
        pub fn $get_mut(
            &mut self,
        ) -> [$crate::pdo::ViewMut<'_, $pdo>; { $crate::view!(@count $($axis)+) }] {
            let image = ::core::borrow::BorrowMut::<[u8; $length]>::borrow_mut(&mut self.0);
            let [$($axis),+] = $crate::pdo::place::row_mut::<
                { <$pdo as $crate::pdo::ProcessData>::LEN }, { $crate::view!(@count $($axis)+) }, { $offset }, { $length },
            >(image);
            [$(<$pdo as $crate::pdo::InPlace>::view($axis)),+]
        }
    };
    (@part_mut $data:ident, $get:ident, $get_mut:ident: $pdo:ty => $offset:expr, $length:expr) => {
        #[doc = ::core::concat!("[`", ::core::stringify!($data), "::", ::core::stringify!($get), "`], to write to.")]
        #[inline]
        pub fn $get_mut(
            &mut self,
        ) -> $crate::pdo::ViewMut<'_, $pdo> {
            let image = ::core::borrow::BorrowMut::<[u8; $length]>::borrow_mut(&mut self.0);
            let part = $crate::pdo::place::part_mut::<_, { $offset }, { $length }>(image);
            <$pdo as $crate::pdo::InPlace>::view(part)
        }
    };
    (@count $($axis:ident)+) => {
        [$(::core::stringify!($axis)),+].len()
    };
    (@struct $visibility:vis $view:ident of $data:ident) => {
        #[doc = ::core::concat!("[`", ::core::stringify!($data), "`] where it lies, read and written in place.")]
        #[derive(Debug, Clone, Copy)]
        $visibility struct $view<B>(
            /// The bytes.
            pub B,
        );

        impl $crate::pdo::InPlace for $data {
            type View<B> = $view<B>;

            #[inline]
            fn view<B>(bytes: B) -> $view<B> {
                $view(bytes)
            }
        }
    };
}
