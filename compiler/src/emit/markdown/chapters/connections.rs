//! Sockets and lights.

use serde::Serialize;

use crate::emit::markdown::context::Context;
use crate::emit::markdown::document::Chapter;
use crate::emit::markdown::inline::{list, small, text};
use crate::emit::markdown::table::Table;
use crate::model::Led;

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    connectors: Table,
    leds: Vec<LedView>,
}

#[derive(Serialize)]
struct LedView {
    name: String,
    about: String,
    patterns: Table,
    source: String,
}

impl Chapter for View {
    const ID: &'static str = "connections";
    const TITLE: &'static str = "Connections and lights";
    const TEMPLATE: &'static str = include_str!("../templates/connections.md.j2");

    fn view(context: &Context<'_>) -> Option<Self> {
        let device = context.device;
        (!device.connectors.is_empty() || !device.leds.is_empty()).then(|| Self {
            connectors: connectors(context),
            leds: device.leds.iter().map(|led| led_view(context, led)).collect(),
        })
    }
}

fn connectors(context: &Context<'_>) -> Table {
    Table::of(["Socket", "Kind", "Use", "Source"], &context.device.connectors, |connector| {
        [
            format!("**{}**", text(&connector.name)),
            context.optional(connector.kind.as_deref()),
            context.optional(connector.about.as_deref()),
            small(&context.source(connector.source.as_ref())),
        ]
    })
}

fn led_view(context: &Context<'_>, led: &Led) -> LedView {
    let colour = led.colour.iter().map(|colour| text(colour));
    LedView {
        name: list([text(&led.name)].into_iter().chain(colour)),
        about: context.paragraphs(led.about.as_deref()),
        patterns: Table::of(["Light", "Meaning"], &led.patterns, |pattern| {
            [context.prose(&pattern.shows), context.prose(&pattern.means)]
        }),
        source: small(&context.source(led.source.as_ref())),
    }
}
