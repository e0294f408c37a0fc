//! What a person sets, in the device and in the master, and in which order.

use serde::Serialize;

use crate::emit::markdown::chapter::{Chapter, Section};
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, fragment, sentence, text};
use crate::emit::markdown::table::Table;
use crate::model::{MasterSetting, Parameter, Procedure, Step, Value, ValueRange};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    master_settings: Table,
    parameters: Table,
    procedures: Vec<ProcedureView>,
}

#[derive(Serialize)]
struct ProcedureView {
    anchor: String,
    name: String,
    about: String,
    steps: Vec<String>,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = (&'d [MasterSetting], &'d [Parameter], &'d [Procedure]);

    const ID: &'static str = "service";
    const TITLE: &'static str = "Settings and procedures";
    const TEMPLATE: &'static str = include_str!("../templates/service.md.j2");

    fn view(context: &Context<'_>, (settings, parameters, procedures): Self::Parts<'_>) -> Option<Self> {
        let view = Self {
            master_settings: master_settings(context, settings),
            parameters: parameter_table(context, parameters),
            procedures: procedures.iter().map(|procedure| procedure_view(context, procedure)).collect(),
        };
        let empty =
            view.master_settings.is_empty() && view.parameters.is_empty() && view.procedures.is_empty();
        (!empty).then_some(view)
    }

    fn sections(&self) -> Vec<Section> {
        let section = |one: &ProcedureView| Section { title: one.name.clone(), anchor: one.anchor.clone() };
        self.procedures.iter().map(section).collect()
    }
}

fn master_settings(context: &Context<'_>, settings: &[MasterSetting]) -> Table {
    let titles = ["Setting", "Value", "For", "Why", "Source"];
    Table::of(titles, settings, |setting| {
        [
            format!("**{}**", text(&setting.name)),
            context.prose(&setting.value),
            if setting.per_axis { "each axis".into() } else { String::new() },
            context.optional(setting.about.as_deref()),
            context.said(setting.source.as_ref(), &setting.origin),
        ]
    })
}

fn parameter_table(context: &Context<'_>, parameters: &[Parameter]) -> Table {
    let titles = ["Parameter", "Name", "Object", "On delivery", "Range", "Unit", "What it does", "Source"];
    Table::of(titles, parameters, |parameter| {
        let Parameter { id, name, address, about, default, min, max, symbol, values, source, origin } =
            parameter;
        [
            code(id),
            format!("**{}**", text(name)),
            address.map_or(String::new(), |address| context.exact(address)),
            default.as_ref().map_or(String::new(), code),
            range(min.as_ref(), max.as_ref()),
            symbol.as_deref().map_or(String::new(), text),
            effect(context, about.as_deref(), values),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn range(min: Option<&Value>, max: Option<&Value>) -> String {
    match (min, max) {
        (Some(min), Some(max)) => format!("{} to {}", code(min), code(max)),
        (Some(min), None) => format!("{} or more", code(min)),
        (None, Some(max)) => format!("up to {}", code(max)),
        (None, None) => String::new(),
    }
}

fn effect(context: &Context<'_>, about: Option<&str>, values: &[ValueRange]) -> String {
    let about = about.iter().map(|about| context.prose(about));
    let values = values.iter().map(|range| range_meaning(context, range));
    about.chain(values).collect::<Vec<_>>().join("<br>")
}

/// A value, or a range of values, with what it means.
fn range_meaning(context: &Context<'_>, range: &ValueRange) -> String {
    let about = range.about.as_ref().map_or(String::new(), |about| format!(": {}", context.prose(about)));
    let numbers = if range.first == range.last {
        code(range.first)
    } else {
        format!("{} to {}", code(range.first), code(range.last))
    };
    format!("{numbers} {}{about}", text(&range.name))
}

fn procedure_view(context: &Context<'_>, procedure: &Procedure) -> ProcedureView {
    ProcedureView {
        anchor: fragment(format!("procedure-{}", procedure.id)),
        name: text(&procedure.name),
        about: context.paragraphs(procedure.about.as_deref()),
        steps: procedure.steps.iter().map(|one| step(context, one)).collect(),
        source: context.said_line(procedure.source.as_ref(), &procedure.origin),
    }
}

fn step(context: &Context<'_>, step: &Step) -> String {
    let text = sentence(&context.prose(&step.text));
    let place = step.address.map(|address| context.named(address));
    match (place, &step.write) {
        (Some(place), Some(value)) => format!("{text} Write {} to {place}.", code(value)),
        (Some(place), None) => format!("{text} See {place}."),
        (None, Some(value)) => format!("{text} Write {}.", code(value)),
        (None, None) => text,
    }
}
