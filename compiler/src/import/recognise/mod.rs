//! What an ESI file means, in the words of a description.

mod assigned;
mod axes;
mod axis_names;
mod carried;
mod channels;
mod choices;
mod chosen;
mod clocks;
mod derived;
mod described;
mod diagnosis;
mod draft;
mod entries;
mod family;
mod head;
mod listed;
mod literal;
mod mailbox;
mod modes;
mod objects;
mod pdos;
mod profile;
mod references;
mod restated;
mod slots;
mod start_up;
mod sync_managers;
mod types;
mod units;
mod value;
mod words;

pub(super) use axis_names::take_out;
pub(super) use draft::{Block, Draft};
pub(super) use family::family;

use std::collections::BTreeSet;

use super::read::{Device, Esi, InitCmd, Object, Pdo};
use super::report::Report;
use super::toml::Toml;
use crate::model::ids::Siblings;
use axes::Axes;
use derived::Basis;
use described::Described;
use pdos::Way;
use profile::Known;
use references::References;
use sync_managers::Manager;
use units::Units;

/// A device as a description.
pub(super) fn device(esi: &Esi, device: &Device, report: &mut Report) -> Draft {
    let profiles = if is_drive(device) { vec!["ethercat", "cia402"] } else { vec!["ethercat"] };
    let known = Known::of(&profiles);
    let rx = pdos::possible(&device.rx_pdos, Way::Rx, &[], report);
    let tx = pdos::possible(&device.tx_pdos, Way::Tx, &rx, report);
    let managers = sync_managers::managers(&device.sync_managers, report);
    let basis = basis(device, [&rx, &tx], &managers);
    let (made, own): (Vec<&Object>, Vec<&Object>) =
        distinct(device, report).into_iter().partition(|object| derived::follows(object, &basis));
    let units = Units::of(device);
    let mut described: Vec<Described> =
        own.into_iter().filter_map(|object| described::described(object, &units, report)).collect();
    described.sort_by_key(|object| object.index);
    kept_by_tools(device, &mut described, report);
    if device.hides_mapping {
        without(&mut described, &["pdo"]);
    }
    let mut draft = Draft { profiles, picture: device.picture.clone(), ..Draft::default() };
    draft.device = head::blocks(esi, device, report);
    let axes = Axes::of(&described, &device.slots, [&rx, &tx]);
    if axes.names().is_empty() {
        carried::leave_out(&mut described, [&rx, &tx], &known);
    }
    let references = References::of(&described, &made, &known, &axes);
    let of_axes = channels::channels(device, &described, &axes, report);
    restated::leave_out(&mut described, esi, device, axes.names().len());
    draft.device.extend(axes.block(&described, of_axes, report));
    draft.device.extend(slots::modules(device, &axes, report));
    draft.device.extend(slots::open(device, report));
    draft.device.extend(units.blocks());
    draft.device.extend(modes::modes(&described, &axes, &known));
    for object in described.iter().filter(|object| !axes.repeats(object.index)) {
        let (mut block, without) = objects::block(object, &known, report);
        axes.complete(object.index, &mut block);
        draft.objects.push(block);
        draft.without.extend(without);
    }
    process_data(device, &made, (&references, &axes, &known), &basis, &mut draft, report);
    draft.objects.sort_by(|one, other| one.key.cmp(&other.key));
    let carriers = clocks::Carriers { managers: &managers, pdos: [&rx, &tx] };
    draft.device.extend(clocks::sync_modes(&device.op_modes, &carriers, report));
    let mut ids = Siblings::default();
    let surroundings = chosen::Surroundings { references: &references, axes: &axes, basis: &basis };
    let commands: Vec<&InitCmd> = device.mailbox.iter().flat_map(|mailbox| &mailbox.commands).collect();
    draft.device.extend(start_up::configuration(&commands, &surroundings, &mut ids, report));
    draft.device.extend(choices::configurations(&device.alternatives, &carriers, &mut ids, report));
    draft.diagnosis = diagnosis::blocks(&device.messages, report);
    draft
}

/// A file that says of no value whether tools save it leaves that to the profiles.
fn kept_by_tools(device: &Device, described: &mut [Described], report: &mut Report) {
    let values = || device.objects.iter().flat_map(|object| &object.values);
    if values().any(|value| value.flags.backup || value.flags.setting) {
        return;
    }
    if let Some(first) = device.objects.first() {
        report.guess(
            first.at,
            "what tools save",
            "the file says it of no value; what the profiles say is taken",
        );
    }
    without(described, &["backup", "setting"]);
}

