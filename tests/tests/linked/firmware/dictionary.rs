//! The dictionary: its table, its server, and the mailbox in front of it.

use core::hint::black_box;

use devc_runtime::coe::Mailbox;
use devc_runtime::object::Address;
use devc_runtime::sdo::{CommunicationState, Hooks, Part, Server};

use crate::c887::dictionary::{Dictionary, TABLE};

/// Refuses nothing, and changes a value on the way.
struct Computed;

impl Hooks<Dictionary> for Computed {
    fn after_download(&mut self, values: &mut Dictionary, _: Address) {
        values.error_register.0 = black_box(0);
    }
}

pub fn run() {
    let (address, state) = black_box((Address::new(0x6041, 0), CommunicationState::Operational));
    black_box(TABLE.find(address).map(|found| (found.place(), TABLE.constant(found))).is_ok());
    black_box(TABLE.objects().map(|(index, object)| index ^ u16::from(object.highest_subindex())).max());
    let (mut data, length) = black_box(([0; 64], 64));
    let Some(buffer) = data.get_mut(..length) else { return };
    let mut server = Server::new(Dictionary::DEFAULT, Computed);
    black_box(server.upload(address, state, buffer).is_ok());
    black_box(server.download(address, state, buffer).is_ok());
    black_box(server.upload_complete(address, state, &mut Part::new(buffer, length)).is_ok());
    black_box(server.download_complete(address, state, buffer).is_ok());
    let mut mailbox: Mailbox<Dictionary, Computed, 64> = Mailbox::new(server);
    let mut answer = black_box([0; 64]);
    black_box(mailbox.answer(buffer, state, &mut answer));
    black_box(mailbox.proceed(&mut answer));
}
