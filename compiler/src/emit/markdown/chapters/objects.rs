//! The object dictionary: a table for each area, and what a table cannot hold below it.

mod area;
mod detail;
mod facts;
mod kinds;
mod marks;
mod overview;
mod per_axis;

use detail::Detail;
pub(super) use detail::of_mapping;

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{small, text};
use crate::emit::markdown::page::Page;
use crate::model::{Area, Object, Source};

/// The object dictionary, area by area.
pub(super) fn page(context: &Context<'_>, areas: &[Area]) -> Page {
    let mut page = Page::default();
    area::areas(context, areas).iter().for_each(|area| self::area(context, area, &mut page));
    page
}

fn area(context: &Context<'_>, area: &area::Contents<'_>, page: &mut Page) {
    let common = area.common_source();
    let mut lines = overview::Lines::new(context, &area.objects);
    let (mut brief, mut full) = (Vec::new(), Page::default());
    for object in &area.objects {
        let detail = detail::detail(context, object, common);
        lines.object(object, detail.is_some());
        match detail {
            Some(Detail::Brief(line)) => brief.push(line),
            Some(Detail::Full(object)) => full.append(object),
            None => {}
        }
    }
    page.place(3, format!("area-{:04x}", area.first), text(area.name));
    if let Some(described) = area.described {
        page.text(context.paragraphs(described.about.as_deref()));
        page.text(context.departures_line(described.source.as_ref(), &described.origin));
    }
    let legend = lines.legend();
    page.table(lines.table);
    page.text(legend);
    common.iter().for_each(|common| page.text(source_line(context, common)));
    let on_axes = per_axis::indices(context, &area.objects);
    if !on_axes.is_empty() {
        page.text("Each axis has its own:");
        page.table(on_axes);
    }
    page.list(brief);
    page.append(full);
}

/// Where the objects of an area are from that name nothing else.
fn source_line(context: &Context<'_>, common: &Source) -> String {
    small(&format!("Source: {}, unless an object says otherwise", context.place(Some(common))))
}

/// Whether an object is the mapping of a PDO, which the chapter of process data shows.
fn is_mapping(context: &Context<'_>, object: &Object) -> bool {
    context.device.pdo(object.index).is_some()
}
