//! An ESI that devc made, imported again, gives the same description, but for comments.

use devc::import::{Choice, import};

use super::round_trip::compiled;
use super::transport::{file, value};

/// The description that a file becomes, and the ESI made of it; the same again comes of that.
#[track_caller]
fn fixed(xml: &str) -> (String, String) {
    let imported =
        |xml: &str| import(xml.as_bytes(), "drive.xml", &Choice::default()).expect("a description");
    let first = imported(xml);
    let (made, _) = compiled(&first).expect("an ESI");
    let said = |text: &str| -> String {
        text.lines()
            .filter(|line| !line.is_empty() && !line.starts_with('#'))
            .map(|line| format!("{line}\n"))
            .collect()
    };
    let text: String = first.files.values().map(|text| said(text)).collect();
    let again: String = imported(&made).files.values().map(|text| said(text)).collect();
    assert_eq!(text, again);
    (text, made)
}

/// A PDO with entries of 16 bits.
fn pdo(tag: &str, attributes: &str, index: &str, inside: &str) -> String {
    format!("<{tag} Fixed=\"1\" {attributes}><Index>{index}</Index><Name>P {index}</Name>{inside}</{tag}>\n")
}

fn entry(index: &str) -> String {
    format!(
        "<Entry><Index>{index}</Index><SubIndex>0</SubIndex><BitLen>16</BitLen><Name>Value {index}</Name>\
         <DataType>UINT</DataType></Entry>"
    )
}

/// Sync managers of process data, and four PDOs of which two are assigned.
fn process_data() -> String {
    let manager = |name: &str, address: &str, control: &str| {
        format!(
            "<Sm StartAddress=\"{address}\" ControlByte=\"{control}\" DefaultSize=\"2\" Enable=\"1\">{name}</Sm>"
        )
    };
    [
        manager("Outputs", "#x1000", "#x64"),
        manager("Inputs", "#x1100", "#x20"),
        pdo("RxPdo", "Sm=\"0\"", "#x1600", &entry("#x2000")),
        pdo("RxPdo", "", "#x1601", &entry("#x2000")),
        pdo("TxPdo", "Sm=\"1\"", "#x1A00", &entry("#x2001")),
        pdo("TxPdo", "", "#x1A01", &entry("#x2001")),
    ]
    .concat()
}

fn values() -> String {
    value("#x2000", "UINT", 16, "<PdoMapping>R</PdoMapping>")
        + &value("#x2001", "UINT", 16, "<PdoMapping>T</PdoMapping>")
}

/// A record or an array of one member after subindex 0.
fn record(index: &str, name: &str, member: &str, flags: &str) -> (String, String) {
    let number = index.trim_start_matches("#x");
    let kind = format!(
        "<DataType><Name>DT{number}</Name><BitSize>32</BitSize><SubItem><SubIdx>0</SubIdx><Name>SubIndex 000</Name>\
         <Type>USINT</Type><BitSize>8</BitSize><BitOffs>0</BitOffs><Flags><Access>ro</Access></Flags></SubItem>\
         <SubItem><SubIdx>1</SubIdx><Name>SubIndex 001</Name><Type>{member}</Type><BitSize>16</BitSize><BitOffs>16</BitOffs>\
         <Flags>{flags}</Flags></SubItem></DataType>"
    );
    let object = format!(
        "<Object><Index>{index}</Index><Name>{name}</Name><Type>DT{number}</Type><BitSize>32</BitSize>\
         <Flags><Access>rw</Access></Flags></Object>"
    );
    (kind, object)
}

/// What is in the file beside types of its own.
fn with_types(types: &str, xml: &str) -> String {
    xml.replacen("<DataTypes>", &format!("<DataTypes>{types}"), 1)
}

/// An enumeration by the name of its type.
fn enumeration(name: &str, base: &str, bits: u32, values: &[(i64, &str)]) -> String {
    let values = values
        .iter()
        .map(|(value, name)| format!("<EnumInfo><Text>{name}</Text><Enum>{value}</Enum></EnumInfo>"));
    format!(
        "<DataType><Name>{name}</Name><BaseType>{base}</BaseType><BitSize>{bits}</BitSize>{}</DataType>",
        values.collect::<String>()
    )
}

