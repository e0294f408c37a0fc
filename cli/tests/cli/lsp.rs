//! `devc lsp` as an editor talks to it.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::{fs, thread};

use serde_json::{Value, json};

use crate::{Desk, PATIENCE};

const MAIN: &str = r#"profiles = ["ethercat", "cia402"]
include = ["more.toml"]

[device]
name = "Drive"
vendor = "Maker"

[identity]
vendor-id = 0x76D
product-code = 3
revision = 1

[objects]
0x6040 = {}
0x6041 = {}

[objects.0x6064]
unit = "increments"

[objects.0x2000]
id = "speed"
name = "Speed"
type = "UINT16"
access = "rw"
pdo = "rx"
about = "𝛉 and more" # ä

[words.speed.bits]
0 = "slow"
"#;

const MORE: &str = r#"[units.increments]
quantity = "position"
symbol = "inc"

[rx-pdos.0x1600]
name = "Out"
entries = ["controlword", "speed"]

[tx-pdos.0x1A00]
name = "In"
entries = ["statusword", "position-actual-value"]
"#;

/// An editor with a server.
struct Editor {
    server: Child,
    input: Option<ChildStdin>,
    messages: Receiver<Value>,
    number: i64,
}

impl Editor {
    fn start(desk: &Desk) -> Self {
        let mut command = desk.command(&["lsp", "--stdio"]);
        let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::inherit());
        let mut server = command.spawn().expect("devc runs");
        let output = BufReader::new(server.stdout.take().expect("an output"));
        let (tell, messages) = channel();
        thread::spawn(move || read(output).take_while(|message| tell.send(message.clone()).is_ok()).count());
        let input = server.stdin.take();
        let mut editor = Self { server, input, messages, number: 0 };
        let about =
            editor.ask("initialize", json!({ "capabilities": {}, "processId": null, "rootUri": null }));
        assert_eq!(about["capabilities"]["positionEncoding"], "utf-16");
        editor.tell("initialized", json!({}));
        editor
    }

    fn send(&mut self, message: &Value) {
        let text = message.to_string();
        let input = self.input.as_mut().expect("the server listens");
        write!(input, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("the server listens");
        input.flush().expect("the server listens");
    }

    fn tell(&mut self, method: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The whole answer to a request.
    fn answer(&mut self, method: &str, params: Value) -> Value {
        self.number += 1;
        let id = self.number;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message =
                self.messages.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("no answer to {method}"));
            if message["id"] == id {
                return message;
            }
        }
    }

    fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert_eq!(answer.get("error"), None, "{method}");
        answer["result"].clone()
    }

    fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "toml", "version": 1, "text": text });
        self.tell("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces the whole text.
    fn write(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "version": 2 });
        let change = json!([{ "text": text }]);
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": change }));
    }

    /// The next messages about a file.
    fn marks(&mut self, uri: &str) -> Vec<Value> {
        loop {
            let message = self.messages.recv_timeout(PATIENCE).expect("messages about the file");
            let params = &message["params"];
            if message["method"] == "textDocument/publishDiagnostics" && params["uri"] == uri {
                return params["diagnostics"].as_array().expect("a list").clone();
            }
        }
    }

    /// Asks about the place behind a piece of a text.
    fn at(&mut self, method: &str, uri: &str, text: &str, behind: &str) -> Value {
        self.ask(method, place(uri, text, behind))
    }

    fn completions(&mut self, uri: &str, text: &str, behind: &str) -> Vec<Value> {
        let list = self.at("textDocument/completion", uri, text, behind);
        list["items"].as_array().expect("a list").clone()
    }

    fn end(mut self) {
        assert_eq!(self.ask("shutdown", Value::Null), Value::Null);
        self.tell("exit", Value::Null);
        self.input = None;
        let code = self.server.wait().expect("the server ends").code();
        assert_eq!(code, Some(0));
    }
}

fn read(mut output: impl BufRead) -> impl Iterator<Item = Value> {
    std::iter::from_fn(move || {
        let mut length = 0;
        loop {
            let mut line = String::new();
            output.read_line(&mut line).ok().filter(|read| *read > 0)?;
            match line.trim().strip_prefix("Content-Length: ") {
                Some(number) => length = number.parse().ok()?,
                None if line.trim().is_empty() => break,
                None => {}
            }
        }
        let mut bytes = vec![0; length];
        output.read_exact(&mut bytes).ok()?;
        serde_json::from_slice(&bytes).ok()
    })
}

