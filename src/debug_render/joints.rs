//! Joints as lines.
//!
//! Two lines lead from the bodies to the anchors of the joint. A third line connects the anchors. If the
//! joint locks all translations, the length of the third is the joint's error. That of a pulley leads over
//! the points of the rope. The free axes are drawn in the joint's frame on the first body. A translation is a
//! line with two ends. A rotation is an arc, and a pointer at the second body shows the angle on it. The
//! pointer is exact for a rotation about one axis: a swing about two has components, and no angles in planes.

use super::backend::{DebugRenderBackend, DebugRenderObject};
use super::pipeline::{DebugRenderMode, DebugRenderPipeline};
use super::style::{AXIS_HUES, DebugColor, times};
use crate::base::outline::{Detail, Outline};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{ANG_DIM, DIM, Real, Vector};
use crate::dim::spatial::rotation_about;
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::joint::{GenericJoint, ImpulseJointSet, JointLimits, TransmissionEnd, mask_of};
use crate::model::multibody::MultibodyJointSet;
use arrayvec::ArrayVec;

/// A quarter turn, and half a turn (rad).
const QUARTER_TURN: Real = core::f64::consts::FRAC_PI_2 as Real;
const HALF_TURN: Real = core::f64::consts::PI as Real;
/// Length of the marks at the ends of a range, relative to the length of the axes.
const MARK_FRACTION: Real = 0.2;

/// A joint, its bodies and the colours of its lines.
struct DrawnJoint<'a> {
    object: DebugRenderObject<'a>,
    joint: &'a GenericJoint,
    bodies: [&'a RigidBody; 2],
    /// Colours of the lines to the anchors and between them.
    colors: [DebugColor; 2],
}

impl DebugRenderPipeline {
    /// Draws the joints of both kinds, whichever the mode selects. Joints without one of their bodies are
    /// left out.
    pub fn render_joints(
        &mut self,
        backend: &mut dyn DebugRenderBackend,
        bodies: &RigidBodySet,
        impulse_joints: &ImpulseJointSet,
        multibody_joints: &MultibodyJointSet,
    ) {
        let style = self.style;
        let find = |handles: [RigidBodyHandle; 2]| {
            Some([bodies.get(handles[0])?, bodies.get(handles[1])?])
        };
        if self.mode.contains(DebugRenderMode::IMPULSE_JOINTS) {
            let colors = [style.impulse_joint_anchor_color, style.impulse_joint_separation_color];
            for (handle, joint) in impulse_joints.iter() {
                let object = DebugRenderObject::ImpulseJoint(handle, joint);
                if let Some(bodies) = find([joint.body1(), joint.body2()]) {
                    self.render_joint(
                        backend,
                        &DrawnJoint { object, joint: &joint.data, bodies, colors },
                    );
                }
            }
        }
        if self.mode.contains(DebugRenderMode::MULTIBODY_JOINTS) {
            let colors =
                [style.multibody_joint_anchor_color, style.multibody_joint_separation_color];
            for (handle, _, multibody, link) in multibody_joints.iter() {
                let object = DebugRenderObject::MultibodyJoint(handle, multibody, link);
                let Some(parent) = link.parent_id().and_then(|id| multibody.link(id)) else {
                    continue;
                };
                if let Some(bodies) = find([parent.rigid_body_handle(), link.rigid_body_handle()]) {
                    let joint = &link.joint().data;
                    self.render_joint(backend, &DrawnJoint { object, joint, bodies, colors });
                }
            }
        }
    }

    fn render_joint(&self, backend: &mut dyn DebugRenderBackend, drawn: &DrawnJoint<'_>) {
        let &DrawnJoint { object, joint, bodies: [body1, body2], colors: [anchor, separation] } =
            drawn;
        if !backend.filter_object(object) {
            return;
        }
        let multiplier = self.joint_multiplier(drawn);
        let [frame1, frame2] =
            [*body1.position() * joint.local_frame1, *body2.position() * joint.local_frame2];
        let (p1, p2) = (frame1.translation, frame2.translation);
        backend.draw_line(object, body1.translation(), p1, times(anchor, multiplier));
        backend.draw_line(object, body2.translation(), p2, times(anchor, multiplier));
        let way = way_between(joint, [p1, p2]);
        for pair in way.windows(2) {
            backend.draw_line(object, pair[0], pair[1], times(separation, multiplier));
        }
        if self.mode.contains(DebugRenderMode::JOINT_AXES) && joint.transmission().is_none() {
            for axis in free_axes(joint) {
                let color = times(axis_color(axis), multiplier);
                let sketch = self.sketch(joint, axis);
                backend.draw_polyline(
                    object,
                    &sketch.points,
                    &sketch.lines,
                    &frame1,
                    &Vector::ONE,
                    color,
                );
                if axis as usize >= DIM {
                    let pointer = zero_of(axis) * self.style.joint_axes_length;
                    backend.draw_line(object, p2, frame2 * pointer, color);
                }
            }
        }
    }

