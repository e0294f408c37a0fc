//! What a person does.

use super::context::Context;
use crate::model::{Procedure, Step};
use crate::raw::{RawProcedure, RawStep};
use crate::source::Origin;

/// Things to do in order.
pub(super) fn procedures(context: &mut Context<'_>, raw: Vec<RawProcedure>) -> Vec<Procedure> {
    let procedures = raw.into_iter().map(|RawProcedure { key: id, name, about, steps, source, origin }| {
        let steps = self::steps(context, steps, &origin);
        Procedure { id, name, about, steps, source, origin }
    });
    procedures.collect()
}

fn steps(context: &mut Context<'_>, raw: Vec<RawStep>, origin: &Origin) -> Vec<Step> {
    let steps = raw.into_iter().enumerate().map(|(i, RawStep { r#do: text, object, write })| {
        let at = origin.value(&format!("steps.{i}.object"));
        let address = object.and_then(|object| context.address(&object, at));
        Step { text, address, write }
    });
    steps.collect()
}