/// The place behind the first such piece of a text, counted as editors count.
fn position(text: &str, behind: &str) -> Value {
    let offset = text.find(behind).unwrap_or_else(|| panic!("`{behind}` in {text}")) + behind.len();
    let line = text[..offset].matches('\n').count();
    let start = text[..offset].rfind('\n').map_or(0, |feed| feed + 1);
    json!({ "line": line, "character": text[start..offset].encode_utf16().count() })
}

fn place(uri: &str, text: &str, behind: &str) -> Value {
    json!({ "textDocument": { "uri": uri }, "position": position(text, behind) })
}

fn uri(path: &Path) -> String {
    format!("file://{}", path.display())
}

/// The text with edits made.
fn edited(text: &str, edits: &Value) -> String {
    let offset = |place: &Value| {
        let number = |key: &str| usize::try_from(place[key].as_u64().expect("a number")).expect("a place");
        let start: usize = text.split_inclusive('\n').take(number("line")).map(str::len).sum();
        let units: Vec<u16> = text[start..].encode_utf16().take(number("character")).collect();
        start + String::from_utf16(&units).expect("whole characters").len()
    };
    let mut places: Vec<(usize, usize, &str)> = Vec::new();
    for edit in edits.as_array().expect("a list") {
        let (start, end) = (offset(&edit["range"]["start"]), offset(&edit["range"]["end"]));
        places.push((start, end, edit["newText"].as_str().expect("a text")));
    }
    places.sort_unstable();
    let mut text = text.to_owned();
    for (start, end, new) in places.into_iter().rev() {
        text.replace_range(start..end, new);
    }
    text
}

/// A desk with the description, and the addresses of its files.
fn desk() -> (Desk, String, String) {
    let desk = Desk::new(&[("drive", MAIN)]);
    desk.put("devices/drive/more.toml", MORE);
    let folder = fs::canonicalize(desk.path("devices/drive")).expect("a folder");
    let uri = |file: &str| uri(&folder.join(file));
    let (main, more) = (uri("device.toml"), uri("more.toml"));
    (desk, main, more)
}

fn labels(items: &[Value]) -> Vec<&str> {
    items.iter().map(|item| item["label"].as_str().expect("a label")).collect()
}

#[test]
fn what_is_wrong_is_marked_and_mended_as_one_types() {
    let (desk, main, _) = desk();
    let mut editor = Editor::start(&desk);
    let wrong = MAIN.replace("# ä", "# ä\nacess = \"ro\"").replace("access = \"rw\"\n", "");
    editor.open(&main, &wrong);
    let marks = editor.marks(&main);
    let mark = marks.iter().find(|mark| mark["code"] == "unknown-key").expect("the misspelled key");
    assert_eq!((&mark["severity"], &mark["source"]), (&json!(1), &json!("devc")));
    assert_eq!(mark["range"]["end"], position(&wrong, "acess"), "{mark}");
    assert!(
        mark["message"].as_str().is_some_and(|said| said.contains("help: did you mean `access`?")),
        "{mark}"
    );

    let about =
        json!({ "textDocument": { "uri": main }, "range": mark["range"], "context": { "diagnostics": [] } });
    let actions = editor.ask("textDocument/codeAction", about);
    let action = &actions[0];
    assert_eq!((&action["kind"], &action["isPreferred"]), (&json!("quickfix"), &json!(true)), "{actions}");
    let mended = edited(&wrong, &action["edit"]["changes"][&main]);
    assert!(mended.contains("\naccess = \"ro\""), "{mended}");

    // a change of a part, behind a character of two units
    let change = json!([{
        "range": { "start": position(&wrong, "# ä\n"), "end": position(&wrong, "# ä\nacess") }, "text": "access",
    }]);
    let document = json!({ "uri": main, "version": 2 });
    editor.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": change }));
    let marks = editor.marks(&main);
    assert!(marks.iter().all(|mark| mark["code"] != "unknown-key"), "{marks:?}");
    editor.end();
}

#[test]
fn places_count_units_of_utf_16() {
    let (desk, main, _) = desk();
    let mut editor = Editor::start(&desk);
    let wrong = MAIN.replace("0 = \"slow\"", "0 = { name = \"𝛉𝛉\", colour = 1 }");
    editor.open(&main, &wrong);
    let marks = editor.marks(&main);
    let mark = marks.iter().find(|mark| mark["code"] == "unknown-key").expect("the unknown key");
    assert_eq!(mark["range"]["start"], position(&wrong, "\"𝛉𝛉\", "));
    let hover = editor.at("textDocument/hover", &main, &wrong, "\"𝛉𝛉\", col");
    assert_eq!(hover, Value::Null, "nothing is known of it");
    let hover = editor.at("textDocument/hover", &main, &wrong, "{ na");
    assert_eq!(hover["range"]["start"], position(&wrong, "0 = { "), "{hover}");
    editor.end();
}

