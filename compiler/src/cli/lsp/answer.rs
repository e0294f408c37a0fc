//! Answers to what an editor asks.

use std::path::{Path, PathBuf};

use devc::assist::{self, Definition, Knowledge, Symbol};
use devc::format::format;
use lsp_server::ErrorCode;
use lsp_types::{
    CodeActionParams, CompletionParams, DocumentFormattingParams, DocumentSymbolParams, GotoDefinitionParams,
    HoverParams, RenameParams, TextDocumentPositionParams,
};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use super::publish::{bytes, place};
use super::server::{Open, Server, name};
use super::text::Text;
use super::{action, uri};

/// What is said of a request that cannot be answered.
type Refused = (ErrorCode, String);

/// The answer to a request; null if there is none to give.
pub(super) fn answer(server: &mut Server, method: &str, params: Value) -> Result<Value, Refused> {
    let answer = match method {
        "textDocument/completion" => {
            let params: CompletionParams = read(params)?;
            completions(server, &params.text_document_position)
        }
        "textDocument/hover" => {
            let params: HoverParams = read(params)?;
            hover(server, &params.text_document_position_params)
        }
        "textDocument/definition" => {
            let params: GotoDefinitionParams = read(params)?;
            definition(server, &params.text_document_position_params)
        }
        "textDocument/documentSymbol" => {
            let params: DocumentSymbolParams = read(params)?;
            symbols(server, params.text_document.uri.as_str())
        }
        "textDocument/codeAction" => actions(server, &read(params)?),
        "textDocument/formatting" => {
            let params: DocumentFormattingParams = read(params)?;
            formatted(server, params.text_document.uri.as_str())
        }
        "textDocument/prepareRename" => return renamed(server, &read(params)?),
        "textDocument/rename" => return rename(server, &read(params)?),
        _ => return Err((ErrorCode::MethodNotFound, format!("devc does not know `{method}`"))),
    };
    Ok(answer.unwrap_or(Value::Null))
}

fn read<P: DeserializeOwned>(params: Value) -> Result<P, Refused> {
    serde_json::from_value(params).map_err(|error| (ErrorCode::InvalidParams, error.to_string()))
}

/// A text that is open, the byte that is asked about, and what is known of its description.
fn asked<'s>(
    server: &'s Server,
    at: &TextDocumentPositionParams,
) -> Option<(&'s Open, usize, Option<&'s Knowledge>)> {
    let open = server.open.get(&name(at.text_document.uri.as_str())?)?;
    let description = open.main.as_ref().and_then(|main| server.descriptions.get(main));
    let knowledge = description.and_then(|description| description.knowledge.as_ref());
    Some((open, open.text.offset(at.position), knowledge))
}

fn completions(server: &Server, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(server, at)?;
    open.main.as_ref()?;
    let list = assist::complete(&open.text.text, offset, knowledge);
    let items = list.into_iter().enumerate().map(|(place, it)| {
        let written = open.text.text.get(it.replaces.start..offset).unwrap_or_default();
        // an editor filters by what is written there, quotes and all; a name is to be found as well as an index
        let quote = if written.starts_with(['"', '\'']) { written.get(..1).unwrap_or_default() } else { "" };
        json!({
            "label": it.label,
            "kind": if it.is_key { 10 } else { 12 },
            "detail": it.detail,
            "documentation": { "kind": "markdown", "value": it.about },
            "filterText": format!("{quote}{} {}", it.label, it.detail),
            "sortText": format!("{place:05}"),
            "textEdit": { "range": open.text.range(&it.replaces), "newText": it.text },
        })
    });
    Some(json!({ "isIncomplete": false, "items": items.collect::<Vec<_>>() }))
}

fn hover(server: &Server, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(server, at)?;
    open.main.as_ref()?;
    let hover = assist::hover(&open.text.text, offset, knowledge)?;
    let contents = json!({ "kind": "markdown", "value": hover.text });
    Some(json!({ "contents": contents, "range": open.text.range(&hover.at) }))
}

fn definition(server: &mut Server, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(server, at)?;
    open.main.as_ref()?;
    let start = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    match assist::define(&open.text.text, offset, knowledge)? {
        Definition::File(file) => {
            let from = uri::path(at.text_document.uri.as_str())?;
            let path = name(&uri::uri(&from.parent()?.join(file)))?;
            path.exists().then(|| json!({ "uri": server.uri(&path), "range": start }))
        }
        Definition::Profile(name) => {
            let text = assist::profile(&name)?;
            let path = server.profiles.file(&name, text)?;
            Some(json!({ "uri": uri::uri(&path), "range": start }))
        }
        Definition::At(at) => {
            let sources = knowledge?.sources().clone();
            let text = Text::new(sources.get(at.file)?.text.as_str());
            let uri = place(server, &sources, at)?;
            Some(json!({ "uri": uri, "range": text.range(&bytes(at)) }))
        }
    }
}

