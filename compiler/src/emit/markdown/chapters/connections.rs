//! Sockets and lights.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::text;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::picture;
use crate::emit::markdown::table::Table;
use crate::model::{Connector, Led};

/// Sockets, and what lights show.
pub(super) fn page(context: &Context<'_>, connectors: &[Connector], leds: &[Led]) -> Page {
    let mut page = Page::default();
    page.table(sockets(context, connectors));
    page.table(lights(context, leds));
    if leds.iter().any(|led| !led.patterns.is_empty()) {
        context.picture(&mut page, || picture::lights(leds));
    }
    page
}

fn sockets(context: &Context<'_>, connectors: &[Connector]) -> Table {
    Table::of(["Socket", "Kind", "Use", "Source"], connectors, |connector| {
        [
            format!("**{}**", text(&connector.name)),
            context.optional(connector.kind.as_deref()),
            context.optional(connector.about.as_deref()),
            context.said(connector.source.as_ref(), &connector.origin),
        ]
    })
}

/// A row for each light, then one for each of its patterns.
fn lights(context: &Context<'_>, leds: &[Led]) -> Table {
    let mut table = Table::new(["Light", "Colour", "Shows", "Meaning", "Source"]);
    for led in leds {
        let source = context.said(led.source.as_ref(), &led.origin);
        let about = context.optional(led.about.as_deref());
        let row = |name: [String; 2], shows: String, means: String| {
            name.into_iter().chain([shows, means, source.clone()])
        };
        table.row(row(name(led), String::new(), about));
        for pattern in &led.patterns {
            table.row(row(Default::default(), context.prose(&pattern.shows), context.prose(&pattern.means)));
        }
    }
    table
}

fn name(led: &Led) -> [String; 2] {
    [format!("**{}**", text(&led.name)), led.colour.as_deref().map_or(String::new(), text)]
}
