//! Literals in the type they are for.

use super::context::Context;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{DataType, Literal, Value};
use crate::source::Origin;

/// The value that a literal is in a type, or a report that it does not fit.
pub(super) fn value(
    context: &mut Context<'_>,
    literal: &Literal,
    data_type: DataType,
    path: &str,
    origin: &Origin,
) -> Option<Value> {
    let value = match literal {
        Literal::Text(text) if !matches!(data_type, DataType::Text(_)) => {
            Literal::twice(text).and_then(|(first, _)| fit(&Literal::Integer(first), data_type))
        }
        _ => fit(literal, data_type),
    };
    if value.is_none() {
        let message = format!("{} does not fit {data_type}", shown(literal));
        let fault = Diagnostic::new(&faults::UNFIT_VALUE, message, origin.value(path), holds(data_type));
        context.diagnostics.push(fault.label(origin.value("type"), "the type"));
    }
    value
}

fn fit(literal: &Literal, data_type: DataType) -> Option<Value> {
    match (literal, data_type) {
        (Literal::Boolean(value), DataType::Bool) => Some(Value::Boolean(*value)),
        (Literal::Text(text), DataType::Text(bytes)) => {
            (text.len() <= usize::from(bytes)).then(|| Value::Text(text.clone()))
        }
        (Literal::Float(value), DataType::Real32 | DataType::Real64) => Some(Value::Real(*value)),
        (Literal::Integer(value), DataType::Real32 | DataType::Real64) => Some(Value::Real(*value as f64)),
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
        (None, DataType::Text(bytes)) => format!("{data_type} holds text of up to {bytes} bytes"),
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