fn symbols(server: &Server, uri: &str) -> Option<Value> {
    let open = server.open.get(&name(uri)?)?;
    open.main.as_ref()?;
    let symbols = assist::symbols(&open.text.text);
    Some(symbols.iter().map(|it| symbol(it, &open.text)).collect())
}

fn symbol(symbol: &Symbol, text: &Text) -> Value {
    json!({
        "name": symbol.name,
        "detail": symbol.detail,
        "kind": if symbol.inside.is_empty() { 19 } else { 3 },
        "range": text.range(&symbol.at),
        "selectionRange": text.range(&symbol.name_at),
        "children": symbol.inside.iter().map(|inner| self::symbol(inner, text)).collect::<Vec<_>>(),
    })
}

fn actions(server: &mut Server, params: &CodeActionParams) -> Option<Value> {
    let file = name(params.text_document.uri.as_str())?;
    let main = server.open.get(&file)?.main.clone()?;
    server.refresh(&main);
    let text = &server.open.get(&file)?.text;
    let part = text.offset(params.range.start)..text.offset(params.range.end);
    let compilation = server.descriptions.get(&main)?.compilation.as_ref()?;
    Some(action::actions(server, &file, &part, compilation).into())
}

/// The one edit between what is there and the layout, from the first to the last line that differ.
fn formatted(server: &Server, uri: &str) -> Option<Value> {
    let open = server.open.get(&name(uri)?)?;
    open.main.as_ref()?;
    let old = &*open.text.text;
    let new = format(uri, old).ok()?;
    let same = |(old, new): &(&str, &str)| old == new;
    let before: usize = old
        .split_inclusive('\n')
        .zip(new.split_inclusive('\n'))
        .take_while(same)
        .map(|(line, _)| line.len())
        .sum();
    let (old_rest, new_rest) = (old.get(before..)?, new.get(before..)?);
    let lines = old_rest.split_inclusive('\n').rev().zip(new_rest.split_inclusive('\n').rev());
    let behind: usize = lines.take_while(same).map(|(line, _)| line.len()).sum();
    let range = open.text.range(&(before..old.len() - behind));
    let text = new_rest.get(..new_rest.len() - behind)?;
    let is_same = old_rest.is_empty() && new_rest.is_empty();
    Some(if is_same { json!([]) } else { json!([{ "range": range, "newText": text }]) })
}

/// The word that would be renamed.
fn renamed(server: &mut Server, at: &TextDocumentPositionParams) -> Result<Value, Refused> {
    refresh(server, at.text_document.uri.as_str());
    let Some((open, offset, knowledge)) = asked(server, at).filter(|(open, ..)| open.main.is_some()) else {
        return Ok(Value::Null);
    };
    let found = assist::name_at(&open.text.text, offset, knowledge).map_err(refused)?;
    Ok(found.map_or(
        Value::Null,
        |(place, word)| json!({ "range": open.text.range(&place), "placeholder": word }),
    ))
}

fn rename(server: &mut Server, params: &RenameParams) -> Result<Value, Refused> {
    let at = &params.text_document_position;
    refresh(server, at.text_document.uri.as_str());
    let Some((open, offset, knowledge)) = asked(server, at).filter(|(open, ..)| open.main.is_some()) else {
        return Ok(Value::Null);
    };
    let files = files(server, open);
    let texts: Vec<&str> = files.iter().map(|(_, text)| &*text.text).collect();
    let edits =
        assist::rename(&open.text.text, offset, &params.new_name, &texts, knowledge).map_err(refused)?;
    let mut changes = Map::new();
    for ((file, text), edits) in files.iter().zip(edits).filter(|(_, edits)| !edits.is_empty()) {
        let edits = edits.iter().map(|(at, new)| json!({ "range": text.range(at), "newText": new }));
        changes.insert(server.uri(file), edits.collect());
    }
    Ok(json!({ "changes": changes }))
}

fn refused(refusal: assist::Refusal) -> Refused {
    (ErrorCode::RequestFailed, refusal.0)
}

fn refresh(server: &mut Server, uri: &str) {
    let main = name(uri).and_then(|name| server.open.get(&name)?.main.clone());
    if let Some(main) = main {
        server.refresh(&main);
    }
}

/// The files of the description that an open one belongs to, as they are in the editor or on the disk.
fn files(server: &Server, open: &Open) -> Vec<(PathBuf, Text)> {
    let compilation = open.main.as_ref().and_then(|main| server.descriptions.get(main)?.compilation.as_ref());
    let Some(sources) = compilation.map(|compilation| &compilation.sources) else { return Vec::new() };
    let files = sources.iter().filter_map(|(id, file)| Some((sources.name(id)?, file)));
    let text = |name: &Path, text: &str| match server.open.get(name) {
        Some(open) => open.text.clone(),
        None => Text::new(text),
    };
    files.map(|(name, file)| (name.to_owned(), text(name, &file.text))).collect()
}
