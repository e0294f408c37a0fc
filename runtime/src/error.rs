//! What a device says when something is wrong (CiA 301, emergency object; CiA 402, error code 0x603F).

use core::fmt;

/// What a device's description says about an error code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ErrorInfo {
    /// The code in 0x603F and in the emergency message.
    pub code: u16,
    /// The name of the error.
    pub name: &'static str,
    /// What the error register 0x1001 shows with it, if the manual says so.
    pub register: Option<u8>,
    /// The vendor's own numbers of errors that are shown as this one.
    pub vendor_codes: &'static [u32],
    /// What it means and what to do; empty where the manual has nothing to say.
    pub text: &'static str,
}

/// Codes that the description gives to someone, without naming each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ErrorRange {
    /// The first code.
    pub first: u16,
    /// The last code.
    pub last: u16,
    /// What the codes are for.
    pub name: &'static str,
}

/// The error code of a device: a newtype over `u16` in the generated module, with a constant for each named code.
///
/// Any number is a code; those that the description does not name keep their value.
///
/// ```
/// use devc_runtime::error::{ErrorCode, ErrorInfo, display};
///
/// #[derive(Clone, Copy)]
/// struct Code(u16);
///
/// impl ErrorCode for Code {
///     const TABLE: &'static [ErrorInfo] = &[ErrorInfo {
///         code: 0x7121,
///         name: "motor blocked",
///         register: Some(0x81),
///         vendor_codes: &[657],
///         text: "safety stop, a motor is stuck",
///     }];
///     fn code(self) -> u16 { self.0 }
/// }
///
/// assert_eq!(display(Code(0x7121)).to_string(), "0x7121: motor blocked");
/// assert_eq!(display(Code(0x1234)).to_string(), "0x1234: unknown error");
/// ```
pub trait ErrorCode: Copy {
    /// The codes that the description names, ascending.
    const TABLE: &'static [ErrorInfo];

    /// Ranges of codes; a code that is in the table is looked up there.
    const RANGES: &'static [ErrorRange] = &[];

    /// The number on the wire.
    fn code(self) -> u16;

    /// What the description says about the code, if it names it.
    fn info(self) -> Option<&'static ErrorInfo> {
        let position = Self::TABLE.binary_search_by_key(&self.code(), |info| info.code).ok()?;
        Self::TABLE.get(position)
    }

    /// The name of the code or of the range that it is in.
    fn name(self) -> Option<&'static str> {
        let range = || Self::RANGES.iter().find(|range| (range.first..=range.last).contains(&self.code()));
        self.info().map(|info| info.name).or_else(|| range().map(|range| range.name))
    }
}

/// The code and its name, for people.
pub fn display(error: impl ErrorCode) -> impl fmt::Display {
    Shown { code: error.code(), name: error.name() }
}

struct Shown {
    code: u16,
    name: Option<&'static str>,
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:04X}: {}", self.code, self.name.unwrap_or("unknown error"))
    }
}
