//! What a master writes before process data flows.

use serde::Serialize;

use super::names::Names;
use crate::emit::escape::prose;
use crate::model::{Device, SdoWrite};

/// The writes of a configuration during a change of the EtherCAT state, in order.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct StartUp {
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    /// Two letters, such as `PS`.
    pub(in crate::emit) transition: String,
    /// Whether a master takes it if nothing else is chosen.
    pub(in crate::emit) is_default: bool,
    pub(in crate::emit) writes: Vec<Write>,
}

/// A write through the mailbox.
#[derive(Debug, Clone, Serialize)]
pub(in crate::emit) struct Write {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) subindex: u8,
    pub(in crate::emit) data: Vec<u8>,
    pub(in crate::emit) title: String,
    /// Whether it assigns or maps process data.
    pub(in crate::emit) is_mapping: bool,
}

/// The lists of all configurations; one for each change of state in which they write.
pub(super) fn start_ups(device: &Device, names: &mut Names) -> Vec<StartUp> {
    let mut lists = Vec::new();
    for configuration in &device.configurations {
        let mut transitions: Vec<&str> = Vec::new();
        for write in &configuration.startup {
            if !transitions.contains(&&*write.transition) {
                transitions.push(&write.transition);
            }
        }
        for transition in transitions {
            let own = configuration.startup.iter().filter(|write| write.transition == transition);
            let tail = if transition == "PS" { "" } else { transition };
            lists.push(StartUp {
                global: names.global(&["start-up", &configuration.id, tail]),
                title: prose(&configuration.name),
                transition: transition.to_owned(),
                is_default: configuration.default,
                writes: own.map(write).collect(),
            });
        }
    }
    lists
}

fn write(write: &SdoWrite) -> Write {
    let index = write.address.index;
    Write {
        index: index.0,
        subindex: write.address.subindex,
        data: write.data.clone(),
        title: prose(&write.comment),
        is_mapping: index.is_derived(),
    }
}
