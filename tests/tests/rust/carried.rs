//! A field of a PDO tells how its object is carried, where that is not as the dictionary has it.

use serde_json::Value;
use syn::visit_mut::VisitMut;

use crate::conditions::{documentation, generated};

/// The fields of all structs, by what the documentation begins with: the index of the PDO, and the address.
#[derive(Default)]
struct Fields(Vec<(String, String, String)>);

impl VisitMut for Fields {
    fn visit_item_struct_mut(&mut self, item: &mut syn::ItemStruct) {
        let Some(index) = first_code(&documentation(&item.attrs)) else { return };
        for field in &item.fields {
            let said = documentation(&field.attrs);
            self.0.extend(first_code(&said).map(|address| (index.clone(), address, said)));
        }
    }
}

/// What stands between the first backticks, if nothing is before them.
fn first_code(documentation: &str) -> Option<String> {
    documentation.trim_start().strip_prefix('`')?.split('`').next().map(str::to_owned)
}

/// The width of a type of the dictionary.
fn bits(data_type: &str) -> u64 {
    match data_type {
        "BOOL" => 1,
        "BYTE" => 8,
        "WORD" => 16,
        "DWORD" => 32,
        numbered => {
            numbered.trim_start_matches(|c: char| !c.is_ascii_digit()).parse().expect("it has a width")
        }
    }
}

fn list<'j>(of: &'j Value, key: &str) -> &'j [Value] {
    of[key].as_array().map_or(&[], Vec::as_slice)
}

fn address(of: &Value) -> Option<String> {
    let part = |key: &str| of["address"][key].as_u64();
    Some(format!("0x{:04X}:{:02X}", part("index")?, part("subindex")?))
}

/// The type of an entry of the dictionary.
fn type_of<'j>(member: &'j Value, at: &str) -> Option<&'j str> {
    let mut entries = list(member, "objects").iter().flat_map(|object| list(object, "entries"));
    entries.find(|entry| address(entry).as_deref() == Some(at))?["data_type"].as_str()
}

#[test]
fn a_field_tells_the_width_of_its_object_if_it_has_another() {
    let mut others = Vec::new();
    for device in ["c887", "pmc-sc6", "s700"] {
        let json: Value = serde_json::from_str(&generated(device, "json")).expect("JSON");
        let mut fields = Fields::default();
        fields.visit_file_mut(&mut syn::parse_file(&generated(device, "rs")).expect("Rust"));
        assert!(!fields.0.is_empty(), "{device}");
        for (index, at, said) in fields.0 {
            let mapped = list(&json, "members").iter().find_map(|member| {
                let is_it = |pdo: &&Value| {
                    pdo["index"].as_u64().map(|index| format!("0x{index:04X}")) == Some(index.clone())
                };
                let pdo = list(member, "pdos").iter().find(is_it)?;
                let mapped =
                    list(pdo, "entries").iter().find(|mapped| address(mapped).as_ref() == Some(&at))?;
                Some((mapped["bits"].as_u64()?, type_of(member, &at)?.to_owned()))
            });
            let Some((carried, object)) = mapped else { continue };
            let is_other = carried != bits(&object);
            let told = format!("The object is {object}, the PDO");
            assert_eq!(said.contains(&told), is_other, "{device} {index} {at}: {said}");
            if is_other {
                assert!(said.contains(&format!(" {carried} ")), "{said}");
                others.push((index, at));
            }
        }
    }
    let both = [("0x1710", "0x6086:00"), ("0x1B0B", "0x60FD:00")];
    assert!(both.iter().all(|(index, at)| others.contains(&((*index).into(), (*at).into()))), "{others:?}");
}
