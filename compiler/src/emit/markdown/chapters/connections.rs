//! Sockets and lights.

use serde::Serialize;

use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::text;
use crate::emit::markdown::table::Table;
use crate::model::{Connector, Led};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    connectors: Table,
    lights: Table,
}

impl Chapter for View {
    type Parts<'d> = (&'d [Connector], &'d [Led]);

    const ID: &'static str = "connections";
    const TITLE: &'static str = "Connections and lights";
    const TEMPLATE: &'static str = include_str!("../templates/connections.md.j2");

    fn view(context: &Context<'_>, (connectors, leds): Self::Parts<'_>) -> Option<Self> {
        let shown = !connectors.is_empty() || !leds.is_empty();
        shown.then(|| Self { connectors: sockets(context, connectors), lights: lights(context, leds) })
    }
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
