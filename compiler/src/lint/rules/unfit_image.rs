use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Tools show a picture beside the name of a device. ETG.2000 wants a BMP file of 16 by 14 points; another one is shown
    /// distorted, or not at all, and some tools refuse the file.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// image = "drive.bmp"
    ///
    /// # file: drive.bmp
    /// no picture
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// ```
    pub(crate) static RULE = "unfit-image", Output, Warning, "a picture is none of 16 by 14 points";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(image) = &device.image else { return };
    let fault = match size(&image.bytes.0) {
        Some((16, 14)) => return,
        Some((width, height)) => format!("`{}` has {width} by {height} points, not 16 by 14", image.file),
        None => format!("`{}` is no BMP file", image.file),
    };
    let diagnostic = Diagnostic::new(&RULE, fault, device.origin.value("image"), "for the ESI");
    report.push(Section::Device.at("image"), diagnostic);
}

/// Width and height of a BMP file: whole numbers of four bytes at 18 and 22. A height below 0 counts rows from the top.
fn size(bytes: &[u8]) -> Option<(u32, u32)> {
    let number = |at: usize| bytes.get(at..)?.first_chunk().copied().map(i32::from_le_bytes);
    bytes.starts_with(b"BM").then_some(())?;
    Some((number(18)?.unsigned_abs(), number(22)?.unsigned_abs()))
}
