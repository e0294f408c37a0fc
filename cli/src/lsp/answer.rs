//! Answers to what an editor asks.

use std::path::{Path, PathBuf};

use devc::assist::{self, Definition, Knowledge, Symbol};
use devc::format::format;
use devc::source::{Disk, Loader};
use lsp_server::ErrorCode;
use lsp_types::{
    CodeActionParams, CompletionParams, DocumentFormattingParams, DocumentSymbolParams, GotoDefinitionParams,
    HoverParams, RenameParams, TextDocumentPositionParams,
};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

use super::publish::{bytes, place};
use super::state::{Open, State, name};
use super::text::Text;
use super::{action, learn, uri};

/// What is said of a request that cannot be answered.
type Refused = (ErrorCode, String);

/// The answer to a request; null if there is none to give.
pub(super) fn answer(state: &mut State, method: &str, params: Value) -> Result<Value, Refused> {
    let answer = match method {
        "textDocument/completion" => {
            let params: CompletionParams = read(params)?;
            completions(state, &params.text_document_position)
        }
        "textDocument/hover" => {
            let params: HoverParams = read(params)?;
            hover(state, &params.text_document_position_params)
        }
        "textDocument/definition" => {
            let params: GotoDefinitionParams = read(params)?;
            definition(state, &params.text_document_position_params)
        }
        "textDocument/documentSymbol" => {
            let params: DocumentSymbolParams = read(params)?;
            symbols(state, params.text_document.uri.as_str())
        }
        "textDocument/codeAction" => actions(state, &read(params)?),
        "textDocument/formatting" => {
            let params: DocumentFormattingParams = read(params)?;
            formatted(state, params.text_document.uri.as_str())
        }
        "textDocument/prepareRename" => return renamed(state, &read(params)?),
        "textDocument/rename" => return rename(state, &read(params)?),
        _ => return Err((ErrorCode::MethodNotFound, format!("devc does not know `{method}`"))),
    };
    Ok(answer.unwrap_or(Value::Null))
}

fn read<P: DeserializeOwned>(params: Value) -> Result<P, Refused> {
    serde_json::from_value(params).map_err(|error| (ErrorCode::InvalidParams, error.to_string()))
}

/// A text that is open, the byte that is asked about, and what is known of its description.
fn asked<'s>(
    state: &'s State,
    at: &TextDocumentPositionParams,
) -> Option<(&'s Open, usize, Option<&'s Knowledge>)> {
    let open = state.open.get(&name(at.text_document.uri.as_str())?)?;
    let description = open.main.as_ref().and_then(|main| state.descriptions.get(main));
    let knowledge = description.and_then(|description| description.knowledge.as_ref());
    Some((open, open.text.offset(at.position), knowledge))
}