    /// Colour factor of a joint: it sleeps if no body of it is awake.
    fn joint_multiplier(&self, drawn: &DrawnJoint<'_>) -> [f32; 4] {
        let rests = |body: &RigidBody| body.is_sleeping() || !body.is_dynamic();
        let is_off = |body: &RigidBody| !body.is_enabled();
        if !drawn.joint.is_enabled() || drawn.bodies.into_iter().any(is_off) {
            self.style.disabled_color_multiplier
        } else if drawn.bodies.into_iter().all(rests) {
            self.style.sleep_color_multiplier
        } else {
            [1.0; 4]
        }
    }

    /// Form of a free axis, in the joint's frame on the first body.
    fn sketch(&self, joint: &GenericJoint, axis: JointAxis) -> Outline {
        let length = self.style.joint_axes_length;
        let mut sketch = Outline::default();
        if (axis as usize) < DIM {
            let (along, [from, to]) = (Vector::AXES[axis as usize], range(joint, axis, length));
            let mark = Vector::AXES[(axis as usize + 1) % DIM] * (MARK_FRACTION * length);
            sketch.segment(along * from, along * to);
            for end in [along * from, along * to] {
                sketch.segment(end - mark, end + mark);
            }
            return sketch;
        }
        let [from, to] = range(joint, axis, HALF_TURN);
        let to = to.min(from + 2.0 * HALF_TURN);
        let zero = zero_of(axis);
        let axes = [zero, rotation_about(axis as usize - DIM, QUARTER_TURN) * zero];
        let axes = axes.map(|direction| direction * length);
        let detail = Detail::new(self.style.subdivisions, self.style.border_subdivisions);
        sketch.arc(Vector::ZERO, axes, [from, to], detail.subdivisions);
        if to - from < 2.0 * HALF_TURN {
            for angle in [from, to] {
                sketch.segment(Vector::ZERO, axes[0] * angle.cos() + axes[1] * angle.sin());
            }
        }
        sketch
    }
}

/// The way from one anchor to the other: directly, or over the points of a pulley.
fn way_between(joint: &GenericJoint, [from, to]: [Vector; 2]) -> ArrayVec<Vector, 4> {
    let mut way: ArrayVec<Vector, 4> = ArrayVec::new();
    way.push(from);
    for end in joint.transmission().into_iter().flat_map(|transmission| transmission.ends) {
        if let TransmissionEnd::Distance { from } = end {
            way.push(from);
        }
    }
    way.push(to);
    way
}

/// The free axes that are drawn. Coupled translations are a distance, which is the line between
/// the anchors. If no translation is locked, rotations are drawn only with limits or a motor.
fn free_axes(joint: &GenericJoint) -> impl Iterator<Item = JointAxis> {
    let free = !joint.locked_axes;
    let driven = joint.limit_axes | joint.motor_axes;
    let holds_a_place = joint.locked_axes.intersects(JointAxesMask::LIN_AXES);
    JointAxis::ALL.into_iter().filter(move |&axis| {
        let shows = match (axis as usize) < DIM {
            true => !joint.is_measured_together(axis),
            false => holds_a_place || driven.contains(mask_of(axis)),
        };
        free.contains(mask_of(axis)) && shows
    })
}

/// Direction of the pointer of a rotation at angle 0: the first axis that the rotation moves.
fn zero_of(axis: JointAxis) -> Vector {
    let quarter = rotation_about(axis as usize - DIM, QUARTER_TURN);
    let turns = |direction: &Vector| (quarter * *direction).dot(*direction) < 0.5;
    Vector::AXES.into_iter().find(turns).unwrap_or(Vector::X)
}

/// The drawn range of an axis: its limits, if it has any, or `reach` to both sides.
fn range(joint: &GenericJoint, axis: JointAxis, reach: Real) -> [Real; 2] {
    let shared = joint.is_measured_together(axis);
    // Limits and motor of the first of several coupled axes are those of all.
    let known = JointAxis::ALL.into_iter().find(|&first| match shared {
        true => first as usize >= DIM && joint.is_measured_together(first),
        false => first == axis,
    });
    let limits = known.and_then(|first| joint.limits(first)).copied().unwrap_or_default();
    let JointLimits { min, max, .. } = limits;
    match (min > -Real::MAX, max < Real::MAX) {
        (true, true) if shared => [-max, max],
        (true, true) => [min, max],
        (true, false) => [min, min + 2.0 * reach],
        (false, true) => [max - 2.0 * reach, max],
        (false, false) => [-reach, reach],
    }
}

/// Red, green and blue for X, Y and Z. The rotation of 2D is one about Z.
fn axis_color(axis: JointAxis) -> DebugColor {
    let direction = match (axis as usize).checked_sub(DIM) {
        Some(rotation) => rotation + AXIS_HUES.len() - ANG_DIM,
        None => axis as usize,
    };
    [AXIS_HUES[direction], 1.0, 0.6, 1.0]
}