/// ETG.2000 leaves what is in `VendorSpecific` to the tools of vendors.
#[test]
fn choices_of_pdos_by_name() {
    let choice = |name: &str, rx: &str, tx: &str, default: &str| {
        format!(
            "<AlternativeSmMapping{default}><Name>{name}</Name><Sm No=\"0\">{rx}</Sm><Sm No=\"1\"><Pdo>{tx}</Pdo></Sm>\
             </AlternativeSmMapping>"
        )
    };
    let choices = choice("Wide", "<Pdo>#x1601</Pdo>", "#x1A01", "")
        + &choice("Plain", "<Pdo>#x1600</Pdo>", "#x1A00", " Default=\"1\"")
        + &choice("Listen", "", "#x1A00", "");
    let info = format!("<Info><VendorSpecific><TwinCAT>{choices}</TwinCAT></VendorSpecific></Info>");
    let xml = file("", &values(), &process_data()).replace("<GroupType>", &format!("{info}<GroupType>"));
    let (text, made) = fixed(&xml);
    assert!(text.contains("[configurations.listen]"), "{text}");
    let document = roxmltree::Document::parse(&made).expect("XML");
    let choices = document.descendants().filter(|it| it.has_tag_name("AlternativeSmMapping"));
    let choices = choices.map(|it| {
        let text = |tag| {
            it.descendants().filter(|it| it.has_tag_name(tag)).filter_map(|it| it.text()).collect::<Vec<_>>()
        };
        (text("Name").concat(), text("Pdo").join(" "), it.attribute("Default"))
    });
    let expected =
        [("Wide", "#x1601 #x1A01", None), ("Plain", "#x1600 #x1A00", Some("1")), ("Listen", "#x1A00", None)];
    assert_eq!(
        choices.collect::<Vec<_>>(),
        expected.map(|(name, pdos, it)| (name.to_owned(), pdos.to_owned(), it))
    );
}

#[test]
fn meanings_that_a_profile_gives() {
    let all = [
        (0, "free run"),
        (1, "synchronous with SM2 event"),
        (2, "synchronous with SYNC0 event"),
        (3, "synchronous with SYNC1 event"),
    ];
    let device = |values: Option<&[(i64, &str)]>| {
        let kind = if values.is_some() { "EN1C32" } else { "UINT" };
        let (record, object) = record("#x1C32", "SM output parameter", kind, "<Access>rw</Access>");
        let kind = values.map(|values| enumeration("EN1C32", "UINT", 16, values)).unwrap_or_default();
        with_types(&(kind + &record), &file("", &object, ""))
    };
    // The profile says it, whether the file does or not.
    for said in [None, Some(all.as_slice())] {
        let (text, made) = fixed(&device(said));
        assert!(!text.contains("free run") && made.contains(">free run</Text>"), "{text}");
    }
    // What the file calls otherwise is said, and what it does not have is not there.
    let (text, made) = fixed(&device(Some(&[(0, "free run"), (1, "SM 2")])));
    assert!(text.contains("1 = \"SM 2\"") && !text.contains("free run"), "{text}");
    assert!(text.contains("\"objects.0x1C32.entries.1.values.3\""), "{text}");
    assert!(!made.contains("SYNC0"), "{made}");
}

/// ETG.2000 has no enumerations of signed numbers, and none of one value.
#[test]
fn meanings_that_an_esi_has_in_a_comment() {
    let of = |base: &str, bits, values: &[(i64, &str)]| {
        let object =
            value("#x2000", "EN2000", bits, "").replace("</Type>", "</Type><Comment>What it does.</Comment>");
        with_types(&enumeration("EN2000", base, bits, values), &file("", &object, ""))
    };
    let (text, made) = fixed(&of("INT", 16, &[(-1, "off; at once"), (2, "on")]));
    assert!(made.contains("What it does. Values: -1 = off; at once; 2 = on."), "{made}");
    assert!(text.contains("-1 = \"off; at once\"") && text.contains("\"What it does.\""), "{text}");
    fixed(&of("UINT", 16, &[(2, "on")]));
}

/// ETG.1020 lets process data be changed in Pre-Operational only, whatever a file says of it.
#[test]
fn rights_of_assignments() {
    for (flags, name) in [
        ("<Access>rw</Access>", "RxPDO assign"),
        ("<Access>rw</Access>", "Sync manager 2 PDO assignment"),
        ("<Access>rw</Access><Category>m</Category>", "Sync manager 2 PDO assignment"),
        ("<Access WriteRestrictions=\"PreOP\">rw</Access>", "RxPDO assign"),
        ("<Access>ro</Access>", "RxPDO assign"),
    ] {
        for assigns in [0, 1] {
            let (kind, object) = record("#x1C12", name, "UINT", flags);
            let managers = "<Sm StartAddress=\"#x1000\" ControlByte=\"#x26\" DefaultSize=\"128\" Enable=\"1\">MBoxOut</Sm>\
                <Sm StartAddress=\"#x1080\" ControlByte=\"#x22\" DefaultSize=\"128\" Enable=\"1\">MBoxIn</Sm>\
                <Sm StartAddress=\"#x1100\" ControlByte=\"#x64\" DefaultSize=\"2\" Enable=\"1\">Outputs</Sm>";
            let mailbox = format!("<Mailbox DataLinkLayer=\"1\"><CoE PdoAssign=\"{assigns}\"/></Mailbox>");
            let pdo = pdo("RxPdo", "Sm=\"2\"", "#x1600", &entry("#x2000"));
            let objects = values() + &object;
            fixed(&with_types(&kind, &file("", &objects, &[managers, &pdo, &mailbox].concat())));
        }
    }
}

