//! What is open, what is known of it, and what comes in.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use devc::Compilation;
use devc::assist::Knowledge;
use devc::source::{Disk, Loader, MAIN_FILE, owner};
use lsp_server::{Message, Notification, Request, Response};
use lsp_types::{DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams};
use serde::de::DeserializeOwned;

use super::super::outcome::Outcome;
use super::overlay::Overlay;
use super::profiles::Profiles;
use super::text::Text;
use super::worker::{Compiled, Job, work};
use super::{answer, publish, uri};

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

/// A text in the editor.
pub(super) struct Open {
    /// The file as the editor names it.
    pub(super) uri: String,
    pub(super) text: Text,
    pub(super) version: i32,
    /// The `device.toml` of its description; none if it is of none.
    pub(super) main: Option<PathBuf>,
}

/// A description of which something is open.
#[derive(Default)]
pub(super) struct Description {
    pub(super) compilation: Option<Compilation>,
    /// Of the last compilation that could read the files.
    pub(super) knowledge: Option<Knowledge>,
    /// Whether something has changed since it was given to be compiled.
    stale: bool,
    /// The files that have messages in the editor.
    pub(super) marked: BTreeSet<PathBuf>,
}

pub(super) struct Server {
    send: Box<dyn Fn(Message)>,
    /// By the one name of their file.
    pub(super) open: BTreeMap<PathBuf, Open>,
    /// By their `device.toml`.
    pub(super) descriptions: BTreeMap<PathBuf, Description>,
    pub(super) profiles: Profiles,
    is_shut_down: bool,
}

impl Server {
    pub(super) fn new(send: Box<dyn Fn(Message)>) -> Self {
        let (open, descriptions, profiles) = (BTreeMap::new(), BTreeMap::new(), Profiles::default());
        Self { send, open, descriptions, profiles, is_shut_down: false }
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
        thread::spawn(move || work(&waiting, &results));
        self.attend(&happening, &jobs)
    }

    fn attend(&mut self, events: &Receiver<Event>, jobs: &Sender<Job>) -> Outcome {
        let mut is_busy = false;
        loop {
            let stale = self.descriptions.iter().find(|(_, description)| description.stale);
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
                    self.learn(*compiled);
                }
                (Err(RecvTimeoutError::Timeout), Some(main)) => {
                    is_busy = jobs.send(self.job(&main)).is_ok();
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
                (self.send)(Message::Response(response));
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
        match answer::answer(self, &request.method, request.params) {
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
                    if let Some(open) = self.open.get_mut(&name) {
                        open.version = it.version;
                        open.text =
                            content_changes.into_iter().fold(open.text.clone(), |text, it| text.changed(it));
                    }
                    self.changed(&name);
                }
            }
            "textDocument/didClose" => {
                if let Some(DidCloseTextDocumentParams { text_document: it }) = read(notification) {
                    self.closed(it.uri.as_str());
                }
            }
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => self.all_stale(),
            _ => {}
        }
    }

    fn opened(&mut self, uri: &str, text: &str, version: i32) {
        let Some(name) = name(uri) else { return };
        let open = Open { uri: uri.to_owned(), text: Text::new(text), version, main: None };
        self.open.insert(name.clone(), open);
        self.find_main(&name);
        self.changed(&name);
    }

    /// Finds the description of a file, if it has none yet.
    fn find_main(&mut self, name: &Path) {
        if self.profiles.has(name) {
            return;
        }
        let is_main = name.file_name().is_some_and(|file| file == MAIN_FILE);
        let overlay = self.overlay();
        let main = owner(&overlay, name).or_else(|| is_main.then(|| name.to_owned()));
        if let Some(main) = &main {
            self.descriptions.entry(main.clone()).or_default();
        }
        if let Some(open) = self.open.get_mut(name) {
            open.main = main;
        }
    }

    fn changed(&mut self, name: &Path) {
        let main = self.open.get(name).and_then(|open| open.main.clone());
        if let Some(description) = main.and_then(|main| self.descriptions.get_mut(&main)) {
            description.stale = true;
        }
    }

    /// A file that is not open any more is what it is on the disk.
    fn closed(&mut self, uri: &str) {
        let Some(closed) = name(uri).and_then(|name| self.open.remove(&name)) else { return };
        let Some(main) = closed.main else { return };
        if self.open.values().any(|open| open.main.as_ref() == Some(&main)) {
            if let Some(description) = self.descriptions.get_mut(&main) {
                description.stale = true;
            }
        } else if let Some(description) = self.descriptions.remove(&main) {
            publish::clear(self, &description.marked);
        }
    }

    fn all_stale(&mut self) {
        let names: Vec<PathBuf> =
            self.open.iter().filter(|(_, it)| it.main.is_none()).map(|(it, _)| it.clone()).collect();
        names.iter().for_each(|name| self.find_main(name));
        self.descriptions.values_mut().for_each(|description| description.stale = true);
    }

    fn job(&mut self, main: &Path) -> Job {
        if let Some(description) = self.descriptions.get_mut(main) {
            description.stale = false;
        }
        let versions = self.open.iter().map(|(name, open)| (name.clone(), open.version)).collect();
        Job { main: main.to_owned(), overlay: self.overlay(), versions }
    }

    /// Brings what is known of a description up to date, for an answer that has to be right.
    pub(super) fn refresh(&mut self, main: &Path) {
        if self.descriptions.get(main).is_some_and(|it| it.stale || it.compilation.is_none()) {
            let compiled = self.job(main).run();
            self.learn(compiled);
        }
    }

    fn learn(&mut self, compiled: Compiled) {
        let Compiled { main, compilation, versions } = compiled;
        let Some(mut description) = self.descriptions.remove(&main) else { return };
        let is_whole = !compilation.diagnostics.iter().any(|it| it.rule.name == "invalid-toml");
        if is_whole || description.knowledge.is_none() {
            description.knowledge = Knowledge::of(&compilation).or(description.knowledge);
        }
        // a file may have become a part of the description since it was opened
        let names = compilation.sources.iter().filter_map(|(id, _)| compilation.sources.name(id));
        for name in names {
            if let Some(open) = self.open.get_mut(name).filter(|open| open.main.is_none()) {
                open.main = Some(main.clone());
            }
        }
        publish::publish(self, &main, &compilation, &versions, &mut description.marked);
        description.compilation = Some(compilation);
        self.descriptions.insert(main, description);
    }

    pub(super) fn overlay(&self) -> Overlay {
        Overlay(self.open.iter().map(|(name, open)| (name.clone(), open.text.text.clone())).collect())
    }

    /// The address of a file, as the editor has it if it is open.
    pub(super) fn uri(&self, name: &Path) -> String {
        self.open.get(name).map_or_else(|| uri::uri(name), |open| open.uri.clone())
    }

    pub(super) fn notify(&self, method: &str, params: serde_json::Value) {
        (self.send)(Message::Notification(Notification { method: method.to_owned(), params }));
    }
}

/// The one name of a file that an editor names.
pub(super) fn name(uri: &str) -> Option<PathBuf> {
    let path = uri::path(uri)?;
    Some(Disk.canonical(&path).unwrap_or(path))
}

fn read<P: DeserializeOwned>(notification: Notification) -> Option<P> {
    serde_json::from_value(notification.params).ok()
}
