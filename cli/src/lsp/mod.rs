//! `devc lsp`

mod action;
mod answer;
mod learn;
mod overlay;
mod profiles;
mod publish;
mod server;
mod state;
mod text;
mod uri;
mod worker;

use clap::Args;
use lsp_server::Connection;
use serde_json::json;

use super::outcome::{Failure, Outcome};
use super::report::Report;
use server::Server;

/// Help an editor to write descriptions, by the language server protocol on standard input and output.
///
/// It is started by editors; `compiler/docs/editors.md` says how to set them up.
#[derive(Debug, Args)]
pub(super) struct Lsp {
    /// What editors pass to servers that know several ways to be talked to; it is the only one.
    #[arg(long)]
    stdio: bool,
}

impl Lsp {
    pub(super) fn run(&self, _report: &Report) -> Result<Outcome, Failure> {
        let failure =
            |what: String| Failure::new(format!("the editor does not keep to the protocol: {what}"));
        let (connection, threads) = Connection::stdio();
        let (id, _) = connection.initialize_start().map_err(|error| failure(error.to_string()))?;
        let about = json!({ "capabilities": capabilities(), "serverInfo": {
            "name": "devc", "version": env!("CARGO_PKG_VERSION"),
        } });
        connection.initialize_finish(id, about).map_err(|error| failure(error.to_string()))?;
        let Connection { sender, receiver } = connection;
        let send = Box::new(move |message| {
            // an editor that has gone wants no more answers
            let _ = sender.send(message);
        });
        let outcome = Server::new(send).run(receiver.into_iter());
        threads.join().map_err(|error| failure(error.to_string()))?;
        Ok(outcome)
    }
}

/// What the server can do; positions count units of UTF-16, as all editors do.
fn capabilities() -> serde_json::Value {
    json!({
        "positionEncoding": "utf-16",
        "textDocumentSync": { "openClose": true, "change": 2, "save": {} },
        "completionProvider": { "triggerCharacters": ["\"", ".", "[", "=", " ", ":"] },
        "hoverProvider": true,
        "definitionProvider": true,
        "documentSymbolProvider": true,
        "renameProvider": { "prepareProvider": true },
        "codeActionProvider": { "codeActionKinds": ["quickfix"] },
        "documentFormattingProvider": true,
    })
}
