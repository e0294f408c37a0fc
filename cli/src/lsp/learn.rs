//! What a compilation tells, for the answers and for the editor.

use std::path::Path;

use devc::assist::Knowledge;

use super::publish::publish;
use super::state::State;
use super::worker::Compiled;

/// Brings what is known of a description up to date, for an answer that has to be right.
pub(super) fn refresh(state: &mut State, main: &Path) {
    if state.descriptions.get(main).is_some_and(|it| it.stale || it.compilation.is_none()) {
        let compiled = state.job(main).run();
        learn(state, compiled);
    }
}

/// Keeps what a compilation has found, and tells the editor what is wrong.
pub(super) fn learn(state: &mut State, compiled: Compiled) {
    let Compiled { main, compilation, versions } = compiled;
    let Some(mut description) = state.descriptions.remove(&main) else { return };
    let is_whole = !compilation.diagnostics.iter().any(|it| it.rule.name == "invalid-toml");
    if is_whole || description.knowledge.is_none() {
        description.knowledge = Knowledge::of(&compilation).or(description.knowledge);
    }
    // a file may have become a part of the description since it was opened
    let names = compilation.sources.iter().filter_map(|(id, _)| compilation.sources.name(id));
    for name in names {
        if let Some(open) = state.open.get_mut(name).filter(|open| open.main.is_none()) {
            open.main = Some(main.clone());
        }
    }
    publish(state, &main, &compilation, &versions, &mut description.marked);
    description.compilation = Some(compilation);
    state.descriptions.insert(main, description);
}