fn completions(state: &State, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(state, at)?;
    open.main.as_ref()?;
    let beside = |folder: &str| neighbours(&name(at.text_document.uri.as_str()).unwrap_or_default(), folder);
    let list = assist::complete_beside(&open.text.text, offset, knowledge, &beside);
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

/// The names in a folder that a file would write so, but for its own and hidden ones.
fn neighbours(file: &Path, folder: &str) -> Vec<String> {
    let Some(folder) = file.parent().map(|parent| parent.join(folder)) else { return Vec::new() };
    let names = Disk.list(&folder).unwrap_or_default().into_iter();
    let others = names.filter(|name| !name.starts_with('.') && folder.join(name) != file);
    others.map(|name| if folder.join(&name).is_dir() { format!("{name}/") } else { name }).collect()
}

fn hover(state: &State, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(state, at)?;
    open.main.as_ref()?;
    let hover = assist::hover(&open.text.text, offset, knowledge)?;
    let contents = json!({ "kind": "markdown", "value": hover.text });
    Some(json!({ "contents": contents, "range": open.text.range(&hover.at) }))
}

fn definition(state: &mut State, at: &TextDocumentPositionParams) -> Option<Value> {
    let (open, offset, knowledge) = asked(state, at)?;
    open.main.as_ref()?;
    let start = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
    match assist::define(&open.text.text, offset, knowledge)? {
        Definition::File(file) => {
            let from = uri::path(at.text_document.uri.as_str())?;
            let path = name(&uri::uri(&from.parent()?.join(file)))?;
            path.exists().then(|| json!({ "uri": state.uri(&path), "range": start }))
        }
        Definition::Profile(name) => {
            let text = assist::profile(&name)?;
            let path = state.profiles.file(&name, text)?;
            Some(json!({ "uri": uri::uri(&path), "range": start }))
        }
        Definition::At(at) => {
            let sources = knowledge?.sources().clone();
            let text = Text::new(sources.get(at.file)?.text.as_str());
            let uri = place(state, &sources, at)?;
            Some(json!({ "uri": uri, "range": text.range(&bytes(at)) }))
        }
    }
}

fn symbols(state: &State, uri: &str) -> Option<Value> {
    let open = state.open.get(&name(uri)?)?;
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

fn actions(state: &mut State, params: &CodeActionParams) -> Option<Value> {
    let file = name(params.text_document.uri.as_str())?;
    let main = state.open.get(&file)?.main.clone()?;
    learn::refresh(state, &main);
    let text = &state.open.get(&file)?.text;
    let part = text.offset(params.range.start)..text.offset(params.range.end);
    let compilation = state.descriptions.get(&main)?.compilation.as_ref()?;
    Some(action::actions(state, &file, &part, compilation).into())
}

/// The one edit between what is there and the layout, from the first to the last line that differ.
fn formatted(state: &State, uri: &str) -> Option<Value> {
    let open = state.open.get(&name(uri)?)?;
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
fn renamed(state: &mut State, at: &TextDocumentPositionParams) -> Result<Value, Refused> {
    refresh(state, at.text_document.uri.as_str());
    let Some((open, offset, knowledge)) = asked(state, at).filter(|(open, ..)| open.main.is_some()) else {
        return Ok(Value::Null);
    };
    let found = assist::name_at(&open.text.text, offset, knowledge).map_err(refused)?;
    Ok(found.map_or(
        Value::Null,
        |(place, word)| json!({ "range": open.text.range(&place), "placeholder": word }),
    ))
}

fn rename(state: &mut State, params: &RenameParams) -> Result<Value, Refused> {
    let at = &params.text_document_position;
    refresh(state, at.text_document.uri.as_str());
    let Some((open, offset, knowledge)) = asked(state, at).filter(|(open, ..)| open.main.is_some()) else {
        return Ok(Value::Null);
    };
    let files = files(state, open);
    let texts: Vec<&str> = files.iter().map(|(_, text)| &*text.text).collect();
    let edits =
        assist::rename(&open.text.text, offset, &params.new_name, &texts, knowledge).map_err(refused)?;
    let mut changes = Map::new();
    for ((file, text), edits) in files.iter().zip(edits).filter(|(_, edits)| !edits.is_empty()) {
        let edits = edits.iter().map(|(at, new)| json!({ "range": text.range(at), "newText": new }));
        changes.insert(state.uri(file), edits.collect());
    }
    Ok(json!({ "changes": changes }))
}

fn refused(refusal: assist::Refusal) -> Refused {
    (ErrorCode::RequestFailed, refusal.0)
}

fn refresh(state: &mut State, uri: &str) {
    let main = name(uri).and_then(|name| state.open.get(&name)?.main.clone());
    if let Some(main) = main {
        learn::refresh(state, &main);
    }
}

/// The files of the description that an open one belongs to, as they are in the editor or on the disk.
fn files(state: &State, open: &Open) -> Vec<(PathBuf, Text)> {
    let compilation = open.main.as_ref().and_then(|main| state.descriptions.get(main)?.compilation.as_ref());
    let Some(sources) = compilation.map(|compilation| &compilation.sources) else { return Vec::new() };
    let files = sources.iter().filter_map(|(id, file)| Some((sources.name(id)?, file)));
    let text = |name: &Path, text: &str| match state.open.get(name) {
        Some(open) => open.text.clone(),
        None => Text::new(text),
    };
    files.map(|(name, file)| (name.to_owned(), text(name, &file.text))).collect()
}
