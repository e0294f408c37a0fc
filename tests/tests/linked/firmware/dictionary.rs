//! The dictionary: its table, its server, and the mailbox in front of it with all services: SDO in one piece, in
//! segments and complete, SDO information, and emergencies.

use core::hint::black_box;

use devc_runtime::coe::{Emergency, Mailbox};
use devc_runtime::object::Address;
use devc_runtime::sdo::{CommunicationState, Hooks, Part, Server, Values};

use crate::c887::dictionary::{Dictionary, NAMES, TABLE};
use crate::{pmc_sc6, s700};

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
    black_box(server.read(address, state, &mut Part::new(buffer, black_box(3))).is_ok());
    black_box(server.download(address, state, buffer).is_ok());
    black_box(server.upload_complete(address, state, &mut Part::new(buffer, length)).is_ok());
    black_box(server.download_complete(address, state, buffer).is_ok());
    mailbox(Mailbox::with_information(server, &NAMES));
    mailbox(Mailbox::new(Server::new(s700::s700::dictionary::Dictionary::DEFAULT, ())));
    mailbox(Mailbox::new(Server::new(pmc_sc6::double::dictionary::Dictionary::DEFAULT, ())));
}

/// What the message asks for is known to nobody, so it can be any service.
fn mailbox<V: Values, H: Hooks<V>>(mut mailbox: Mailbox<V, H, 64>) {
    let (message, state) = black_box(([0; 64], CommunicationState::PreOperational));
    let mut answer = black_box([0; 64]);
    black_box(mailbox.answer(black_box(&message[..]), state, black_box(&mut answer[..])));
    black_box(mailbox.proceed(black_box(&mut answer[..])));
    let emergency = black_box(Emergency { code: 0x7121, register: 0x20, data: [0; 5] });
    black_box(mailbox.emergency(&emergency, black_box(&mut answer[..])));
}
