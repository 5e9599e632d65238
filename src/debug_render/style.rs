//! Colours and lengths.

use crate::dim::math::Real;

/// A colour: hue (degrees), saturation, lightness and opacity (each 0 to 1).
pub type DebugColor = [f32; 4];

/// Hues of X, Y and Z (degrees): red, green, blue.
pub(super) const AXIS_HUES: [f32; 3] = [0.0, 120.0, 220.0];

/// Style of all drawn objects. The defaults are made for a dark background.
///
/// A multiplier is applied to a colour part by part: `[1.0, 1.0, 0.5, 1.0]` halves the lightness.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct DebugRenderStyle {
    /// Straight pieces of a circle (4 to 512; values outside count as the nearest).
    pub subdivisions: u32,
    /// Straight pieces of a rounded border's quarter turn (1 to 128; values outside count as the
    /// nearest).
    pub border_subdivisions: u32,
    /// Colliders of dynamic bodies.
    pub collider_dynamic_color: DebugColor,
    /// Colliders of fixed bodies.
    pub collider_fixed_color: DebugColor,
    /// Colliders of kinematic bodies.
    pub collider_kinematic_color: DebugColor,
    /// Colliders without a body.
    pub collider_parentless_color: DebugColor,
    /// Boxes of colliders.
    pub collider_aabb_color: DebugColor,
    /// Colour factor of a sleeping body and its colliders and joints.
    pub sleep_color_multiplier: [f32; 4],
    /// Colour factor of a body that is ready to sleep while its island is not.
    pub sleep_eligible_color_multiplier: [f32; 4],
    /// Colour factor of a disabled collider or body.
    pub disabled_color_multiplier: [f32; 4],
    /// Length of a body's axes (length units). They are red, green and, in 3D, blue.
    pub rigid_body_axes_length: Real,
    /// Lines from bodies to the anchors of an impulse joint.
    pub impulse_joint_anchor_color: DebugColor,
    /// Lines between the two anchors of an impulse joint.
    pub impulse_joint_separation_color: DebugColor,
    /// Lines from bodies to the anchors of a multibody joint.
    pub multibody_joint_anchor_color: DebugColor,
    /// Lines between the two anchors of a multibody joint.
    pub multibody_joint_separation_color: DebugColor,
    /// Length of a joint's free axes without limits, and radius of its arcs (length units). They are red,
    /// green and blue like a body's axes; in 2D arcs are blue.
    pub joint_axes_length: Real,
    /// Lines between the points of two surfaces that are in contact.
    pub contact_depth_color: DebugColor,
    /// Normals of contacts.
    pub contact_normal_color: DebugColor,
    /// Length of the normals of contacts (length units).
    pub contact_normal_length: Real,
    /// Pseudo-normals of a mesh at its vertices.
    pub vertex_pseudo_normal_color: DebugColor,
    /// Pseudo-normals of a mesh at its edges.
    pub edge_pseudo_normal_color: DebugColor,
    /// Length of these normals (length units).
    pub pseudo_normal_length: Real,
}

impl Default for DebugRenderStyle {
    fn default() -> Self {
        Self {
            subdivisions: 32,
            border_subdivisions: 5,
            collider_dynamic_color: [205.0, 0.80, 0.62, 1.0],
            collider_fixed_color: [215.0, 0.15, 0.50, 1.0],
            collider_kinematic_color: [32.0, 0.90, 0.60, 1.0],
            collider_parentless_color: [150.0, 0.25, 0.50, 1.0],
            collider_aabb_color: [280.0, 0.70, 0.65, 0.5],
            sleep_color_multiplier: [1.0, 0.75, 0.7, 1.0],
            sleep_eligible_color_multiplier: [1.0, 0.9, 0.85, 1.0],
            disabled_color_multiplier: [1.0, 0.0, 0.5, 0.5],
            rigid_body_axes_length: 0.5,
            impulse_joint_anchor_color: [265.0, 0.75, 0.70, 1.0],
            impulse_joint_separation_color: [340.0, 0.95, 0.60, 1.0],
            multibody_joint_anchor_color: [165.0, 0.75, 0.60, 1.0],
            multibody_joint_separation_color: [20.0, 0.95, 0.60, 1.0],
            joint_axes_length: 0.4,
            contact_depth_color: [350.0, 0.95, 0.60, 1.0],
            contact_normal_color: [55.0, 0.95, 0.65, 1.0],
            contact_normal_length: 0.3,
            vertex_pseudo_normal_color: [120.0, 0.80, 0.60, 1.0],
            edge_pseudo_normal_color: [175.0, 0.80, 0.60, 1.0],
            pseudo_normal_length: 0.5,
        }
    }
}

/// A colour times a multiplier, part by part.
pub(super) fn times(color: DebugColor, multiplier: [f32; 4]) -> DebugColor {
    core::array::from_fn(|part| color[part] * multiplier[part])
}