/// Names such as `Status__` tell tools to which structure padding belongs.
#[test]
fn padding_with_a_name() {
    let padding = |name: &str| format!("<Entry><Index>#x0</Index><BitLen>16</BitLen>{name}</Entry>");
    let named = padding("<Name>Status__</Name>") + &padding("") + &padding("<Name>Padding</Name>");
    let (text, made) = fixed(&file("", &values(), &pdo("TxPdo", "", "#x1A00", &(named + &entry("#x2001")))));
    assert!(text.contains("{ bits = 16, name = \"Status__\" }"), "{text}");
    assert_eq!(made.matches("<Name LcId=\"1033\">Status__</Name>").count(), 1, "{made}");
    assert!(!made.contains(">Padding</Name>\n            <"), "{made}");
}

#[test]
fn order_that_says_nothing() {
    let excludes = "<Exclude>#x1603</Exclude><Exclude>#x1602</Exclude>";
    let pdos = pdo("RxPdo", "", "#x1601", &(excludes.to_owned() + &entry("#x2000")))
        + &pdo("RxPdo", "", "#x1602", &entry("#x2000"))
        + &pdo("RxPdo", "", "#x1603", &entry("#x2000"));
    let mailbox = "<Mailbox DataLinkLayer=\"1\"><FoE/><CoE/><EoE/></Mailbox>";
    let kind = enumeration("EN2002", "UINT", 16, &[(7, "seven"), (1, "one")]);
    let objects = values() + &value("#x2002", "EN2002", 16, "");
    let (text, _) = fixed(&with_types(&kind, &file("", &objects, &(pdos + mailbox))));
    for said in ["[\"0x1602\", \"0x1603\"]", "[\"EoE\", \"CoE\", \"FoE\"]", "{ 1 = \"one\", 7 = \"seven\" }"]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn what_a_file_leaves_open() {
    // No group, and a mailbox of which nobody says how long it is.
    let mailbox = "<Sm StartAddress=\"#x1000\" ControlByte=\"#x26\" Enable=\"1\">MBoxOut</Sm>";
    let xml = file("", &value("#x2000", "UINT", 16, ""), mailbox).replace("<GroupType>G</GroupType>", "");
    let (text, made) = fixed(&xml);
    assert!(!text.contains("group") && made.contains("Example drives"), "{text}");
    assert!(!text.contains("enable"), "{text}");
}

#[test]
fn what_can_be_mapped_in_fixed_pdos() {
    // A file may say it of what is mapped, or not.
    for flags in ["", "<PdoMapping>R</PdoMapping>"] {
        let objects = value("#x2000", "UINT", 16, flags);
        let (text, _) = fixed(&file("", &objects, &pdo("RxPdo", "", "#x1600", &entry("#x2000"))));
        assert!(!text.contains("pdo = "), "{text}");
    }
    // What is mapped nowhere could be: the description says so.
    let (text, _) = fixed(&file("", &values(), &pdo("RxPdo", "", "#x1600", &entry("#x2000"))));
    assert!(text.contains("pdo = \"tx\""), "{text}");
}

#[test]
fn identity_in_the_dictionary() {
    let device = |default: &str| {
        let kind = members();
        let object = format!(
            "<Object><Index>#x1018</Index><Name>Identity object</Name><Type>DT1018</Type><BitSize>80</BitSize><Info>\
             <SubItem><Name>SubIndex 000</Name></SubItem><SubItem><Name>Vendor ID</Name></SubItem>\
             <SubItem><Name>Product code</Name>{default}</SubItem></Info></Object>"
        );
        with_types(&kind, &file("", &object, ""))
    };
    for same in ["", "<Info><DefaultData>01000000</DefaultData></Info>"] {
        let (text, made) = fixed(&device(same));
        assert!(!text.contains("default") && made.contains("<DefaultData>01000000</DefaultData>"), "{text}");
    }
    let (text, _) = fixed(&device("<Info><DefaultData>07000000</DefaultData></Info>"));
    assert!(text.contains("default = 0x00000007"), "{text}");
}

/// The type of an identity with vendor and product.
fn members() -> String {
    let member = |subindex: u32, name: &str, kind: &str, bits: u32, place: u32| {
        format!(
            "<SubItem><SubIdx>{subindex}</SubIdx><Name>{name}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>\
             <BitOffs>{place}</BitOffs><Flags><Access>ro</Access></Flags></SubItem>"
        )
    };
    let members = member(0, "SubIndex 000", "USINT", 8, 0)
        + &member(1, "Vendor ID", "UDINT", 32, 16)
        + &member(2, "Product code", "UDINT", 32, 48);
    format!("<DataType><Name>DT1018</Name><BitSize>80</BitSize>{members}</DataType>")
}
