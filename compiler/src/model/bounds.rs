//! Between which values an entry is written.

use super::{DataType, Entry, Value};

/// The least and the greatest value that a master may write.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bounds {
    /// Of a whole number with a sign.
    Signed(i128, i128),
    /// Of a whole number without.
    Unsigned(i128, i128),
    /// Of a number with a fraction; infinite where there is none.
    Real(f64, f64),
}

impl Entry {
    /// The bounds that a firmware has to check; of a whole number, where one is missing, the type's own. A type of a few
    /// bits always has some, as it comes in a byte.
    pub fn bounds(&self) -> Option<Bounds> {
        let (min, max) = (self.min.as_ref(), self.max.as_ref());
        let is_part = matches!(self.data_type, DataType::Bits(2..8));
        if min.is_none() && max.is_none() && !is_part {
            return None;
        }
        let whole = |value: Option<&Value>, otherwise| value.and_then(Value::integer).unwrap_or(otherwise);
        match (self.data_type, self.data_type.range()) {
            (DataType::Int(_), Some((least, most))) => {
                Some(Bounds::Signed(whole(min, least), whole(max, most)))
            }
            (_, Some((least, most))) => Some(Bounds::Unsigned(whole(min, least), whole(max, most))),
            (DataType::Real32 | DataType::Real64, None) => {
                let real =
                    |value: Option<&Value>, otherwise| value.and_then(Value::real).unwrap_or(otherwise);
                Some(Bounds::Real(real(min, f64::NEG_INFINITY), real(max, f64::INFINITY)))
            }
            (_, None) => None,
        }
    }
}
