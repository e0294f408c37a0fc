//! Words made of bits.

use crate::emit::markdown::context::{Context, mode_label};
use crate::emit::markdown::inline::{code, link, text};
use crate::emit::markdown::number::width;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::picture;
use crate::emit::markdown::table::Table;
use crate::model::{Field, Meaning, Word};

/// What the bits of words mean.
pub(super) fn page(context: &Context<'_>, words: &[Word]) -> Page {
    let mut page = Page::default();
    words.iter().for_each(|word| self::word(context, word, &mut page));
    page
}

fn word(context: &Context<'_>, whole: &Word, page: &mut Page) {
    let Word { id, name, address, bits, fields, about, source, origin } = whole;
    page.place(3, context.word_id(id), text(name));
    let facts = format!("The {} of {}.", width(*bits), context.named(*address));
    page.text(format!("{facts} {}", context.paragraphs(about.as_deref())));
    context.picture(page, || picture::word(whole));
    page.table(table("Bit", fields, |field| meaning(context, whole, field)));
    page.text(context.said_line(source.as_ref(), origin));
}

/// A table of fields. Neighbours that are reserved without another word share a row.
pub(super) fn table(title: &str, fields: &[Field], meaning: impl Fn(&Field) -> String) -> Table {
    let rows = fields.iter().map(|field| (field, meaning(field))).collect::<Vec<_>>();
    let silent = |(field, meaning): &(&Field, String)| field.reserved && meaning.is_empty();
    let runs = rows.chunk_by(|one, next| silent(one) && silent(next) && one.0.high + 1 == next.0.low);
    let mut table = Table::new([title, "Name", "Meaning"]);
    for run in runs {
        if let ([(first, meaning), ..], [.., (last, _)]) = (run, run) {
            table.row([bits(first.low, last.high), name(first), meaning.clone()]);
        }
    }
    table
}

/// Bits: `3`, `4–6`.
fn bits(low: u8, high: u8) -> String {
    if low == high { low.to_string() } else { format!("{low}–{high}") }
}

/// The name of a field, quiet where it has no meaning.
fn name(field: &Field) -> String {
    if field.reserved { format!("*{}*", text(&field.name)) } else { format!("**{}**", text(&field.name)) }
}

fn meaning(context: &Context<'_>, word: &Word, field: &Field) -> String {
    let mut lines = statements(context, field);
    if field.per_mode {
        lines.extend(by_mode(context, word, field));
    }
    lines.join("<br>")
}

/// What is to be said of a field, a line each.
pub(super) fn statements(context: &Context<'_>, field: &Field) -> Vec<String> {
    // Place and name have cells of their own; what depends on the mode follows these lines.
    let Field {
        low: _,
        high: _,
        id: _,
        name: _,
        about,
        values,
        rising,
        falling,
        reserved: _,
        per_mode: _,
        key: _,
    } = field;
    let about = about.iter().map(|about| context.prose(about));
    let values = values.iter().map(|meaning| value(context, meaning));
    let rising = rising.iter().map(|effect| format!("0 → 1: {}", context.prose(effect)));
    let falling = falling.iter().map(|effect| format!("1 → 0: {}", context.prose(effect)));
    about.chain(values).chain(rising).chain(falling).collect()
}

/// A value with what it means.
pub(super) fn value(context: &Context<'_>, meaning: &Meaning) -> String {
    let about = meaning.about.as_ref().map_or(String::new(), |about| format!(": {}", context.prose(about)));
    format!("{} {}{about}", code(meaning.notation.written(meaning.value)), text(&meaning.name))
}

/// What the modes make of a bit.
fn by_mode(context: &Context<'_>, word: &Word, field: &Field) -> Vec<String> {
    let modes = context.device.modes.iter();
    let lines = modes.flat_map(|mode| {
        let bits = match word.id.as_str() {
            "controlword" => &mode.control_bits,
            _ => &mode.status_bits,
        };
        let same = bits.iter().filter(|own| own.low <= field.high && field.low <= own.high && !own.reserved);
        same.map(|own| format!("{}: {}", link(mode_label(mode), context.mode_id(mode.code)), text(&own.name)))
    });
    lines.collect()
}
