//! The object dictionary: a table for each area, and what a table cannot hold below it.

mod area;
mod detail;
mod marks;
mod overview;
mod per_axis;

use serde::Serialize;

use detail::{Detail, ObjectView};

use crate::emit::markdown::chapter::{Chapter, Section};
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{small, text};
use crate::emit::markdown::table::Table;
use crate::model::{Area, Object, Source};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    areas: Vec<AreaView>,
}

#[derive(Serialize)]
struct AreaView {
    anchor: String,
    title: String,
    about: String,
    source: String,
    objects: Table,
    legend: String,
    on_axes: Table,
    brief: Vec<String>,
    full: Vec<ObjectView>,
}

impl Chapter for View {
    type Parts<'d> = (&'d [Area], &'d [Object]);

    const ID: &'static str = "objects";
    const TITLE: &'static str = "Object dictionary";
    const TEMPLATE: &'static str = include_str!("../templates/objects.md.j2");

    fn view(context: &Context<'_>, (areas, objects): Self::Parts<'_>) -> Option<Self> {
        let areas: Vec<AreaView> =
            area::areas(context, areas).into_iter().map(|area| area_view(context, &area)).collect();
        (!objects.is_empty()).then_some(Self { areas })
    }

    fn sections(&self) -> Vec<Section> {
        let section = |area: &AreaView| Section { title: area.title.clone(), anchor: area.anchor.clone() };
        self.areas.iter().map(section).collect()
    }
}

fn area_view(context: &Context<'_>, area: &area::Contents<'_>) -> AreaView {
    let common = area.common_source();
    let mut view = AreaView {
        anchor: format!("area-{:04x}", area.first),
        title: text(area.name),
        about: context.paragraphs(area.about),
        source: common.map_or(String::new(), |common| source_line(context, common)),
        objects: Table::default(),
        legend: String::new(),
        on_axes: per_axis::indices(context, &area.objects),
        brief: Vec::new(),
        full: Vec::new(),
    };
    let mut lines = overview::Lines::new(context, &area.objects);
    for object in &area.objects {
        let detail = detail::detail(context, object, common);
        lines.object(object, detail.is_some());
        match detail {
            Some(Detail::Brief(line)) => view.brief.push(line),
            Some(Detail::Full(object)) => view.full.push(object),
            None => {}
        }
    }
    view.legend = lines.legend();
    view.objects = lines.table;
    view
}

/// Where the objects of an area are from that name nothing else.
fn source_line(context: &Context<'_>, common: &Source) -> String {
    small(&format!("Source: {}, unless an object says otherwise", context.place(Some(common))))
}

/// Whether an object is the mapping of a PDO, which the chapter of process data shows.
fn is_mapping(context: &Context<'_>, object: &Object) -> bool {
    context.device.pdo(object.index).is_some()
}