/// Leaves keys out of which the file knows nothing.
fn without(described: &mut [Described], keys: &[&str]) {
    for value in described.iter_mut().flat_map(|object| &mut object.values) {
        value.keys.retain(|(name, _)| !keys.contains(&name.as_str()));
    }
}

/// What the objects follow from that devc makes.
fn basis<'b>(device: &'b Device, [rx, tx]: [&'b [&'b Pdo]; 2], managers: &'b [Manager<'b>]) -> Basis<'b> {
    let mailbox = device.mailbox.as_ref();
    Basis {
        rx,
        tx,
        managers,
        assigns: mailbox.is_some_and(|mailbox| mailbox.pdo_assign),
        maps: mailbox.is_some_and(|mailbox| mailbox.pdo_config),
    }
}

/// Whether it speaks CiA 402: by its profile, or by control word and status word.
fn is_drive(device: &Device) -> bool {
    let has = |index| {
        let word = |object: &&Object| {
            object.index == index && object.values.first().is_some_and(|it| it.bits == Some(16))
        };
        device.objects.iter().any(|object| word(&object))
    };
    device.profile == Some(402) || has(0x6040) && has(0x6041)
}

/// The objects, each index once.
fn distinct<'d>(device: &'d Device, report: &mut Report) -> Vec<&'d Object> {
    let mut seen = BTreeSet::new();
    let mut distinct = Vec::new();
    for object in &device.objects {
        if seen.insert(object.index) {
            distinct.push(object);
        } else {
            let what = format!("a second object 0x{:04X}", object.index);
            report.lose(object.at, 3, what, "there is one of this index already");
        }
    }
    distinct
}

/// PDOs, sync managers, the mailbox, and the objects that follow from them.
fn process_data(
    device: &Device,
    made: &[&Object],
    (references, axes, known): (&References, &Axes, &Known),
    basis: &Basis<'_>,
    draft: &mut Draft,
    report: &mut Report,
) {
    let mut followers = BTreeSet::new();
    let Basis { rx, tx, .. } = *basis;
    if let Some(first) = rx.iter().chain(tx).next().filter(|_| rx.iter().chain(tx).all(|pdo| pdo.fixed)) {
        report.guess(
            first.at,
            "what can be mapped",
            "no mapping can be changed, so it follows from the PDOs",
        );
    }
    let units = sync_units(device, basis, report);
    for (way, pdos) in [(Way::Rx, rx), (Way::Tx, tx)] {
        let (leading, following) = axes.pdos(pdos, report);
        for pdo in pdos.iter().filter(|pdo| !following.contains(&pdo.index)) {
            let room = derived::room(made, pdo.index);
            let surroundings = pdos::Surroundings { way, pdos, references, units: &units, room };
            let mut block = pdos::block(pdo, &surroundings, report);
            if leading.contains(&pdo.index) {
                block.keys.insert(1, ("per-axis".to_owned(), Toml::Bool(true)));
            }
            draft.pdos.push(block);
        }
        followers.extend(following);
    }
    let slots = |number: u8| derived::room(made, 0x1C10 + u16::from(number));
    let managers = sync_managers::blocks(basis.managers, [rx, tx], &followers, slots, report);
    sync_managers::fmmus(&device.fmmus, basis.managers, [rx, tx], report);
    made.iter().for_each(|object| listed::told(object, basis, references, report));
    draft.objects.extend(made.iter().filter_map(|object| derived::block(object, basis, known, report)));
    draft.device.extend(mailbox::mailbox(device, report));
    draft.device.extend(mailbox::timeouts(&device.timeouts, report));
    draft.device.extend(managers);
}

/// What the sync units of the PDOs are called, by number. A file need not name them, nor list them.
fn sync_units(device: &Device, basis: &Basis<'_>, report: &mut Report) -> Vec<String> {
    let pdos = || basis.rx.iter().chain(basis.tx);
    let used = pdos().filter_map(|pdo| pdo.su).max().map_or(0, |last| usize::from(last) + 1);
    let named = (0..used.max(device.sync_units.len())).map(|number| {
        let name = device.sync_units.get(number).filter(|name| !name.is_empty());
        let first = || pdos().find(|pdo| pdo.su.map(usize::from) == Some(number));
        if let Some(pdo) = first().filter(|_| name.is_none()) {
            let why = "it has none; `unit-` and its number are taken";
            report.guess(pdo.at, "the name of a sync unit", why);
        }
        name.cloned().unwrap_or_else(|| format!("unit-{number}"))
    });
    named.collect()
}
