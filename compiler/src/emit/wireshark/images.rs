//! What is assigned: by default, and by each configuration.

use serde::Serialize;

use crate::emit::program::{Image, Pdo, Program, Selection};

/// The PDOs of both directions, by index.
#[derive(Debug, Clone, Default, Serialize)]
pub(super) struct Assigned {
    outputs: Vec<u16>,
    inputs: Vec<u16>,
}

/// What a configuration chooses.
#[derive(Debug, Serialize)]
pub(super) struct Chosen<'p> {
    title: &'p str,
    #[serde(flatten)]
    assigned: Assigned,
    pdos: &'p [Pdo],
}

/// What sync managers carry by default.
pub(super) fn by_default(program: &Program) -> Assigned {
    program.selections.first().map(|first| over(&Assigned::default(), first)).unwrap_or_default()
}

/// The configurations that choose process data.
pub(super) fn configurations(program: &Program) -> Vec<Chosen<'_>> {
    let by_default = by_default(program);
    let chosen = program.selections.iter().filter_map(|selection| {
        let title = selection.configuration.as_deref()?;
        Some(Chosen { title, assigned: over(&by_default, selection), pdos: &selection.pdos })
    });
    chosen.collect()
}

/// What a selection has, and for a direction that it has not, what was before.
fn over(before: &Assigned, selection: &Selection) -> Assigned {
    let image = |is_output| selection.images.iter().find(|image| image.is_output == is_output);
    let indices = |image: &Image| image.parts.iter().map(|part| part.pdo.index).collect();
    Assigned {
        outputs: image(true).map_or(before.outputs.clone(), indices),
        inputs: image(false).map_or(before.inputs.clone(), indices),
    }
}