#[test]
fn keys_words_and_references_are_completed() {
    let (desk, main, more) = desk();
    let mut editor = Editor::start(&desk);
    editor.open(&main, MAIN);
    editor.know(&main);
    editor.open(&more, MORE);

    let text = MAIN.replace("pdo = \"rx\"", "pdo = \"\"\nca");
    editor.write(&main, &text);
    let items = editor.completions(&main, &text, "pdo = \"");
    assert_eq!(labels(&items), ["none", "rx", "tx", "rx-tx"]);
    assert_eq!(edited(&text, &json!([items[1]["textEdit"]])), text.replace("pdo = \"\"", "pdo = \"rx\""));
    let items = editor.completions(&main, &text, "\nca");
    let item = items.iter().find(|item| item["label"] == "category").expect("a key");
    assert!(
        item["documentation"]["value"]
            .as_str()
            .is_some_and(|it| it.starts_with("Whether the profile demands"))
    );
    assert!(!labels(&items).contains(&"access"), "what is there is not offered again");

    // headers: sections, then what the profiles have
    let text = format!("{MAIN}\n[objects.0x60");
    editor.write(&main, &text);
    let items = editor.completions(&main, &text, "[objects.0x60");
    let item = items.iter().find(|item| item["label"] == "0x607A").expect("an object of the profile");
    assert_eq!(item["detail"], "Target position");
    let text = format!("{MAIN}\n[sync");
    editor.write(&main, &text);
    assert!(labels(&editor.completions(&main, &text, "\n[sync")).contains(&"sync-managers"));

    // the file is no TOML meanwhile; what there is to refer to is known all the same
    let text = MORE.replace("\"speed\"]", "\"sp");
    editor.write(&more, &text);
    let items = editor.completions(&more, &text, "\"sp");
    let item = items.iter().find(|item| item["label"] == "speed").unwrap_or_else(|| panic!("{items:?}"));
    assert_eq!(item["detail"], "0x2000 Speed, UINT16, rw");
    assert_eq!(edited(&text, &json!([item["textEdit"]])), text.replace("\"sp", "\"speed\""));
    assert!(labels(&items).contains(&"position-actual-value"), "{items:?}");
    let text = MAIN.replace("unit = \"increments\"", "unit = \"");
    editor.write(&main, &text);
    assert_eq!(labels(&editor.completions(&main, &text, "unit = \"")), ["increments"]);
    assert_eq!(labels(&editor.completions(&main, &text, "# ")), [""; 0], "nothing in a comment");
    editor.end();
}

#[test]
fn what_things_are_and_where_they_are_defined_is_told() {
    let (desk, main, more) = desk();
    let mut editor = Editor::start(&desk);
    editor.open(&main, MAIN);
    editor.open(&more, MORE);
    editor.know(&main);
    let mut hover = |uri: &str, text: &str, behind: &str| {
        let hover = editor.at("textDocument/hover", uri, text, behind);
        hover["contents"]["value"].as_str().unwrap_or_default().to_owned()
    };
    let told = hover(&main, MAIN, "[objects.0x60");
    for word in ["object 0x6064", "Position actual value", "INT32", "`[objects.<index>]`"] {
        assert!(told.contains(word), "`{word}` in {told}");
    }
    assert!(hover(&main, MAIN, "acce").contains("`access`: "));
    assert!(hover(&main, MAIN, "access = \"r").contains("Read and write."));
    assert!(hover(&more, MORE, "\"contr").contains("bit"), "the bits of the word");
    assert!(hover(&more, MORE, "\"spe").contains("object 0x2000 of this description: Speed"));
    assert!(hover(&main, MAIN, "unit = \"incr").contains("symbol    inc"));

    let start = json!({ "line": 0, "character": 0 });
    let found = editor.at("textDocument/definition", &main, MAIN, "\"more");
    assert_eq!((&found["uri"], &found["range"]["start"]), (&json!(more), &start));
    let found = editor.at("textDocument/definition", &main, MAIN, "unit = \"incr");
    assert_eq!((&found["uri"], &found["range"]["start"]), (&json!(more), &position(MORE, "[units.")));
    let found = editor.at("textDocument/definition", &more, MORE, "\"spe");
    assert_eq!(
        (&found["uri"], &found["range"]["start"]),
        (&json!(main), &position(MAIN, "0x6064]\nunit = \"increments\"\n\n[objects."))
    );

    // a profile is a file that cannot be written to
    let found = editor.at("textDocument/definition", &main, MAIN, "[objects.0x60");
    let path = found["uri"].as_str().and_then(|uri| uri.strip_prefix("file://")).expect("a file").to_owned();
    let text = fs::read_to_string(&path).expect("a profile");
    let line = usize::try_from(found["range"]["start"]["line"].as_u64().expect("a line")).expect("a line");
    assert_eq!(text.lines().nth(line), Some("[objects.0x6064]"));
    assert!(fs::metadata(&path).expect("a file").permissions().readonly());
    editor.end();
    assert!(!Path::new(&path).exists(), "it is gone with the server");
}

