//! Blocks as HTML: a section for each heading with what stands under it, and on everything what it holds for.

use minijinja::HtmlEscape;
use pulldown_cmark::{Event, Options, Parser, html::push_html};

use super::figure::{machine, picture};
use crate::emit::markdown::{Block, Heading, Page, Row, Table};

/// Blocks as HTML; pictures are of what is called so.
pub(super) fn html(page: &Page, name: &str) -> String {
    let mut out = String::new();
    let mut open: Vec<usize> = Vec::new();
    for block in &page.0 {
        match block {
            Block::Heading(heading) => {
                while open.pop_if(|outer| *outer >= heading.level).is_some() {
                    out.push_str("</section>\n");
                }
                if heading.level > 1 {
                    out.push_str(&format!("<section{}>\n", heading.holds));
                    open.push(heading.level);
                }
                title(heading, open.len() + 1, &mut out);
            }
            Block::Machine(one) => out.push_str(&machine(one, &format!("The states of {name}"))),
            Block::Picture(one) => out.push_str(&picture(one)),
            Block::Table(one) => table(one, &mut out),
            Block::Open(holds) => out.push_str(&format!("<div{holds}>\n")),
            Block::Close => out.push_str("</div>\n"),
            other => markdown(&other.to_string(), &mut out),
        }
    }
    open.iter().for_each(|_| out.push_str("</section>\n"));
    out
}

/// A heading, with a link to itself to be shared. None is deeper than those around it make it, which readers by ear go by.
fn title(heading: &Heading, level: usize, out: &mut String) {
    let Heading { level: _, anchor, title, holds: _ } = heading;
    let words = inline(title);
    let (id, here) = match anchor {
        Some(anchor) => {
            let (anchor, label) = (HtmlEscape(anchor), plain(title));
            let here = format!(
                " <a class=\"here\" href=\"#{anchor}\" aria-label=\"Link to {}\"></a>",
                HtmlEscape(&label)
            );
            (format!(" id=\"{anchor}\""), here)
        }
        None => Default::default(),
    };
    out.push_str(&format!("<h{level}{id}>{words}{here}</h{level}>\n"));
}

/// A table. A wide one moves by itself, and not the page.
fn table(table: &Table, out: &mut String) {
    let titles: Vec<String> = table.columns().iter().map(|title| inline(&title.text)).collect();
    let label = table.columns().iter().map(|title| plain(&title.text)).collect::<Vec<_>>().join(", ");
    out.push_str(&format!(
        "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Table: {}\">\n<table><thead><tr>",
        HtmlEscape(label.trim_matches([',', ' ']))
    ));
    for (title, column) in titles.iter().zip(table.columns()) {
        let cell = if title.is_empty() { "td" } else { "th" };
        out.push_str(&format!("<{cell}{}>{title}</{cell}>", column.holds));
    }
    out.push_str("</tr></thead><tbody>\n");
    table.rows().iter().for_each(|one| row(table, one, out));
    out.push_str("</tbody></table>\n</div>\n");
}

fn row(table: &Table, row: &Row, out: &mut String) {
    out.push_str(&format!("<tr{}>", row.holds));
    for (cell, column) in row.cells.iter().zip(table.columns()) {
        out.push_str(&format!("<td{}>{}</td>", column.holds, inline(cell)));
    }
    out.push_str("</tr>\n");
}

fn markdown(text: &str, out: &mut String) {
    push_html(out, Parser::new_ext(text, Options::ENABLE_TABLES | Options::ENABLE_GFM));
}

/// What stands in a line, without a paragraph around it.
pub(super) fn inline(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    let mut out = String::new();
    markdown(text, &mut out);
    let inner = out.trim().strip_prefix("<p>").and_then(|inner| inner.strip_suffix("</p>"));
    inner.map_or_else(|| HtmlEscape(text).to_string(), str::to_owned)
}

/// The words of a title, without what makes them look like something.
pub(super) fn plain(title: &str) -> String {
    let texts = Parser::new(title).filter_map(|event| match event {
        Event::Text(text) | Event::Code(text) => Some(text.into_string()),
        _ => None,
    });
    texts.collect()
}
