//! What does not fit is left out as a whole, or there is no image.

use devc::sii::{self, Extent};

use crate::corners::compiled;
use crate::like_esi::{CONFIG_DATA, SHIPPED, family};
use crate::reader::Image;

/// A device with a PDO that is assigned and so many that are not.
fn device(size: u32, more: usize, entries: usize) -> String {
    let pdo = |pdo: usize| {
        let objects: Vec<String> =
            (0..entries).map(|entry| format!("\"0x{:04X}\"", 0x2000 + entry)).collect();
        format!(
            "[tx-pdos.0x{:04X}]\nname = \"PDO {pdo}\"\nentries = [{}]\n",
            0x1A00 + pdo,
            objects.join(", ")
        )
    };
    let object = |entry| {
        format!("0x{:04X} = {{ name = \"Value {entry}\", type = \"UINT8\", pdo = \"tx\" }}\n", 0x2000 + entry)
    };
    let head = format!(
        "[device]\nname = \"Large\"\nvendor = \"Example\"\n\
         [identity]\nvendor-id = 1\nproduct-code = 2\nrevision = 3\n\
         [eeprom]\nsize = {size}\nconfig-data = \"080E\"\n\
         [sync-managers]\ninputs = {{ address = 0x1000, pdos = [\"0x1A00\"] }}\n[objects]\n"
    );
    head + &(0..entries).map(object).collect::<String>() + &(0..=more).map(pdo).collect::<String>()
}

/// The messages of a rule, and the image with how many PDOs it has.
fn made(text: &str) -> (Vec<String>, Option<usize>) {
    let folder = std::path::Path::new("/corner");
    let loader = devc::source::Memory::new().with(folder.join("device.toml"), text);
    let compilation = devc::compile(&loader, folder);
    let found = compilation.diagnostics.iter().filter(|it| it.rule.name == "undersized-eeprom");
    let notes = found.map(|it| it.notes.join(" ")).collect();
    let family = compilation.family.unwrap();
    let image = sii::image(family.members.first().unwrap(), &CONFIG_DATA);
    (notes, image.map(|image| Image::read(&image).pdos(50).len()))
}

#[test]
fn pdos_that_are_not_assigned_go_first_and_the_finding_says_it() {
    assert_eq!(made(&device(1024, 2, 10)), (vec![], Some(3)));
    let (notes, pdos) = made(&device(1024, 20, 10));
    assert_eq!(pdos, Some(1));
    assert!(notes[0].contains("only the PDOs that are assigned"), "{notes:?}");
    let (notes, pdos) = made(&device(256, 0, 40));
    assert_eq!(pdos, None);
    assert!(notes[0].contains("there is no image"), "{notes:?}");
}

#[test]
fn a_program_has_an_eeprom_as_large_as_it_takes() {
    let family = compiled(&device(256, 0, 40));
    let device = family.members.first().unwrap();
    let bytes = sii::image_of_any_size(device, &CONFIG_DATA);
    assert_eq!((bytes.len(), Image::read(&bytes).pdos(50)[0].entries.len()), (1024, 40));
}

/// The last size in which an image fits is that of its bytes, rounded up to what an EEPROM counts in.
#[test]
fn an_image_takes_what_it_says() {
    let family = compiled(&device(4096, 20, 10));
    let device = family.members.first().unwrap();
    for extent in [Extent::All, Extent::Assigned] {
        let needed = sii::bytes(device, extent).next_multiple_of(128);
        let (_, exact) = made(&self::device(u32::try_from(needed).unwrap(), 20, 10));
        let (_, less) = made(&self::device(u32::try_from(needed - 128).unwrap(), 20, 10));
        assert!(exact > less, "{extent:?}: {exact:?} in {needed}, {less:?} in less");
    }
}

#[test]
fn the_shipped_devices_fit_into_2048_bytes() {
    let mut assigned_only = Vec::new();
    for device in SHIPPED.iter().flat_map(|id| family(id).members.clone()) {
        let image = Image::read(&sii::image(&device, &CONFIG_DATA).unwrap());
        assert_eq!(image.used, sii::bytes(&device, sii::fitting(&device).unwrap()));
        if image.pdos(50).len() + image.pdos(51).len() < device.pdos.len() {
            assigned_only.push(device.id);
        }
    }
    assert_eq!(assigned_only, ["s300", "s700"]);
}
