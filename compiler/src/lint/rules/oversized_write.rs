use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, SdoWrite, Section};

rule! {
    /// What `ethercat_driver_ros2` writes at start-up are whole numbers of 8, 16 and 32 bits. Another value of a configuration is
    /// left out, so that a program has to write it.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Offset"
    /// type = "INT64"
    /// access = "rw"
    ///
    /// [configurations.shifted]
    /// name = "Shifted"
    /// writes = [{ entry = "0x2000", value = 5, why = "the tool is longer" }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Offset"
    /// type = "INT32"
    /// access = "rw"
    ///
    /// [configurations.shifted]
    /// name = "Shifted"
    /// writes = [{ entry = "0x2000", value = 5, why = "the tool is longer" }]
    /// ```
    pub(crate) static RULE = "oversized-write", Output, Warning, "a value at start-up cannot be written in ROS 2";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for configuration in &device.configurations {
        for write in configuration.startup.iter().filter(|write| !is_held(write)) {
            let (address, bytes) = (write.address, write.data.len());
            let message = format!("{address} is written with {bytes} bytes, which ROS 2 does not");
            let at = configuration.origin.header();
            let diagnostic = Diagnostic::new(&RULE, message, at, "is left out in ROS 2");
            report.push(Section::Configurations.at(&configuration.id), diagnostic);
        }
    }
}

/// Assignment and mapping are the master's own.
fn is_held(write: &SdoWrite) -> bool {
    write.address.index.is_derived() || matches!(write.data.len(), 1 | 2 | 4)
}
