//! The EtherCAT slave controller and the EtherCAT state machine against chapters 3.1 to 3.3.

use std::collections::BTreeSet;

use devc::model::{Device, Register, RegisterAccess, Role};
use devc_tests::manual::s700;

use crate::{departs, family, number, plain, rows};

/// The facts here are the same on all members.
fn device() -> &'static Device {
    &family().members[0]
}

fn register(address: u16) -> &'static Register {
    let found = device().registers.iter().find(|register| register.address == address);
    found.unwrap_or_else(|| panic!("there is no register 0x{address:04X}"))
}

/// As the manual writes it: `r/w`, `r/-`.
fn written(access: RegisterAccess) -> &'static str {
    match access {
        RegisterAccess::None => "-/-",
        RegisterAccess::R => "r/-",
        RegisterAccess::W => "-/w",
        RegisterAccess::Rw => "r/w",
    }
}

/// The number of a transition's state in AL control.
fn code(state: &str) -> u8 {
    let found = device().communication_states.iter().find(|other| other.id == state);
    found.unwrap_or_else(|| panic!("there is no state {state}")).code
}

#[test]
fn members_have_the_same_registers() {
    for other in &family().members {
        assert_eq!(other.registers, device().registers);
        assert_eq!(other.al_status_codes, device().al_status_codes);
        assert_eq!(other.communication_transitions, device().communication_transitions);
        assert_eq!(other.telegrams, device().telegrams);
    }
}

#[test]
fn registers_are_those_of_the_table() {
    let printed: Vec<_> = rows::<s700::Register>()
        .into_iter()
        .map(|row| (row.address, row.length, row.ecat, row.drive))
        .collect();
    let described: Vec<_> = device()
        .registers
        .iter()
        .map(|it| (it.address, it.length, written(it.ecat), written(it.drive)))
        .collect();
    assert_eq!(described, printed);
}

#[test]
fn names_of_registers_are_those_of_the_table() {
    let other = rows::<s700::Register>().into_iter().filter_map(|row| {
        let described = register(row.address).name.as_str();
        (!plain(row.name).starts_with(&plain(described))).then_some((row.address, described))
    });
    departs(other, []);
}

#[test]
fn bits_are_those_of_the_tables() {
    for row in rows::<s700::RegisterBits>().into_iter().filter(|row| row.address != 0x0222) {
        let register = register(row.register);
        // The tables of bits count in bytes, but for the upper half of AL control and AL status.
        let byte = u8::try_from(row.address & 1).expect("a bit");
        let (first, last) = (byte * 8 + row.first, byte * 8 + row.last);
        if register.fields.is_empty() {
            assert_eq!((register.length, row.name), (2, "Status"), "a code as a whole");
            continue;
        }
        let field = register.fields.iter().find(|field| (field.low, field.high) == (first, last));
        let field = field.unwrap_or_else(|| panic!("0x{:04X} lacks bits {first} to {last}", row.register));
        let reserved = row.name == "Reserved" || row.name.contains("Sync Manager 4");
        assert_eq!(field.reserved, reserved, "{row:?}");
    }
}

#[test]
fn bits_have_the_names_of_the_tables() {
    let rows = rows::<s700::RegisterBits>()
        .into_iter()
        .filter(|row| row.name != "Reserved" && row.address != 0x0222);
    let other = rows.filter(|row| !register(row.register).fields.is_empty()).filter_map(|row| {
        let bit = u8::try_from(row.address & 1).expect("a bit") * 8 + row.first;
        let field = register(row.register).fields.iter().find(|field| field.low == bit);
        let described = field.map(|field| field.name.as_str()).unwrap_or_default();
        let same = !described.is_empty() && plain(row.name).starts_with(&plain(described));
        (!same).then_some((row.name, described))
    });
    departs(other, [(("Appl. specific", "application-specific"), "written out")]);
}

#[test]
fn bits_stand_at_the_address_of_their_register() {
    let other = rows::<s700::RegisterBits>().into_iter().filter(|row| {
        let register = register(row.register);
        !(register.address..register.address + register.length).contains(&row.address)
    });
    let known = [
        ((0x0220, 0x0201, 2), "a misprint of 0x0221"),
        ((0x0220, 0x0201, 3), "a misprint of 0x0221"),
        ((0x0220, 0x0222, 0), "the register has 2 bytes by 3.1"),
    ];
    departs(other.map(|row| (row.register, row.address, row.first)), known);
}