#[test]
fn ids_are_renamed_in_all_files() {
    let (desk, main, more) = desk();
    let mut editor = Editor::start(&desk);
    editor.open(&main, MAIN);
    editor.open(&more, MORE);
    let mut rename = |uri: &str, text: &str, behind: &str, new: &str| {
        let mut about = place(uri, text, behind);
        about["newName"] = json!(new);
        editor.answer("textDocument/rename", about)
    };
    let answer = rename(&main, MAIN, "id = \"sp", "velocity");
    let changes = &answer["result"]["changes"];
    let renamed =
        |text: &str| text.replace("\"speed\"", "\"velocity\"").replace("words.speed", "words.velocity");
    assert_eq!(edited(MAIN, &changes[&main]), renamed(MAIN));
    assert_eq!(edited(MORE, &changes[&more]), renamed(MORE));
    let answer = rename(&main, MAIN, "unit = \"incr", "steps");
    let changes = &answer["result"]["changes"];
    assert_eq!(edited(MAIN, &changes[&main]), MAIN.replace("\"increments\"", "\"steps\""));
    assert_eq!(edited(MORE, &changes[&more]), MORE.replace("units.increments", "units.steps"));
    let refused = |answer: &Value| answer["error"]["message"].as_str().unwrap_or_default().to_owned();
    assert!(refused(&rename(&more, MORE, "\"contr", "x")).contains("is what a profile calls it"));
    assert!(refused(&rename(&main, MAIN, "id = \"sp", "a b")).contains("is no id"));
    let about = editor.at("textDocument/prepareRename", &more, MORE, "[units.incr");
    assert_eq!(about["placeholder"], "increments");
    editor.end();
}

/// Axes are listed once, and meant wherever something differs on one of them.
#[test]
fn axes_are_renamed_in_all_files() {
    const AXES: &str = "\n[axes]\nnames = [\"Y\", \"W\", \"turn table\"]\nshifts = [{ range = \"0x2000..=0x20FF\", by = 0x100 }]\n\n\
        [objects.0x2001]\nname = \"Y\"\ntype = \"UINT16\"\nper-axis.Y = { about = \"Y\" }\nper-axis.\"W..=turn table\" = { default = 3 }\n";
    const OTHER: &str = "[objects.0x2002]\nname = \"Gain\"\ntype = \"UINT16\"\nper-axis = { Y = { default = 1 }, W = { default = 2 } }\n";
    let (desk, main, more) = desk();
    let (one, other) = ([MAIN, AXES].concat(), [MORE, OTHER].concat());
    desk.put("devices/drive/more.toml", &other);
    let mut editor = Editor::start(&desk);
    editor.open(&main, &one);
    editor.open(&more, &other);
    let mut rename = |uri: &str, text: &str, behind: &str, new: &str| {
        let mut about = place(uri, text, behind);
        about["newName"] = json!(new);
        editor.answer("textDocument/rename", about)
    };
    let answer = rename(&main, &one, "per-axis.Y", "left arm");
    let changes = &answer["result"]["changes"];
    let in_main = one.replace("[\"Y\"", "[\"left arm\"").replace("per-axis.Y", "per-axis.\"left arm\"");
    assert_eq!(edited(&one, &changes[&main]), in_main);
    assert_eq!(edited(&other, &changes[&more]), other.replace("{ Y =", "{ \"left arm\" ="));
    let answer = rename(&main, &one, "\"Y\", \"W", "U");
    let changes = &answer["result"]["changes"];
    assert_eq!(edited(&one, &changes[&main]), one.replace("\"W\"", "\"U\"").replace("\"W..=", "\"U..="));
    assert_eq!(edited(&other, &changes[&more]), other.replace(" W =", " U ="));
    let refused = |answer: &Value| answer["error"]["message"].as_str().unwrap_or_default().to_owned();
    assert!(refused(&rename(&main, &one, "per-axis.Y", "W")).contains("another axis"));
    assert!(refused(&rename(&main, &one, "per-axis.Y", "A..=B")).contains("no name of an axis"));
    editor.end();
}

