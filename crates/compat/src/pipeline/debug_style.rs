//! Style of the drawn objects in Rapier 0.36: the engine's, and colours of soft bodies.

use super::DebugColor;

/// Style of all drawn objects. It dereferences to the engine's.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct DebugRenderStyle {
    engine: engine::pipeline::DebugRenderStyle,
    /// No effect: the engine has no soft bodies.
    pub soft_body_element_color: DebugColor,
    /// No effect: the engine has no soft bodies.
    pub soft_body_frame_color: DebugColor,
    /// No effect: the engine has no soft bodies.
    pub soft_body_loaded_color: DebugColor,
    /// No effect: the engine has no soft bodies.
    pub soft_body_slack_color: DebugColor,
    /// No effect: the engine has no soft bodies.
    pub volume_contact_normal_color: DebugColor,
    /// No effect: the engine has no soft bodies.
    pub volume_gradient_color: DebugColor,
}

impl Default for DebugRenderStyle {
    fn default() -> Self {
        let color = [300.0, 0.8, 0.6, 1.0];
        Self {
            engine: engine::pipeline::DebugRenderStyle::default(),
            soft_body_element_color: color,
            soft_body_frame_color: color,
            soft_body_loaded_color: color,
            soft_body_slack_color: color,
            volume_contact_normal_color: color,
            volume_gradient_color: color,
        }
    }
}

impl core::ops::Deref for DebugRenderStyle {
    type Target = engine::pipeline::DebugRenderStyle;

    fn deref(&self) -> &engine::pipeline::DebugRenderStyle {
        &self.engine
    }
}

impl core::ops::DerefMut for DebugRenderStyle {
    fn deref_mut(&mut self) -> &mut engine::pipeline::DebugRenderStyle {
        &mut self.engine
    }
}
