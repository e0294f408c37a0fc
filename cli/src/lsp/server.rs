//! What comes in, and what is done about it.

use std::collections::BTreeMap;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use lsp_server::{Message, Notification, Request, Response};
use lsp_types::{DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams};
use serde::de::DeserializeOwned;

use super::super::outcome::Outcome;
use super::learn::learn;
use super::profiles::Profiles;
use super::state::{Open, State, name};
use super::text::Text;
use super::worker::{Compiled, Job, work};
use super::{answer, publish};

/// How long nothing has to come in before a description is compiled: nobody who types is interested in what is wrong
/// with half a word.
const PAUSE: Duration = Duration::from_millis(60);

/// Something that happens.
pub(super) enum Event {
    Message(Message),
    Compiled(Box<Compiled>),
    /// The editor has gone.
    Closed,
}

/// The server: what it keeps, and whether it has been told to stop.
pub(super) struct Server {
    state: State,
    is_shut_down: bool,
}

impl Server {
    pub(super) fn new(send: Box<dyn Fn(Message)>) -> Self {
        let (open, descriptions, profiles) = (BTreeMap::new(), BTreeMap::new(), Profiles::default());
        Self { state: State { send, open, descriptions, profiles }, is_shut_down: false }
    }

    /// Attends to all that comes in until the editor says that it is enough.
    pub(super) fn run(mut self, mut messages: impl Iterator<Item = Message> + Send + 'static) -> Outcome {
        let (events, happening) = mpsc::channel();
        let (jobs, waiting) = mpsc::channel();
        let (inbox, results) = (events.clone(), events);
        thread::spawn(move || {
            let _ = messages.all(|message| inbox.send(Event::Message(message)).is_ok());
            let _ = inbox.send(Event::Closed);
        });
        thread::spawn(move || {
            work(&waiting, |compiled| results.send(Event::Compiled(Box::new(compiled))).is_ok());
        });
        self.attend(&happening, &jobs)
    }

    fn attend(&mut self, events: &Receiver<Event>, jobs: &Sender<Job>) -> Outcome {
        let mut is_busy = false;
        loop {
            let stale = self.state.descriptions.iter().find(|(_, description)| description.stale);
            let stale = stale.map(|(main, _)| main.clone()).filter(|_| !is_busy);
            let event = match &stale {
                Some(_) => events.recv_timeout(PAUSE),
                None => events.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match (event, stale) {
                (Ok(Event::Message(Message::Notification(note))), _) if note.method == "exit" => break,
                (Ok(Event::Message(message)), _) => self.message(message),
                (Ok(Event::Compiled(compiled)), _) => {
                    is_busy = false;
                    learn(&mut self.state, *compiled);
                }
                (Err(RecvTimeoutError::Timeout), Some(main)) => {
                    is_busy = jobs.send(self.state.job(&main)).is_ok();
                }
                (Ok(Event::Closed) | Err(_), _) => break,
            }
        }
        if self.is_shut_down { Outcome::Clean } else { Outcome::Findings }
    }

    fn message(&mut self, message: Message) {
        match message {
            Message::Request(request) => {
                let response = self.request(request);
                (self.state.send)(Message::Response(response));
            }
            Message::Notification(notification) => self.notification(notification),
            Message::Response(_) => {}
        }
    }

    fn request(&mut self, request: Request) -> Response {
        if request.method == "shutdown" {
            self.is_shut_down = true;
            return Response::new_ok(request.id, ());
        }
        match answer::answer(&mut self.state, &request.method, request.params) {
            Ok(value) => Response::new_ok(request.id, value),
            Err((code, message)) => Response::new_err(request.id, code as i32, message),
        }
    }

    fn notification(&mut self, notification: Notification) {
        match notification.method.as_str() {
            "textDocument/didOpen" => {
                if let Some(DidOpenTextDocumentParams { text_document: it }) = read(notification) {
                    self.opened(it.uri.as_str(), &it.text, it.version);
                }
            }
            "textDocument/didChange" => {
                if let Some(DidChangeTextDocumentParams { text_document: it, content_changes }) =
                    read(notification)
                {
                    let Some(name) = name(it.uri.as_str()) else { return };
                    if let Some(open) = self.state.open.get_mut(&name) {
                        open.version = it.version;
                        open.text =
                            content_changes.into_iter().fold(open.text.clone(), |text, it| text.changed(it));
                    }
                    self.state.changed(&name);
                }
            }
            "textDocument/didClose" => {
                if let Some(DidCloseTextDocumentParams { text_document: it }) = read(notification) {
                    self.closed(it.uri.as_str());
                }
            }
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => self.state.all_stale(),
            _ => {}
        }
    }

    fn opened(&mut self, uri: &str, text: &str, version: i32) {
        let Some(name) = name(uri) else { return };
        let open = Open { uri: uri.to_owned(), text: Text::new(text), version, main: None };
        self.state.open.insert(name.clone(), open);
        self.state.find_main(&name);
        self.state.changed(&name);
    }

    /// A file that is not open any more is what it is on the disk.
    fn closed(&mut self, uri: &str) {
        let Some(closed) = name(uri).and_then(|name| self.state.open.remove(&name)) else { return };
        let Some(main) = closed.main else { return };
        if self.state.open.values().any(|open| open.main.as_ref() == Some(&main)) {
            if let Some(description) = self.state.descriptions.get_mut(&main) {
                description.stale = true;
            }
        } else if let Some(description) = self.state.descriptions.remove(&main) {
            publish::clear(&self.state, &description.marked);
        }
    }
}

fn read<P: DeserializeOwned>(notification: Notification) -> Option<P> {
    serde_json::from_value(notification.params).ok()
}