/// What can be included lies beside the file, or in a folder that one begins to write.
#[test]
fn files_to_include_are_completed() {
    let (desk, main, _) = desk();
    desk.put("devices/drive/other.toml", "");
    desk.put("devices/drive/notes.md", "");
    desk.put("devices/shared/brake.toml", "");
    let mut editor = Editor::start(&desk);
    let mut complete = |begun: &str| {
        let behind = format!("[\"more.toml\", {begun}");
        let text = MAIN.replace("[\"more.toml\"", &behind);
        editor.open(&main, &text);
        let list = editor.at("textDocument/completion", &main, &text, &behind[..behind.len() - 1]);
        let items = list["items"].as_array().cloned().unwrap_or_default();
        items.iter().map(|it| it["label"].as_str().unwrap_or_default().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(complete("\"\""), ["other.toml"], "not itself, nor what is there, nor another kind of file");
    assert_eq!(complete("\"../shared/\""), ["../shared/brake.toml"]);
    assert_eq!(complete("\"../\""), ["../drive/", "../shared/"]);
    assert!(complete("\"nowhere/\"").is_empty());
    editor.end();
}

#[test]
fn files_have_an_outline_and_a_layout() {
    let (desk, main, _) = desk();
    let mut editor = Editor::start(&desk);
    editor.open(&main, MAIN);
    let outline = editor.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": main } }));
    let names: Vec<&str> =
        outline.as_array().expect("a list").iter().filter_map(|it| it["name"].as_str()).collect();
    assert_eq!(
        names,
        ["device", "identity", "objects", "objects.0x6064", "objects.0x2000", "words.speed.bits"]
    );
    assert_eq!(outline[2]["children"][1]["name"], "0x6041");
    assert_eq!(outline[4]["detail"], "Speed");
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let about = json!({ "textDocument": { "uri": main }, "options": options });
    let edits = editor.ask("textDocument/formatting", about.clone());
    desk.devc(&["fmt", "devices/drive/device.toml"]).ends(0, &["laid out"]);
    assert_eq!(edited(MAIN, &edits), desk.read("devices/drive/device.toml"));
    editor.write(&main, "[device\n");
    assert_eq!(editor.ask("textDocument/formatting", about), Value::Null, "no TOML");
    assert_eq!(editor.answer("textDocument/nonsense", json!({}))["error"]["code"], -32601);
    editor.end();
}

/// An editor starts the server for every TOML file.
#[test]
fn files_of_no_description_are_left_alone() {
    let (desk, main, _) = desk();
    desk.put("Cargo.toml", "[package]\n");
    let other = uri(&fs::canonicalize(desk.path("Cargo.toml")).expect("a file"));
    let mut editor = Editor::start(&desk);
    editor.open(&other, "[package]\nname = \n");
    editor.open(&main, &MAIN.replace("access", "acess"));
    assert_eq!(editor.at("textDocument/completion", &other, "[package]\n", "[package]\n"), Value::Null);
    assert!(!editor.marks(&main).is_empty(), "the first messages are about the description");
    editor.end();
}

/// Each beginning of shipped files, as they were typed.
#[test]
fn whatever_is_half_written_is_answered() {
    let devices = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
    let desk = Desk::new(&[]);
    for entry in fs::read_dir(devices).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        desk.put(&format!("c887/{name}"), fs::read(path).expect("a file"));
    }
    let folder = fs::canonicalize(desk.path("c887")).expect("a folder");
    let mut editor = Editor::start(&desk);
    for file in ["device.toml", "pdos.toml", "modes.toml", "hexapod.toml"] {
        let (uri, whole) = (uri(&folder.join(file)), desk.read(&format!("c887/{file}")));
        editor.open(&uri, &whole);
        let ends = whole.char_indices().map(|(at, _)| at).step_by(29);
        for end in ends {
            let text = &whole[..end];
            editor.write(&uri, text);
            let place = place(&uri, text, text);
            for method in ["textDocument/completion", "textDocument/hover", "textDocument/definition"] {
                editor.ask(method, place.clone());
            }
            editor.ask("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
        }
        editor.write(&uri, &whole);
    }
    editor.end();
}

impl Editor {
    /// Waits until the server has compiled the description, by an answer that needs it.
    fn know(&mut self, uri: &str) {
        let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 0, "character": 0 } });
        let about =
            json!({ "textDocument": { "uri": uri }, "range": range, "context": { "diagnostics": [] } });
        self.ask("textDocument/codeAction", about);
    }
}
