//! Lights and sockets against chapter 2.1.

use std::collections::BTreeSet;

use devc_tests::manual::s700;

use crate::{departs, fact, family, plain, rows};

#[test]
fn lights_have_the_patterns_of_the_table() {
    let printed: BTreeSet<_> = rows::<s700::Led>().iter().map(|row| (row.led, row.pattern)).collect();
    for device in &family().members {
        let patterns = device
            .leds
            .iter()
            .flat_map(|led| led.patterns.iter().map(|pattern| (led.name.as_str(), pattern.shows.as_str())));
        assert_eq!(patterns.collect::<BTreeSet<_>>(), printed, "{}", device.id);
    }
}

#[test]
fn lights_mean_what_the_table_says() {
    let leds = &family().members[0].leds;
    let other = rows::<s700::Led>().into_iter().filter_map(|row| {
        let led = leds.iter().find(|led| led.name == row.led)?;
        let means = &led.patterns.iter().find(|pattern| pattern.shows == row.pattern)?.means;
        // The socket stands with the light.
        let socket = plain(row.meaning.rsplit(" at ").next().unwrap_or_default());
        let at = row.meaning.contains(" at ");
        assert!(!at || plain(led.about.as_deref().unwrap_or_default()).contains(&socket), "{row:?}");
        let meaning = row.meaning.split(" at ").next().unwrap_or_default();
        (plain(means) != plain(meaning)).then_some((meaning, means.as_str()))
    });
    departs(other, []);
}

#[test]
fn sockets_are_those_of_the_text() {
    for device in &family().members {
        let kinds = device.connectors.iter().map(|it| plain(it.kind.as_deref().unwrap_or_default()));
        assert!(kinds.into_iter().all(|kind| kind == plain(fact("connector"))));
        for (key, about) in [("port-in", "In:"), ("port-out", "Out:")] {
            let socket = device.connectors.iter().find(|it| plain(&it.name) == plain(fact(key)));
            assert!(
                socket.and_then(|it| it.about.as_ref()).is_some_and(|text| text.starts_with(about)),
                "{key}"
            );
        }
    }
}
