//! Style of the drawn objects in Rapier 0.36: the engine's, and colours of soft bodies.

use super::DebugColor;
use crate::math::Real;

/// Defines the style: fields that the engine has too, and fields without effect.
macro_rules! style {
    ($($(#[$doc:meta])* $field:ident: $type:ty,)* ; $($unused:ident,)*) => {
        /// Style of all drawn objects.
        #[derive(Copy, Clone, Debug, PartialEq)]
        pub struct DebugRenderStyle {
            $($(#[$doc])* pub $field: $type,)*
            $(#[doc = "No effect: the engine has no soft bodies."] pub $unused: DebugColor,)*
        }

        impl Default for DebugRenderStyle {
            fn default() -> Self {
                let own = engine::pipeline::DebugRenderStyle::default();
                let color = [300.0, 0.8, 0.6, 1.0];
                Self { $($field: own.$field,)* $($unused: color,)* }
            }
        }

        impl From<DebugRenderStyle> for engine::pipeline::DebugRenderStyle {
            fn from(style: DebugRenderStyle) -> Self {
                Self { $($field: style.$field,)* ..Self::default() }
            }
        }
    };
}

style! {
    /// Straight pieces of a circle.
    subdivisions: u32,
    /// Straight pieces of a rounded border's quarter turn.
    border_subdivisions: u32,
    /// Colliders of dynamic bodies.
    collider_dynamic_color: DebugColor,
    /// Colliders of fixed bodies.
    collider_fixed_color: DebugColor,
    /// Colliders of kinematic bodies.
    collider_kinematic_color: DebugColor,
    /// Colliders without a body.
    collider_parentless_color: DebugColor,
    /// Boxes of colliders.
    collider_aabb_color: DebugColor,
    /// Colour factor of a sleeping body.
    sleep_color_multiplier: [f32; 4],
    /// Colour factor of a body that is ready to sleep while its island is not.
    sleep_eligible_color_multiplier: [f32; 4],
    /// Colour factor of a disabled collider or body.
    disabled_color_multiplier: [f32; 4],
    /// Length of a body's axes (length units).
    rigid_body_axes_length: Real,
    /// Lines from bodies to the anchors of an impulse joint.
    impulse_joint_anchor_color: DebugColor,
    /// Lines between the two anchors of an impulse joint.
    impulse_joint_separation_color: DebugColor,
    /// Lines from bodies to the anchors of a multibody joint.
    multibody_joint_anchor_color: DebugColor,
    /// Lines between the two anchors of a multibody joint.
    multibody_joint_separation_color: DebugColor,
    /// Lines between the points of two surfaces that are in contact.
    contact_depth_color: DebugColor,
    /// Normals of contacts.
    contact_normal_color: DebugColor,
    /// Length of the normals of contacts (length units).
    contact_normal_length: Real,
    /// Pseudo-normals of a mesh at its vertices.
    vertex_pseudo_normal_color: DebugColor,
    /// Pseudo-normals of a mesh at its edges.
    edge_pseudo_normal_color: DebugColor,
    /// Length of these normals (length units).
    pseudo_normal_length: Real,
    ;
    soft_body_element_color,
    soft_body_frame_color,
    soft_body_loaded_color,
    soft_body_slack_color,
    volume_contact_normal_color,
    volume_gradient_color,
}
