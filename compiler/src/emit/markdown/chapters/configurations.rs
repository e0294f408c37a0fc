//! Choices of process data and mode, with what a master writes to bring them about.

use serde::Serialize;

use super::process_data::layout;
use crate::emit::markdown::chapter::{Chapter, Section};
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, fragment, list, text};
use crate::emit::markdown::number::{duration, width};
use crate::emit::markdown::table::Table;
use crate::model::{Configuration, Index, Pdo};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    configurations: Vec<ConfigurationView>,
}

#[derive(Serialize)]
struct ConfigurationView {
    anchor: String,
    name: String,
    about: String,
    facts: Vec<String>,
    mapping: Vec<MappingView>,
    startup: Table,
    source: String,
}

/// A PDO as it is mapped anew.
#[derive(Serialize)]
struct MappingView {
    title: String,
    layout: Table,
}

impl Chapter for View {
    type Parts<'d> = &'d [Configuration];

    const ID: &'static str = "configurations";
    const TITLE: &'static str = "Start-up configurations";
    const TEMPLATE: &'static str = include_str!("../templates/configurations.md.j2");

    fn view(context: &Context<'_>, configurations: Self::Parts<'_>) -> Option<Self> {
        let configurations: Vec<ConfigurationView> =
            configurations.iter().map(|one| configuration(context, one)).collect();
        (!configurations.is_empty()).then_some(Self { configurations })
    }

    fn sections(&self) -> Vec<Section> {
        let section =
            |one: &ConfigurationView| Section { title: one.name.clone(), anchor: one.anchor.clone() };
        self.configurations.iter().map(section).collect()
    }
}

fn configuration(context: &Context<'_>, configuration: &Configuration) -> ConfigurationView {
    let Configuration {
        id,
        name,
        mapping,
        about,
        source,
        outputs: _,
        inputs: _,
        mode: _,
        cycle_time: _,
        startup: _,
        origin,
    } = configuration;
    ConfigurationView {
        anchor: fragment(format!("configuration-{id}")),
        name: text(name),
        about: context.paragraphs(about.as_deref()),
        facts: facts(context, configuration),
        mapping: mapping.iter().map(|pdo| self::mapping(context, pdo)).collect(),
        startup: startup(context, configuration),
        source: context.said_line(source.as_ref(), origin),
    }
}

fn facts(context: &Context<'_>, configuration: &Configuration) -> Vec<String> {
    let pdos = |title: &str, pdos: &Option<Vec<Index>>| {
        pdos.as_ref().map(|pdos| match pdos.as_slice() {
            [] => format!("{title}: none"),
            pdos => format!("{title}: {}", list(pdos.iter().map(|pdo| context.index(*pdo)))),
        })
    };
    let facts = [
        configuration.mode.map(|mode| format!("Mode: {}", context.mode(mode))),
        configuration.cycle_time.map(|time| format!("Cycle time: {}", duration(time.0))),
        pdos("Outputs", &configuration.outputs),
        pdos("Inputs", &configuration.inputs),
    ];
    facts.into_iter().flatten().collect()
}

fn mapping(context: &Context<'_>, pdo: &Pdo) -> MappingView {
    let title =
        format!("{} {}, mapped anew to {}:", context.index(pdo.index), text(&pdo.name), width(pdo.bits()));
    MappingView { title, layout: layout(context, pdo) }
}

fn startup(context: &Context<'_>, configuration: &Configuration) -> Table {
    let titles = ["No.", "During", "Object", "Bytes in order", "What for"];
    Table::of(titles, configuration.startup.iter().zip(1..), |(write, number)| {
        let bytes: Vec<String> = write.data.iter().map(|byte| format!("{byte:02X}")).collect();
        [
            number.to_string(),
            code(&write.transition),
            context.exact(write.address),
            code(bytes.join(" ")),
            context.prose(&write.comment),
        ]
    })
}
