use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A configuration tool opens the `url` in a browser when somebody asks for more about the device. A text that is no
    /// address, such as the title of a manual, leads nowhere.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// url = "see the manual"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// url = "https://example.com/drive"
    /// ```
    pub(super) static RULE = "malformed-url", Facts, Warning, "a URL is no address";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let english = device.url.iter().map(|url| ("url".to_owned(), &**url));
    let others = device.urls.iter().map(|it| (format!("urls.{}", it.language), &*it.text));
    for (key, url) in english.chain(others).filter(|(_, url)| !url.trim().is_empty() && !is_address(url)) {
        let message = format!("`{url}` is no address that a browser can open");
        let diagnostic = Diagnostic::new(&RULE, message, device.origin.value(&key), "leads nowhere")
            .help("write an address such as `https://example.com/drive`, or leave it out");
        report.push(Section::Device.at(&key), diagnostic);
    }
}

/// Whether a text names a host; without a scheme, as `www.example.com`, browsers take it, too.
fn is_address(url: &str) -> bool {
    let url = url.trim();
    let host = |rest: &str| rest.split(['/', '?', '#']).next().unwrap_or_default().to_owned();
    let names_host = match url.split_once("://") {
        Some((_, rest)) => !host(rest).is_empty(),
        None => host(url).trim_matches('.').contains('.'),
    };
    names_host && !url.contains(char::is_whitespace)
}
