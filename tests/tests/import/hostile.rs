//! Files that somebody broke on purpose: none makes devc panic, hang or take more memory than the file is worth. What
//! chance breaks is in `fuzz/`.

use std::time::{Duration, Instant};

use devc::import::{Choice, import};

const DRIVE: &str = include_str!("files/drive.xml");

fn attempt(bytes: &[u8]) {
    // Whether there is an import or a refusal does not matter here.
    let _ = import(bytes, "file.xml", &Choice::default());
}

#[test]
fn a_file_may_end_anywhere() {
    let step = DRIVE.len() / 60;
    (0..DRIVE.len()).step_by(step).for_each(|end| attempt(&DRIVE.as_bytes()[..end]));
}

#[test]
fn any_number_may_be_absurd() {
    let absurd = [
        "-1",
        "#xFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFFF",
        "99999999999999999999999999",
        "",
        "1e9",
        "#x",
        "255",
        "65535",
    ];
    let numbers: Vec<(usize, usize)> = DRIVE
        .match_indices(['>', '"'])
        .map(|(place, _)| place + 1)
        .filter_map(|start| {
            let length = DRIVE[start..].find(['<', '"'])?;
            let text = &DRIVE[start..start + length];
            let digits = text.strip_prefix("#x").unwrap_or(text);
            (!digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit()))
                .then_some((start, length))
        })
        .collect();
    assert!(numbers.len() > 100);
    for (turn, (start, length)) in numbers.iter().enumerate().step_by(3) {
        let text = format!("{}{}{}", &DRIVE[..*start], absurd[turn % absurd.len()], &DRIVE[start + length..]);
        attempt(text.as_bytes());
    }
}

#[test]
fn entities_are_not_followed() {
    let names = "abcdefghij";
    let mut entities = String::from("<!ENTITY z \"lol\">");
    let mut before = 'z';
    for name in names.chars() {
        entities += &format!("<!ENTITY {name} \"{}\">", format!("&{before};").repeat(10));
        before = name;
    }
    entities += "<!ENTITY file SYSTEM \"file:///etc/passwd\">";
    let xml = DRIVE.replacen("<EtherCATInfo", &format!("<!DOCTYPE a [{entities}]><EtherCATInfo"), 1);
    let xml = xml.replace("Target position", "Target &j; &file;");
    let start = Instant::now();
    if let Ok(imported) = import(xml.as_bytes(), "file.xml", &Choice::default()) {
        let text: String = imported.files.into_values().collect();
        assert!(text.len() < 20_000, "{}", text.len());
        assert!(!text.contains("root:") && !text.contains("lollol"));
    }
    assert!(start.elapsed() < Duration::from_secs(20));
}

#[test]
fn depth_and_length_are_bounded() {
    let deep = format!("<EtherCATInfo>{}", "<a>".repeat(200_000));
    let refusal = import(deep.as_bytes(), "file.xml", &Choice::default()).expect_err("too deep");
    assert!(refusal.why.contains("deep"), "{}", refusal.why);
    let comments =
        DRIVE.replacen("<Descriptions>", &format!("{}<Descriptions>", "<!-- nothing -->".repeat(500_000)), 1);
    let start = Instant::now();
    assert!(import(comments.as_bytes(), "file.xml", &Choice::default()).is_ok());
    assert!(start.elapsed() < Duration::from_secs(60));
    let long = vec![b' '; (64 << 20) + 1];
    assert!(import(&long, "file.xml", &Choice::default()).expect_err("too long").why.contains("larger"));
    let types = "<DataType><Name>A</Name><BaseType>A</BaseType></DataType>";
    let circle =
        DRIVE.replacen("<DataTypes>", &format!("<DataTypes>{types}"), 1).replace("<Type>DINT", "<Type>A");
    attempt(circle.as_bytes());
}

#[test]
fn a_few_lines_cannot_ask_for_a_great_deal() {
    let array = "<DataType><Name>A</Name><BaseType>USINT</BaseType><BitSize>2040</BitSize><ArrayInfo><LBound>1</LBound>\
        <Elements>4000000000</Elements></ArrayInfo></DataType><DataType><Name>B</Name><BitSize>2056</BitSize><SubItem>\
        <Name>All</Name><Type>A</Type></SubItem></DataType>";
    let objects: String = (0x2000..0x9000)
        .map(|index| format!("<Object><Index>{index}</Index><Type>B</Type></Object>"))
        .collect();
    let xml = DRIVE.replacen("<DataTypes>", &format!("<DataTypes>{array}"), 1).replacen(
        "<Objects>",
        &format!("<Objects>{objects}"),
        1,
    );
    let refusal = import(xml.as_bytes(), "file.xml", &Choice::default()).expect_err("too much");
    assert!(refusal.why.contains("more values"), "{}", refusal.why);
    let line = DRIVE.replace('\n', " ").replacen(
        "<Fmmu>",
        &format!("{}<Fmmu>", "<Unknown a=\"1\"/>".repeat(50_000)),
        1,
    );
    let start = Instant::now();
    let report = import(line.as_bytes(), "file.xml", &Choice::default()).expect("an import").report;
    assert!(report.notes.len() > 50_000 && report.notes.iter().all(|note| note.place.0 == 1));
    assert!(start.elapsed() < Duration::from_secs(60));
}
