//! Whole objects as the SDO server gives them, against the layout of their types in the ESI file.

use std::path::Path;

use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::object::Address;
use devc_runtime::sdo::CommunicationState::Operational;
use devc_runtime::sdo::{AbortCode, Dictionary, Part, Place, Range, Server, Slot, Values};
use devc_tests::esi_reader::{self, Device};

/// A device as it would be if it did complete access; none that is shipped says so.
struct Whole<V>(V);

impl<V: Values> Values for Whole<V> {
    fn table(&self) -> &'static Dictionary {
        self.0.table()
    }

    fn ranges(&self) -> &'static [Range] {
        self.0.ranges()
    }

    fn has_complete_access(&self) -> bool {
        true
    }

    fn slot(&mut self, place: Place) -> Option<Slot<'_>> {
        self.0.slot(place)
    }
}

/// The devices of a file, in the order of the members.
fn devices(family: &str) -> Vec<Device> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../generated/{family}/{family}.xml"));
    let text = std::fs::read_to_string(path).expect("the output is there");
    esi_reader::read(&text).expect("it is an ESI file").devices
}

/// So many bits from this one on, the lowest first.
fn bits(data: &[u8], from: usize, count: usize) -> Vec<bool> {
    (from..from + count).map(|bit| data[bit / 8] >> (bit % 8) & 1 != 0).collect()
}

fn upload<V: Values>(server: &mut Server<Whole<V>>, address: Address) -> Result<Vec<u8>, AbortCode> {
    let mut buffer = [0; 256];
    server.upload(address, Operational, &mut buffer).map(<[u8]>::to_vec)
}

/// Compares each object that has several entries, and tells how many could be.
fn lies_as_described<V: Values>(values: V, device: &Device) -> usize {
    let mut server = Server::new(Whole(values), ());
    let mut compared = 0;
    for object in &device.dictionary.objects {
        let members = device.dictionary.values(object).expect("the types are declared");
        let (mut buffer, from) = ([0xAA; 4096], Address::new(object.index, 0));
        let mut part = Part::new(&mut buffer, 0);
        match server.upload_complete(from, Operational, &mut part) {
            Ok(()) => {}
            Err(AbortCode::UNSUPPORTED_ACCESS) if members.len() == 1 => continue,
            Err(AbortCode::NO_COMPLETE_ACCESS) => continue,
            Err(code) => panic!("{:04X}: {code}", object.index),
        }
        let data = part.bytes();
        let count = upload(&mut server, from).expect("subindex 0 can be read")[0];
        let told = members.iter().filter(|member| member.subindex == 0 || member.subindex <= count);
        let end = told.clone().map(|member| (member.offset + member.bits).max(16)).max().expect("subindex 0");
        assert_eq!(data.len(), end.div_ceil(8) as usize, "{:04X}", object.index);
        for member in told {
            let value = upload(&mut server, Address::new(object.index, member.subindex));
            let value = value.unwrap_or(vec![0; 8]);
            let (offset, width) = (member.offset as usize, member.bits as usize);
            let found = bits(data, offset, width);
            assert_eq!(found, bits(&value, 0, width), "{:04X}:{:02X}", object.index, member.subindex);
        }
        compared += 1;
    }
    compared
}

#[test]
fn a_whole_object_lies_as_the_esi_file_says() {
    let c887 = devices("c887");
    assert!(lies_as_described(c887::dictionary::Dictionary::DEFAULT, &c887[0]) > 50);
    let s700 = devices("s700");
    assert!(lies_as_described(s700::s300::dictionary::Dictionary::DEFAULT, &s700[0]) > 20);
    assert!(lies_as_described(s700::s700::dictionary::Dictionary::DEFAULT, &s700[3]) > 20);
    let pmc_sc6 = devices("pmc-sc6");
    assert!(lies_as_described(pmc_sc6::double::dictionary::Dictionary::DEFAULT, &pmc_sc6[0]) > 10);
}
