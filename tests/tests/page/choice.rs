//! What is shown once the reader has chosen: the objects of the member and of the axis, and of these what is asked for. The
//! model says which these are.

use serde_json::Value;

use crate::DEVICES;
use crate::browser::Browser;
use crate::page_and_members;

/// For each member: the objects shown for all axes, on each axis, and for each kind of access and mapping.
const SHOWN: &str = r#"
    const heads = () => objects.filter((line) => line.row.closest("[hidden], .out") === null)
      .map((line) => line.row.cells[0].textContent.trim());
    const only = (key, value) => {
      choice[key] = value; showObjects();
      const found = heads();
      choice[key] = ""; showObjects();
      return found;
    };
    return data.members.map((one, place) => {
      choose(place);
      const whole = heads();
      const axes = one.axes.map((_, axis) => { chooseAxis(axis); return heads(); });
      chooseAxis(null);
      const kinds = [["access", "rw"], ["access", "wo"], ["pdo", "rx"], ["pdo", "tx"]].map(([key, value]) => only(key, value));
      return { whole, axes, kinds, named: document.querySelectorAll("main .of").length > 0
        && getComputedStyle(document.querySelector("main .of")).display !== "none" };
    });"#;

#[test]
fn the_objects_of_a_member_and_an_axis_are_shown() {
    let Some(browser) = Browser::find() else { return };
    for device in DEVICES {
        let (page, members) = page_and_members(device);
        let answers = browser.ask(&page, "", SHOWN);
        for (member, answer) in members.iter().zip(answers.as_array().expect("an answer for each")) {
            let name = format!("{device}: {}", member["id"]);
            let whole = |object: &Value| object["index"] == object["leading"];
            assert_eq!(answer["whole"], objects(member, whole), "{name}");
            for (axis, shown) in answer["axes"].as_array().expect("axes").iter().enumerate() {
                let on_axis = |object: &Value| object["axis"].is_null() || object["axis"] == axis;
                assert_eq!(*shown, objects_by_leading(member, on_axis), "{name}, axis {axis}");
            }
            let some = |object: &Value, key: &str, values: &[&str]| {
                let entries = object["entries"].as_array().expect("entries");
                whole(object)
                    && entries.iter().any(|entry| values.contains(&entry[key].as_str().expect("a word")))
            };
            let asked = [
                objects(member, |object| some(object, "access", &["rw"])),
                objects(member, |object| some(object, "access", &["wo"])),
                objects(member, |object| some(object, "pdo", &["rx", "rx_tx"])),
                objects(member, |object| some(object, "pdo", &["tx", "rx_tx"])),
            ];
            assert_eq!(answer["kinds"], Value::from(asked.to_vec()), "{name}");
            assert_eq!(answer["named"], false, "{name}: other members are named");
        }
    }
}

/// The indices of the objects of a member that are wanted, ascending.
fn objects(member: &Value, wanted: impl Fn(&Value) -> bool) -> Value {
    let objects = member["objects"].as_array().expect("objects").iter().filter(|object| wanted(object));
    objects.map(|object| format!("0x{:04X}", object["index"].as_u64().expect("an index"))).collect()
}

/// The same in the order of the objects that were written for all axes.
fn objects_by_leading(member: &Value, wanted: impl Fn(&Value) -> bool) -> Value {
    let mut objects: Vec<&Value> = member["objects"].as_array().expect("objects").iter().collect();
    objects.retain(|object| wanted(object));
    objects.sort_by_key(|object| object["leading"].as_u64());
    objects.iter().map(|object| format!("0x{:04X}", object["index"].as_u64().expect("an index"))).collect()
}

/// A link brings back what was chosen: the member, the axis, the place.
#[test]
fn a_choice_can_be_shared() {
    let Some(browser) = Browser::find() else { return };
    let (page, _) = page_and_members("pmc-sc6");
    let answer = browser.ask(
        &page,
        "",
        r##"
        history.replaceState(null, "", "#member=double&axis=B&at=obj-607a"); fromLink();
        const place = byId("obj-607a").closest("tr, section, li");
        const shown = { member: byId("member").value, axis: byId("axis").value, text: place.textContent.includes("0x687A") };
        place.querySelector("a.here")?.click();
        return { ...shown, link: location.hash };"##,
    );
    assert_eq!(answer["member"], "double");
    assert_eq!(answer["axis"], "B");
    assert_eq!(answer["text"], true, "the index is that of the axis");
    assert_eq!(answer["link"], "#member=double&axis=B&at=obj-607a");
}

/// What is typed is found in an instant, and the first hit is that of the object.
#[test]
fn the_largest_reference_is_searched_at_once() {
    let Some(browser) = Browser::find() else { return };
    let (page, _) = page_and_members("pmc-sc6");
    let answer = browser.ask(
        &page,
        "",
        r#"
        byId("search").value = "target position 0x607a"; listHits();
        const hits = byId("hits").children.length;
        const first = byId("hits").querySelector("a").textContent;
        byId("search").dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
        return { hits, first, closed: byId("found").hidden, marked: document.querySelectorAll(".found").length, link: location.hash };"#,
    );
    assert!(answer["hits"].as_u64() > Some(0), "{answer}");
    assert!(
        answer["first"].as_str().is_some_and(|first| first.to_lowercase().contains("target position")),
        "{answer}"
    );
    assert_eq!(answer["closed"], true, "{answer}");
    assert_eq!(answer["marked"], 1, "{answer}");
    assert!(answer["link"].as_str().is_some_and(|link| link.len() > 1), "{answer}");
}
