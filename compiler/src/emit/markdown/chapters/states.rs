//! The state machine of the drive.

pub(super) mod control;

use crate::emit::markdown::context::Context;
use crate::emit::markdown::holds::Form;
use crate::emit::markdown::inline::{self, code, list, text};
use crate::emit::markdown::machine::Machine;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Answer, Command, DeviceControl, Event, Pattern, Scope, State, Transition};

/// The state machine of the drive.
pub(super) fn page(
    context: &Context<'_>,
    states: &[State],
    commands: &[Command],
    transitions: &[Transition],
    control: Option<&DeviceControl>,
) -> Page {
    let mut page = Page::default();
    if states.is_empty() && commands.is_empty() && transitions.is_empty() {
        return page;
    }
    Machine::of(context.device).into_iter().for_each(|machine| page.machine(machine));
    page.titled("States", state_table(context, states));
    page.titled("What works in which state", functions(context, states));
    if !commands.is_empty() {
        page.heading(3, "Commands");
        page.table(command_table(context, commands));
        page.text(PATTERNS);
    }
    page.titled("Transitions", transition_table(context, transitions));
    control.iter().for_each(|control| control::commands(context, control, &mut page));
    page
}

/// How patterns of bits are to be read.
const PATTERNS: &str = "In patterns `x` is a bit that does not matter, `r` a rising and `f` a falling edge; the highest bit \
                        comes first.";

fn state_table(context: &Context<'_>, states: &[State]) -> Table {
    let statusword = word(context, "statusword", "Statusword");
    let titles = ["State", &statusword, "Mask", "Value", "Meaning", "Source"];
    Table::of(titles, states, |state| {
        let hex = |bits: fn(&Pattern) -> u16| {
            state.pattern.as_ref().map_or(String::new(), |pattern| code(format!("0x{:04X}", bits(pattern))))
        };
        [
            format!("**{}**", text(&state.name)),
            pattern(state.pattern.as_ref()),
            hex(Pattern::mask),
            hex(Pattern::value),
            state_meaning(context, state),
            context.said(state.source.as_ref(), &state.origin),
        ]
    })
}

/// The word of an id with a link, as the title of a column.
fn word(context: &Context<'_>, id: &str, title: &str) -> String {
    match context.device.word(id) {
        Some(word) => format!("[{title}](#{})", context.word_id(&word.id)),
        None => title.into(),
    }
}

fn pattern(pattern: Option<&Pattern>) -> String {
    pattern.map_or(String::new(), code)
}

fn state_meaning(context: &Context<'_>, state: &State) -> String {
    // What is left out has columns of its own.
    let State {
        about,
        features,
        causes,
        id: _,
        name: _,
        pattern: _,
        brake: _,
        low_level_power: _,
        high_level_power: _,
        drive_function: _,
        configuration: _,
        source: _,
        origin: _,
    } = state;
    let about = about.iter().map(|about| context.prose(about));
    let features = features.iter().map(|feature| context.prose(feature));
    let causes = causes.iter().map(|cause| format!("entered by: {}", context.prose(cause)));
    about.chain(features).chain(causes).collect::<Vec<_>>().join("<br>")
}

fn functions(context: &Context<'_>, states: &[State]) -> Table {
    let titles =
        ["State", "Brake applied", "Control power", "Motor power", "Drive function", "Configuration"];
    let told = states.iter().filter(|state| answers(state).iter().any(Option::is_some));
    Table::of(titles, told, |state| {
        let keys = ["brake", "low-level-power", "high-level-power", "drive-function", "configuration"];
        let mut marks = keys.map(|key| context.mark(&state.origin, key)).into_iter();
        let marked = |of| answer(of) + &marks.next().unwrap_or_default();
        let [brake, low, high, function, configuration] = answers(state).map(marked);
        [format!("**{}**", text(&state.name)), brake, low, high, function, configuration]
    })
}

