//! The EtherCAT states, the sync managers and the mailbox.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::{bytes, duration};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::picture;
use crate::emit::markdown::table::Table;
use crate::model::{
    AbortCode, AlStatusCode, CommunicationState, CommunicationTransition, Mailbox, Role, SyncManager,
    Timeouts,
};

/// The parts of a device that the link layer is about.
pub(super) struct Link<'d> {
    pub(super) communication_states: &'d [CommunicationState],
    pub(super) communication_transitions: &'d [CommunicationTransition],
    pub(super) al_status_codes: &'d [AlStatusCode],
    pub(super) abort_codes: &'d [AbortCode],
    pub(super) sync_managers: &'d [SyncManager],
    pub(super) mailbox: &'d Option<Mailbox>,
    pub(super) timeouts: &'d Option<Timeouts>,
}

/// How the device and the master come to speak to one another.
pub(super) fn page(context: &Context<'_>, link: &Link<'_>) -> Page {
    let mut page = Page::default();
    let Link {
        communication_states: states,
        communication_transitions: transitions,
        al_status_codes: codes,
        abort_codes,
        sync_managers: managers,
        mailbox,
        timeouts,
    } = link;
    if !(states.is_empty() && transitions.is_empty()) {
        page.heading(3, "EtherCAT states");
        page.table(state_table(context, states));
        page.table(transition_table(context, states, transitions));
    }
    page.titled("Why a state is refused or left", al_status_codes(context, codes));
    page.titled("Why an SDO transfer ends", self::abort_codes(context, abort_codes));
    page.titled("Sync managers", sync_managers(context, managers));
    if !managers.is_empty() {
        context.picture(&mut page, || picture::memory(managers));
    }
    page.titled("Mailbox", mailbox.as_ref().map(|mailbox| services(context, mailbox)).unwrap_or_default());
    page.titled("Timeouts", timeouts.as_ref().map(|timeouts| waits(context, timeouts)).unwrap_or_default());
    page
}

fn state_table(context: &Context<'_>, states: &[CommunicationState]) -> Table {
    Table::of(["Code", "State", "What the device does", "Source"], states, |state| {
        [
            code(state.code),
            format!("**{}**", text(&state.name)),
            context.optional(state.about.as_deref()),
            context.said(state.source.as_ref(), &state.origin),
        ]
    })
}

fn transition_table(
    context: &Context<'_>,
    states: &[CommunicationState],
    rows: &[CommunicationTransition],
) -> Table {
    let name = |id: &str| text(states.iter().find(|state| state.id == id).map_or(id, |state| &state.name));
    Table::of(["Change", "From", "To", "What the device does", "Source"], rows, |change| {
        [
            code(&change.id),
            name(&change.from),
            name(&change.to),
            context.optional(change.about.as_deref()),
            context.said(change.source.as_ref(), &change.origin),
        ]
    })
}

