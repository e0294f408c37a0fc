//! What tells the members of a family apart, side by side.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::holds::Form;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::{bytes, duration};
use crate::emit::markdown::table::Table;
use crate::model::{CycleTime, Device, Direction, Family, Role};

/// A figure of a device, as a cell.
type Figure = fn(&Device) -> String;

/// What is compared: what is the same for all members is not shown.
const FIGURES: [(&str, Figure); 15] = [
    ("Name", |device| text(&device.name)),
    ("Title", |device| device.title.as_deref().map_or(String::new(), text)),
    ("Models", |device| list(device.models.iter().map(|model| text(model)))),
    ("Type", |device| code(&device.type_name)),
    ("Product code", |device| hex(device.identity.product_code)),
    ("Revision number", |device| hex(device.identity.revision)),
    ("Axes", |device| list(device.axes.iter().map(|axis| text(&axis.name)))),
    ("Objects", |device| device.objects.len().to_string()),
    ("Receive PDOs", |device| device.pdos_of(Direction::Rx).count().to_string()),
    ("Transmit PDOs", |device| device.pdos_of(Direction::Tx).count().to_string()),
    ("Outputs by default", |device| assigned(device, Role::Outputs)),
    ("Inputs by default", |device| assigned(device, Role::Inputs)),
    ("Modes of operation", |device| list(device.modes.iter().map(|mode| text(&mode.id)))),
    ("SDO information", |device| answer(device.mailbox.as_ref().is_some_and(|mailbox| mailbox.sdo_info))),
    ("Start-up configurations", |device| list(device.configurations.iter().map(|one| text(&one.name)))),
];

/// A row for each figure in which members differ, a column for each member.
pub(super) fn table(family: &Family, names: &[String]) -> Table {
    let members = &family.members;
    let mut table = Table::new([String::new()].into_iter().chain(names.iter().cloned()));
    let figures = FIGURES
        .iter()
        .map(|(title, figure)| (String::from(*title), members.iter().map(figure).collect::<Vec<String>>()));
    let units = unit_rows(members);
    for (title, cells) in figures.chain(cycle_times(members)).chain(units) {
        let differ = cells.iter().any(|cell| Some(cell) != cells.first());
        if differ && cells != names {
            table.row([format!("**{title}**")].into_iter().chain(cells));
        }
    }
    table
}

/// A row for each limit of the cycle that any member has.
fn cycle_times(members: &[Device]) -> Vec<(String, Vec<String>)> {
    let names = distinct(members.iter().flat_map(|device| &device.cycle_times).map(|time| &*time.name));
    let cell = |device: &Device, name: &str| {
        device.cycle_times.iter().find(|time| time.name == name).map_or("–".into(), cycle)
    };
    let rows = names.into_iter().map(|name| {
        let cells = members.iter().map(|device| cell(device, name)).collect();
        (format!("Cycle: {}", text(name)), cells)
    });
    rows.collect()
}

/// A row for each unit that any member has.
fn unit_rows(members: &[Device]) -> Vec<(String, Vec<String>)> {
    let ids = distinct(members.iter().flat_map(|device| &device.units).map(|unit| &*unit.id));
    let cell = |device: &Device, id: &str| {
        let symbol = device.unit(id).and_then(|unit| unit.on(None)).map(|unit| text(&unit.symbol));
        symbol.unwrap_or_else(|| "–".into())
    };
    let rows = ids.into_iter().map(|id| {
        let quantity = members.iter().find_map(|device| device.unit(id)).map_or(id, |unit| &unit.quantity);
        let cells = members.iter().map(|device| cell(device, id)).collect();
        (format!("Unit: {}", text(quantity)), cells)
    });
    rows.collect()
}

fn distinct<'a>(items: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let mut found: Vec<&str> = Vec::new();
    items.for_each(|item| {
        if !found.contains(&item) {
            found.push(item);
        }
    });
    found
}

fn cycle(time: &CycleTime) -> String {
    let least = time.min.map(|least| format!("{} or more", duration(least.0)));
    list(least.into_iter().chain(time.choices.iter().map(|choice| duration(choice.0))))
}

fn hex(number: u32) -> String {
    code(format!("0x{number:08X}"))
}

fn answer(yes: bool) -> String {
    if yes { "yes".into() } else { "no".into() }
}

/// The PDOs that a sync manager has at start-up, with the bytes that they make.
fn assigned(device: &Device, role: Role) -> String {
    let context = Context::new(device, false, Form::Text);
    let pdos = list(device.assigned(role).map(|pdo| context.index(pdo.index)));
    format!("{}: {pdos}", bytes(device.image_bytes(role)))
}