#[test]
fn access_of_bits_is_that_of_their_register() {
    let short = |access: RegisterAccess| match access {
        RegisterAccess::R => "r",
        RegisterAccess::W => "w",
        RegisterAccess::Rw => "r/w",
        RegisterAccess::None => "-",
    };
    let other = rows::<s700::RegisterBits>().into_iter().filter(|row| {
        let register = register(row.register);
        (short(register.ecat), short(register.drive)) != (row.ecat, row.drive)
    });
    let known = [
        (0x0120, "the table of registers lets the master read it, too"),
        (0x0130, "the table of registers lets the drive read it, too"),
        (0x0134, "the table of registers lets the drive read it, too"),
    ];
    departs(other.map(|row| row.register), known);
}

#[test]
fn states_have_the_values_of_both_registers() {
    for row in rows::<s700::AlState>() {
        let name = plain(row.name.trim_end_matches(" Request").trim_end_matches(" Mode"));
        let field = register(row.register).fields.iter().find(|field| field.low == 0).expect("bits 0 to 3");
        let value = field.values.iter().find(|value| value.value == i64::from(row.value));
        assert_eq!(value.map(|value| plain(&value.name)), Some(name.clone()), "{row:?}");
        assert_eq!(field.values.len(), 5);
        let state = device().communication_states.iter().find(|state| state.code == row.value);
        assert_eq!(state.map(|state| plain(&state.name)), Some(name), "{row:?}");
    }
}

#[test]
fn al_status_codes_are_those_of_the_table() {
    let printed = rows::<s700::AlCode>();
    assert_eq!(device().al_status_codes.len(), printed.len());
    for (row, described) in printed.iter().zip(&device().al_status_codes) {
        assert_eq!(described.code, row.code);
        let during: Vec<&str> = row.current.iter().copied().filter(|state| *state != "All").collect();
        assert_eq!(described.during, during, "0x{:04X}", row.code);
        let result = match row.result {
            "Current Status" => "the present state",
            "Current Status + E" => "the present state, with the error bit",
            "S + E" => "Safe-operational, with the error bit",
            other => panic!("{other} is a new result"),
        };
        assert_eq!(described.results.as_deref(), Some(result), "0x{:04X}", row.code);
    }
    let both = printed.iter().zip(&device().al_status_codes).map(|(row, it)| (row.name, it.name.as_str()));
    let other = both.filter(|(row, described)| plain(row) != plain(described));
    departs(other, []);
}

#[test]
fn transitions_ask_for_the_values_of_the_list() {
    let printed: BTreeSet<_> = rows::<s700::EsmTransition>().iter().map(|row| row.transition).collect();
    let described: BTreeSet<_> = device().communication_transitions.iter().map(|it| it.id.as_str()).collect();
    assert_eq!(described, printed);
    for row in rows::<s700::EsmTransition>() {
        let found = device().communication_transitions.iter().find(|it| it.id == row.transition);
        let found = found.expect("the sets are equal");
        // Bootstrap is left by a reset of the hardware, not by a request.
        assert_eq!(code(&found.to), row.al.unwrap_or(1), "{}", row.transition);
        let about = found.about.as_deref().unwrap_or_default();
        for word in ["n17", "F28", "mailbox", "hardware", "cyclic interrupts"] {
            let said = row.meaning.contains(word)
                || word == "cyclic interrupts" && row.meaning.contains("interrupts");
            assert!(!said || about.contains(word), "{}: {word} is not in {about:?}", row.transition);
        }
    }
}

#[test]
fn memory_of_the_sync_managers_is_that_of_the_table() {
    let areas = [
        (Role::MailboxOut, "mail-out-address"),
        (Role::MailboxIn, "mail-in-address"),
        (Role::Outputs, "process-out-address"),
        (Role::Inputs, "process-in-address"),
    ];
    for (role, key) in areas {
        let manager = device().sync_manager(role).expect("there are four");
        assert_eq!(u32::from(manager.address), number(key), "{key}");
        let area = rows::<s700::Register>().into_iter().find(|row| row.address == manager.address);
        let length = area.map(|row| row.length).expect("it is in the table");
        let size =
            if matches!(role, Role::Outputs | Role::Inputs) { manager.max_size } else { Some(manager.size) };
        assert_eq!(size, Some(length), "{key}");
    }
    assert_eq!(u32::from(Role::MailboxOut.number()), number("mailbox-output-sync-manager"));
    assert_eq!(u32::from(Role::MailboxIn.number()), number("mailbox-input-sync-manager"));
}
