//! The pictures, which are there without script.

use crate::{DEVICES, page, page_and_members};

/// The picture behind the heading of an id.
fn picture<'p>(page: &'p str, id: &str) -> &'p str {
    let (_, rest) = page.split_once(&format!("id=\"{id}\"")).expect("a heading");
    let (_, rest) = rest.split_once("<svg").expect("a picture");
    rest.split("</svg>").next().expect("its end")
}

/// The boxes of a picture: what each is called, where it begins, and how wide it is.
fn boxes(picture: &str) -> Vec<(&str, usize, usize)> {
    let number = |text: &str, name: &str| {
        let (_, rest) = text.split_once(&format!(" {name}=\"")).expect("an attribute");
        rest.split('"').next().expect("its end").parse().expect("a number")
    };
    let boxes = picture.split("<rect").skip(1).map(|one| {
        let (_, name) = one.split_once("<title>").expect("a name");
        (name.split('<').next().expect("its end"), number(one, "x"), number(one, "width"))
    });
    boxes.collect()
}

/// The manual's layout of PDO 0x1600: two bytes, one, four.
#[test]
fn bytes_of_a_pdo_lie_side_by_side() {
    let page = page("c887");
    let boxes = boxes(picture(&page, "pdo-1600"));
    let names: Vec<&str> = boxes.iter().map(|(name, ..)| *name).collect();
    assert_eq!(names, ["Controlword", "Modes of operation", "Target position"]);
    let byte = boxes[1].2;
    assert_eq!(boxes.iter().map(|(_, _, width)| *width).collect::<Vec<_>>(), [2 * byte, byte, 4 * byte]);
    assert!(boxes.windows(2).all(|pair| pair[0].1 + pair[0].2 == pair[1].1), "{boxes:?}");
}

/// A word has a box for each of its fields.
#[test]
fn words_have_a_box_for_each_field() {
    for device in DEVICES {
        let (page, members) = page_and_members(device);
        for word in members[0]["words"].as_array().expect("words") {
            let fields = word["fields"].as_array().expect("fields");
            let id = format!("word-{}", word["id"].as_str().expect("an id"));
            let names: Vec<String> = boxes(picture(&page, &id))
                .iter()
                .map(|(name, ..)| (*name).replace("&#x27;", "'").replace("&#x2f;", "/"))
                .collect();
            for field in fields.iter().filter(|field| field["low"].as_u64() < word["bits"].as_u64()) {
                let name = field["name"].as_str().expect("a name").replace('&', "&amp;");
                assert!(names.contains(&name), "{device}: {id}: {name} is not in {names:?}");
            }
        }
    }
}

/// Every pattern of every light of the C-887 has a picture; it is on for as long as ETG.1300 says.
#[test]
fn lights_blink_as_the_standard_says() {
    let (page, members) = page_and_members("c887");
    let leds = members[0]["leds"].as_array().expect("lights");
    let patterns: usize = leds.iter().map(|led| led["patterns"].as_array().expect("patterns").len()).sum();
    assert_eq!(page.matches("<svg class=\"light ").count(), patterns);
    let (_, flash) = page.split_once("<svg class=\"light single-flash").expect("a single flash");
    let flash = flash.split("</svg>").next().expect("its end");
    // 200 ms in each 1200 ms, of which 2400 ms are shown
    assert_eq!(flash.matches("<rect").count(), 2, "{flash}");
}

/// An arrow leads to its transition and tells the bits that ask for it; a state tells the bits that show it.
#[test]
fn the_machine_tells_bits() {
    let page = page("c887");
    let machine = picture(&page, "states");
    for part in ["href=\"#transition-4\"", "controlword 0xxx 1111", "x011 0111"] {
        assert!(machine.contains(part), "{part} is not in the picture");
    }
}