fn abort_codes(context: &Context<'_>, codes: &[AbortCode]) -> Table {
    Table::of(["Code", "Reason", "Notes", "Source"], codes, |abort| {
        let AbortCode { code: number, name, about, source, origin } = abort;
        [
            code(format!("0x{number:08X}")),
            format!("**{}**", text(name)),
            context.optional(about.as_deref()),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn al_status_codes(context: &Context<'_>, codes: &[AlStatusCode]) -> Table {
    let titles = ["Code", "AL status", "During", "State afterwards", "Notes", "Source"];
    Table::of(titles, codes, |status| {
        [
            code(format!("0x{:04X}", status.code)),
            format!("**{}**", text(&status.name)),
            list(status.during.iter().map(|change| text(change))),
            status.results.as_deref().map_or(String::new(), text),
            context.optional(status.about.as_deref()),
            context.said(status.source.as_ref(), &status.origin),
        ]
    })
}

fn sync_managers(context: &Context<'_>, managers: &[SyncManager]) -> Table {
    let titles = [
        "SM",
        "Carries",
        "Address",
        "Size",
        "At least",
        "At most",
        "Control",
        "On",
        "PDOs by default",
        "PDOs at most",
        "Source",
    ];
    Table::of(titles, managers, |manager| {
        let SyncManager { id: _, number, role, address, size, control, pdos, slots, source, origin, .. } =
            manager;
        let limit = |size: Option<u16>| size.map_or(String::new(), |size| bytes(size.into()));
        [
            number.to_string(),
            carries(*role).into(),
            code(format!("0x{address:04X}")),
            bytes((*size).into()),
            limit(manager.min_size),
            limit(manager.max_size),
            code(format!("0x{control:02X}")),
            on(manager).into(),
            list(pdos.iter().map(|pdo| context.index(*pdo))),
            if *slots == 0 { String::new() } else { slots.to_string() },
            context.said(source.as_ref(), origin),
        ]
    })
}

/// When a sync manager is on, if that is not always.
fn on(manager: &SyncManager) -> &'static str {
    match (manager.enable, manager.op_only) {
        _ if manager.r#virtual => "for tools only",
        (false, _) => "no",
        (true, true) => "in Operational only",
        (true, false) => "",
    }
}

fn carries(role: Role) -> &'static str {
    match role {
        Role::MailboxOut => "mail from the master",
        Role::MailboxIn => "mail to the master",
        Role::Outputs => "outputs: process data from the master",
        Role::Inputs => "inputs: process data to the master",
    }
}

fn services(context: &Context<'_>, mailbox: &Mailbox) -> Table {
    let Mailbox {
        protocols,
        sdo_info,
        pdo_assign,
        pdo_config,
        complete_access,
        segmented,
        source,
        origin,
        ..
    } = mailbox;
    let answer = |yes: &bool| String::from(if *yes { "yes" } else { "no" });
    let rows = [
        ("Protocols", list(protocols.iter().map(|protocol| text(protocol.name())))),
        ("Reading out the dictionary (SDO information)", answer(sdo_info)),
        ("Choosing PDOs (0x1C12, 0x1C13)", answer(pdo_assign)),
        ("Changing what PDOs map", answer(pdo_config)),
        ("Complete access", answer(complete_access)),
        ("Segmented transfer", answer(segmented)),
    ];
    let others = [
        ("Telling by upload what PDOs map", mailbox.pdo_upload),
        ("Routing ADS messages", mailbox.aoe_router),
        ("Making its own net id", mailbox.aoe_generates_net_id),
        ("Setting the net id", mailbox.aoe_initialize_net_id),
        ("Setting the IP address", mailbox.eoe_ip),
        ("Setting the MAC address", mailbox.eoe_mac),
    ];
    let others = others.into_iter().filter_map(|(name, able)| Some((name, answer(&able?))));
    let rows = rows.into_iter().chain(others);
    let source = context.said(source.as_ref(), origin);
    Table::of(["Mailbox", "Supported", "Source"], rows, |(name, value)| [name.into(), value, source.clone()])
}

/// How long a master waits, and for what.
fn waits(context: &Context<'_>, timeouts: &Timeouts) -> Table {
    let Timeouts { pre_op, safe_op_op, back_to_init, back_to_safe_op, request, response, source, origin } =
        timeouts;
    let rows = [
        ("Pre-Operational", pre_op),
        ("Safe-Operational and Operational", safe_op_op),
        ("back to Init", back_to_init),
        ("back to Safe-Operational", back_to_safe_op),
        ("a request by mail to be read", request),
        ("a request by mail to be answered", response),
    ];
    let rows = rows.into_iter().filter_map(|(what, time)| Some((what, time.as_ref()?.0)));
    let source = context.said(source.as_ref(), origin);
    Table::of(["A master waits for", "At most", "Source"], rows, |(what, time)| {
        [what.into(), duration(time), source.clone()]
    })
}
