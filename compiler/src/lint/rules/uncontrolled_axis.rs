use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// The drive plug-in of `ethercat_driver_ros2` knows the objects of CiA 402 by their indices on the first axis, and runs one
    /// state machine. A device with several axes is a plain slave there: each value has an interface of its own, and a
    /// controller has to go through the states of each axis.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names = ["X", "Y"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names = ["X"]
    /// ```
    pub(crate) static RULE = "uncontrolled-axis", Output, Warning, "the drive plug-in of ROS 2 controls one axis";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let (count, arrangement) = (device.axes.len(), &device.arrangement);
    if count > 1 {
        let message = format!("the drive plug-in of ROS 2 controls the first of {count} axes");
        let at = arrangement.origin.value("names");
        let diagnostic = Diagnostic::new(&RULE, message, at, "more than one")
            .note("the file is for `GenericEcSlave`, which leaves the states to controllers");
        report.push(Section::Axes.at("names"), diagnostic);
    }
}