fn answers(state: &State) -> [Option<Answer>; 5] {
    [state.brake, state.low_level_power, state.high_level_power, state.drive_function, state.configuration]
}

fn answer(answer: Option<Answer>) -> String {
    match answer {
        None => String::new(),
        Some(Answer::Yes) => "✓".into(),
        Some(Answer::No) => "–".into(),
        Some(Answer::IfRequired) => "if required".into(),
    }
}

fn command_table(context: &Context<'_>, commands: &[Command]) -> Table {
    let controlword = word(context, "controlword", "Controlword");
    let titles = ["Command", &controlword, "Transitions", "What it does", "Ignored in", "Source"];
    Table::of(titles, commands, |command: &Command| {
        let Command { id: _, name, pattern, transitions, about, ignored_in, source, origin } = command;
        [
            format!("**{}**", text(name)),
            self::pattern(pattern.as_ref()),
            list(transitions.iter().map(u8::to_string)),
            context.optional(about.as_deref()),
            list(ignored_in.iter().map(|id| context.state(id))),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn transition_table(context: &Context<'_>, transitions: &[Transition]) -> Table {
    let titles = ["No.", "From", "To", "Set off by", "Axes", "Power level", "What happens", "Source"];
    Table::of(titles, transitions, |transition| {
        [
            format!("{}**{}**", anchor(context, transition), transition.number),
            from(context, transition),
            context.state(&transition.to),
            cause(context, transition),
            scope(transition.axes).into(),
            transition.power.as_deref().map_or(String::new(), text),
            effect(context, transition),
            context.said(transition.source.as_ref(), &transition.origin),
        ]
    })
}

/// Where the arrows of the picture lead to, which a text has not.
fn anchor(context: &Context<'_>, transition: &Transition) -> String {
    match context.form {
        Form::Text => String::new(),
        Form::Page => inline::anchor(format!("transition-{}", transition.number)),
    }
}

fn from(context: &Context<'_>, transition: &Transition) -> String {
    match &*transition.from {
        [] if transition.number == 0 => "*start*".into(),
        [] => "*any state*".into(),
        states => states.iter().map(|id| context.state(id)).collect::<Vec<_>>().join("<br>"),
    }
}

fn scope(axes: Option<Scope>) -> &'static str {
    match axes {
        None => "",
        Some(Scope::All) => "all must",
        Some(Scope::Any) => "one is enough",
    }
}

/// The command, the bits or the events that make the drive make a transition.
fn cause(context: &Context<'_>, transition: &Transition) -> String {
    let commands = context.commands(transition.number).chain(transition.command.as_deref()).map(text);
    let pattern = transition.pattern.iter().map(code);
    let automatic = transition.automatic.then(|| "*automatic*".into());
    let events = transition.events.iter().map(|event| format!("*{}*", event.name()));
    commands.chain(pattern).chain(automatic).chain(events).collect::<Vec<_>>().join("<br>")
}

fn effect(context: &Context<'_>, transition: &Transition) -> String {
    // What is left out has columns of its own.
    let Transition {
        supported,
        about,
        conditions,
        causes,
        interlocks,
        number: _,
        from: _,
        to: _,
        automatic: _,
        pattern: _,
        command: _,
        events: _,
        axes: _,
        power: _,
        source: _,
        origin: _,
    } = transition;
    let refused = (!supported).then(|| "**not supported**".into());
    let about = about.iter().map(|about| context.prose(about));
    let conditions = conditions.iter().map(|condition| format!("waits for: {}", context.prose(condition)));
    let causes = causes.iter().map(|cause| format!("set off by: {}", context.prose(cause)));
    let blocked = (!interlocks.is_empty()).then(|| {
        format!("no command while: {}", list(interlocks.iter().map(|event| Event::name(*event).to_owned())))
    });
    let parts = refused.into_iter().chain(about).chain(conditions).chain(blocked).chain(causes);
    parts.collect::<Vec<_>>().join("<br>")
}
