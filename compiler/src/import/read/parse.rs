//! XML as a tree, within limits.
//!
//! No document type is followed: an entity that XML itself does not define stays the text that it is.

use std::borrow::Cow;
use std::cell::Cell;

use quick_xml::XmlVersion;
use quick_xml::escape::resolve_predefined_entity;
use quick_xml::events::{BytesRef, BytesStart, Event};
use quick_xml::reader::Reader;

use super::element::{At, Attribute, Element};

/// How deep elements may lie in each other: ESI needs a dozen.
const MOST_DEEP: usize = 64;

/// How many elements and attributes a file may have: the largest real ones have a tenth of it.
const MOST_PARTS: usize = 8_000_000;

/// The root element, or where and why there is none.
pub(super) fn parse(text: &str) -> Result<Element<'_>, (At, String)> {
    let mut reader = Reader::from_str(text);
    let config = reader.config_mut();
    config.expand_empty_elements = true;
    config.allow_dangling_amp = true;
    let mut open: Vec<Element<'_>> = Vec::new();
    let mut parts = 0_usize;
    // Where the root has the prefix of a namespace, so has what belongs to it.
    let mut prefix = "";
    loop {
        let before = At(position(reader.buffer_position()));
        let event = reader
            .read_event()
            .map_err(|error| (At(position(reader.error_position())), error.to_string()))?;
        match event {
            Event::Start(start) => {
                let mut element = element(text, &start, before)?;
                if open.is_empty() {
                    prefix = element.name.split_once(':').map_or("", |(prefix, _)| prefix);
                }
                element.name = match element.name.split_once(':') {
                    Some((own, name)) if own == prefix => name,
                    _ => element.name,
                };
                parts = parts.saturating_add(1 + element.attributes.len());
                open.push(element);
                if open.len() > MOST_DEEP {
                    return Err((before, format!("elements lie more than {MOST_DEEP} deep in each other")));
                }
                if parts > MOST_PARTS {
                    return Err((before, format!("more than {MOST_PARTS} elements and attributes")));
                }
            }
            Event::End(_) => {
                let Some(done) = open.pop() else {
                    return Err((before, "an end without a start".to_owned()));
                };
                match open.last_mut() {
                    Some(parent) => parent.children.push(done),
                    None => return Ok(done),
                }
            }
            Event::Text(piece) => append(&mut open, piece.into_inner()),
            Event::CData(piece) => append(&mut open, piece.into_inner()),
            Event::GeneralRef(reference) => append(&mut open, Cow::Owned(resolved(&reference))),
            Event::Eof => return Err((before, "the file ends before its root element does".to_owned())),
            Event::Empty(_) | Event::Comment(_) | Event::Decl(_) | Event::PI(_) | Event::DocType(_) => {}
        }
    }
}

fn position(offset: u64) -> usize {
    usize::try_from(offset).unwrap_or(usize::MAX)
}

fn element<'t>(text: &'t str, start: &BytesStart<'_>, at: At) -> Result<Element<'t>, (At, String)> {
    // Behind the sign that opens it, the tag stands in the text as it is.
    let tag = at.0.saturating_add(1);
    let name = text.get(tag..tag.saturating_add(start.name().as_ref().len())).unwrap_or_default();
    let mut attributes = Vec::new();
    for attribute in start.attributes().with_checks(false) {
        let attribute = attribute.map_err(|error| (at, error.to_string()))?;
        let key = attribute.key.as_ref();
        if key.starts_with("xmlns") || key.contains(':') {
            continue;
        }
        let value = attribute.normalized_value(XmlVersion::Implicit1_0).unwrap_or(attribute.value.clone());
        let place = text.get(tag..).and_then(|rest| rest.find(key)).unwrap_or_default();
        let key = text.get(tag..).and_then(|rest| rest.get(place..place + key.len())).unwrap_or_default();
        attributes.push(Attribute {
            name: key,
            value: Cow::Owned(value.into_owned()),
            read: Cell::new(false),
        });
    }
    Ok(Element {
        name,
        at,
        attributes,
        text: Cow::Borrowed(""),
        children: Vec::new(),
        read: Cell::new(false),
        idle: Cell::new(false),
    })
}

fn append<'t>(open: &mut [Element<'t>], piece: Cow<'t, str>) {
    let Some(element) = open.last_mut() else { return };
    if piece.trim().is_empty() && element.text.is_empty() {
        return;
    }
    if element.text.is_empty() {
        element.text = piece;
    } else {
        element.text.to_mut().push_str(&piece);
    }
}

/// What a reference stands for.
fn resolved(reference: &BytesRef<'_>) -> String {
    let name: &str = reference;
    match reference.resolve_char_ref() {
        Ok(Some(char)) => char.to_string(),
        _ => resolve_predefined_entity(name).map_or_else(|| format!("&{name};"), str::to_owned),
    }
}
