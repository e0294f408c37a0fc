//! Chromium without a window.

use std::fs;
use std::process::{Command, Output, Stdio};
use std::sync::Mutex;

use serde_json::Value;

/// One browser at a time, so that small machines keep up.
static TURN: Mutex<()> = Mutex::new(());

/// A browser that is installed.
pub(crate) struct Browser(&'static str);

impl Browser {
    /// The browser, if there is one.
    pub(crate) fn find() -> Option<Self> {
        let names = ["chromium", "chromium-browser", "google-chrome"];
        let is_there = |name: &&&str| {
            let mut command = Command::new(name);
            command.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
            command.status().is_ok_and(|status| status.success())
        };
        let found = names.iter().find(is_there).map(|name| Self(name));
        if found.is_none() {
            eprintln!("no Chromium is installed: pages are not looked at");
        }
        found
    }

    /// The document as it is once the page has run, opened by a link into it.
    pub(crate) fn open(&self, page: &str, fragment: &str) -> String {
        let output = self.run(page, fragment, &["--dump-dom"]);
        String::from_utf8(output.stdout).expect("a document is text")
    }

    /// What a script says of the page: the JSON of what its function returns, or promises.
    pub(crate) fn ask(&self, page: &str, before: &str, function: &str) -> Value {
        // the policy forbids other scripts, which is the point of it
        let open = page.replacen("http-equiv=\"Content-Security-Policy\"", "name=\"policy\"", 1);
        let asked = format!(
            "<p id=\"answer\"></p><script>{before}</script><script>\
             Promise.resolve().then(() => {{ {function} }}).catch((error) => String(error)).then((answer) => {{\
             document.getElementById(\"answer\").textContent = encodeURIComponent(JSON.stringify(answer)); }});\
             </script></body>"
        );
        let (body, _) = open.rsplit_once("</body>").expect("a page has a body");
        let document = self.open(&format!("{body}{asked}"), "");
        let answer = percent_decoded(&text_of(&document, "answer"));
        serde_json::from_str(&answer).unwrap_or_else(|error| panic!("{error}: {answer}"))
    }

    /// What the page, or the policy of the page, writes to the console.
    pub(crate) fn complaints(&self, page: &str) -> Vec<String> {
        let output = self.run(page, "", &["--dump-dom", "--enable-logging=stderr"]);
        let lines = String::from_utf8_lossy(&output.stderr).into_owned();
        lines.lines().filter(|line| line.contains(":CONSOLE")).map(str::to_owned).collect()
    }

    fn run(&self, page: &str, fragment: &str, arguments: &[&str]) -> Output {
        let _turn = TURN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("page.html");
        fs::write(&path, page).expect("a file");
        let profile = format!("--user-data-dir={}", folder.path().join("profile").display());
        let output = Command::new(self.0)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=20000", &profile])
            .args(arguments)
            .arg(format!("file://{}#{fragment}", path.display()))
            .output()
            .expect("the browser runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        output
    }
}

/// A text as it was before `encodeURIComponent`.
fn percent_decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        let digit = |byte: Option<u8>| char::from(byte.expect("two digits")).to_digit(16).expect("a digit");
        bytes.push(match byte {
            b'%' => u8::try_from(digit(rest.next()) * 16 + digit(rest.next())).expect("a byte"),
            other => other,
        });
    }
    String::from_utf8(bytes).expect("UTF-8")
}

/// The text of the element of an id.
pub(crate) fn text_of(document: &str, id: &str) -> String {
    let (before, rest) = document.split_once(&format!("id=\"{id}\"")).expect("the element is there");
    let name =
        before.rsplit('<').next().and_then(|tag| tag.split_whitespace().next()).expect("a tag has a name");
    let (_, inside) = rest.split_once('>').expect("a tag ends");
    let inside = inside.split(&format!("</{name}>")).next().unwrap_or_default();
    let mut text = String::new();
    for part in inside.split('<') {
        let shown = part.split_once('>').map_or(part, |(_, shown)| shown);
        text.push_str(shown);
        text.push(' ');
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
