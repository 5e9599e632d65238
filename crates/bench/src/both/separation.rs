//! Separation of joints, measured from poses alone. The measurement is the same for all engines.

use super::ours::prelude::*;
use super::template::Template;

/// Returns the largest distance (length units) between the two anchors of any joint that locks them together.
/// `poses` are the poses of the bodies. Returns `None` if there is no such joint.
pub fn largest_separation(template: &Template, poses: &[Pose]) -> Option<f64> {
    let holds = |joint: &GenericJoint| joint.locked_axes.contains(JointAxesMask::LIN_AXES);
    let gaps = template.joints.iter().filter(|(_, joint)| holds(joint)).map(|(bodies, joint)| {
        let [pose1, pose2] = bodies.map(|body| poses[body]);
        (pose1 * joint.local_anchor1() - pose2 * joint.local_anchor2()).length()
    });
    gaps.map(f64::from).reduce(f64::max)
}
