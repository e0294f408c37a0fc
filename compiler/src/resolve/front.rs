//! What a person does.

use super::context::Context;
use super::writes;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Object, Procedure, Step};
use crate::raw::{RawProcedure, RawStep};
use crate::source::Origin;

/// Things to do in order.
pub(super) fn procedures(
    context: &mut Context<'_>,
    raw: Vec<RawProcedure>,
    objects: &[Object],
) -> Vec<Procedure> {
    let procedures = raw.into_iter().map(|RawProcedure { key: id, name, about, steps, source, origin }| {
        let steps = steps.into_iter().enumerate();
        let steps =
            steps.map(|(i, raw)| step(context, raw, &origin, &format!("steps.{i}"), objects)).collect();
        Procedure { id, name, about, steps, source, origin }
    });
    procedures.collect()
}

fn step(context: &mut Context<'_>, raw: RawStep, origin: &Origin, path: &str, objects: &[Object]) -> Step {
    let RawStep { r#do: text, object, write } = raw;
    let at = |key: &str| origin.value(&format!("{path}.{key}"));
    if write.is_some() && object.is_none() {
        let message = "a step writes a value, but to no object".to_owned();
        let fault = Diagnostic::new(&faults::MISSING_KEY, message, at("write"), "written to nothing");
        context.diagnostics.push(fault.help("name the entry as `object`"));
    }
    let entry = object.and_then(|object| writes::target(context, &object, objects, at("object")));
    let write =
        entry.zip(write).and_then(|(entry, value)| writes::value(context, &value, entry, at("write")));
    Step { text, address: entry.map(|entry| entry.address), write }
}
