//! Literals in the type they are for.

use super::context::Context;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{DataType, Hex, Literal, Value};
use crate::source::{Location, keys};

/// The value that a literal is in a type, or a report that it does not fit; with where it stands, and where the type does.
pub(super) fn value(
    context: &mut Context<'_>,
    literal: &Literal,
    data_type: DataType,
    [at, of_type]: [Location; 2],
) -> Option<Value> {
    let value = match literal {
        Literal::Text(text)
            if !matches!(data_type, DataType::Text(_) | DataType::Unicode(_) | DataType::Octets(_)) =>
        {
            Literal::twice(text).and_then(|(first, _)| fit(&Literal::Integer(first), data_type))
        }
        _ => fit(literal, data_type),
    };
    if value.is_none() {
        let message = format!("{} does not fit {data_type}", shown(literal));
        let fault = Diagnostic::new(&faults::UNFIT_VALUE, message, at, holds(data_type));
        let fault = fault.label(of_type, "the type");
        context.diagnostics.push(match meant(literal, data_type) {
            Some(Meant::Unquoted(number)) => fault.fix("a number has no quotes", at, number),
            Some(Meant::Signed(number)) => {
                let text = format!("the bits of {} are {number} as {data_type}", shown(literal));
                fault.suggest(text, at, number.to_string())
            }
            None => fault,
        });
    }
    value
}

/// What someone may have meant by a literal that does not fit.
enum Meant<'t> {
    /// The number in the text.
    Unquoted(&'t str),
    /// The number whose bits were written without a sign.
    Signed(i128),
}

fn meant(literal: &Literal, data_type: DataType) -> Option<Meant<'_>> {
    match (literal, data_type) {
        (Literal::Text(text), _) => {
            let number = keys::number(text.trim())?;
            fit(&Literal::Integer(number.into()), data_type).map(|_| Meant::Unquoted(text.trim()))
        }
        (Literal::Integer(value), DataType::Int(bits)) => {
            let signed = value.checked_sub(1_i128 << bits)?;
            let (min, _) = data_type.range()?;
            (min..0).contains(&signed).then_some(Meant::Signed(signed))
        }
        _ => None,
    }
}

fn fit(literal: &Literal, data_type: DataType) -> Option<Value> {
    match (literal, data_type) {
        (Literal::Boolean(value), DataType::Bool) => Some(Value::Boolean(*value)),
        (Literal::Text(text), DataType::Text(bytes)) => {
            (text.len() <= usize::from(bytes)).then(|| Value::Text(text.clone()))
        }
        (Literal::Text(text), DataType::Unicode(units)) => {
            (text.encode_utf16().count() <= usize::from(units)).then(|| Value::Text(text.clone()))
        }
        (Literal::Text(text), DataType::Octets(bytes)) => {
            let value = Hex::parse(text).filter(|value| value.0.len() <= usize::from(bytes));
            value.map(|value| Value::Text(value.to_string()))
        }
        (Literal::Float(value), DataType::Real32 | DataType::Real64) => real(*value, data_type),
        (Literal::Integer(value), DataType::Real32 | DataType::Real64) => real(*value as f64, data_type),
        (Literal::Integer(value), _) => {
            let (min, max) = data_type.range()?;
            let within = (min..=max).contains(value);
            within
                .then(|| i64::try_from(*value).map(Value::Integer).ok())
                .flatten()
                .or_else(|| within.then(|| u64::try_from(*value).map(Value::Unsigned).ok()).flatten())
        }
        _ => None,
    }
}

/// A number with a fraction, if the type reaches as far.
fn real(value: f64, data_type: DataType) -> Option<Value> {
    let greatest = if data_type == DataType::Real32 { f32::MAX.into() } else { f64::MAX };
    (value.abs() <= greatest).then_some(Value::Real(value))
}

fn shown(literal: &Literal) -> String {
    match literal {
        Literal::Boolean(value) => format!("`{value}`"),
        Literal::Integer(value) => value.to_string(),
        Literal::Float(value) => value.to_string(),
        Literal::Text(text) => format!("{text:?}"),
    }
}

fn holds(data_type: DataType) -> String {
    match (data_type.range(), data_type) {
        (Some((min, max)), _) => format!("{data_type} holds {min} to {max}"),
        (None, DataType::Real32) => format!("{data_type} holds numbers up to {:e}", f32::MAX),
        (None, DataType::Text(bytes)) => format!("{data_type} holds text of up to {bytes} bytes"),
        (None, DataType::Unicode(units)) => format!("{data_type} holds text of up to {units} units"),
        (None, DataType::Octets(bytes)) => {
            format!("{data_type} holds up to {bytes} bytes, two hexadecimal digits each: \"0A1B\"")
        }
        (None, DataType::Array(..)) => {
            format!("{data_type} holds bytes, of which no value can be told")
        }
        (None, _) => format!("{data_type} holds numbers"),
    }
}

/// The length of a text type that is written without one.
pub(super) fn text_length(default: Option<&Literal>) -> u16 {
    match default {
        Some(Literal::Text(text)) => u16::try_from(text.len()).unwrap_or(u16::MAX).max(1),
        _ => 1,
    }
}
