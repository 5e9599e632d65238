//! Lines over the surfaces: the lines of the debug-renderer, and marks of bodies.

use super::palette::spread;
use crate::rapier::prelude::*;
use crate::shapes::point;
use drawing::{Color, Drawing, Line};

/// Selection of drawn items besides the surfaces.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Overlays {
    /// Parts that the debug-renderer draws.
    pub lines: DebugRenderMode,
    /// Whether centres of mass are marked.
    pub centers_of_mass: bool,
    /// Whether velocities of bodies are drawn.
    pub velocities: bool,
    /// Whether impulses of contacts are drawn along their normals.
    pub impulses: bool,
    /// Whether contacts have the colour in which the solver takes their constraint.
    pub solver_colors: bool,
    /// Whether sleeping bodies are dimmed.
    pub sleep: bool,
    /// Whether bodies have the colour of their island.
    pub islands: bool,
    /// Whether surfaces are drawn.
    pub surfaces: bool,
    /// Length of normals and axes (length units).
    pub length: Real,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            lines: DebugRenderMode::JOINTS,
            centers_of_mass: false,
            velocities: false,
            impulses: false,
            solver_colors: false,
            sleep: true,
            islands: false,
            surfaces: true,
            length: 0.4,
        }
    }
}

/// Colours of marks (hue, saturation, lightness).
const CENTER: [f32; 3] = [52.0, 0.95, 0.62];
const VELOCITY: [f32; 3] = [165.0, 0.85, 0.60];
const IMPULSE: [f32; 3] = [18.0, 0.95, 0.62];
/// Length of the line of a velocity, in seconds of motion.
const VELOCITY_TIME: Real = 0.15;
/// Saturation and lightness of solver colours, and the look of constraints without one.
const SOLVER_COLOR: [f32; 2] = [0.85, 0.60];
const OVERFLOW: [f32; 3] = [0.0, 0.0, 0.95];
/// The engine's number for constraints without a colour.
const OVERFLOW_COLOR: u32 = 64;

impl Overlays {
    /// Adds the marks of bodies and contacts that the debug-renderer has none for.
    pub(super) fn mark(&self, world: &PhysicsWorld, out: &mut Drawing) {
        let bodies = world.bodies.iter().filter(|(_, body)| !body.is_fixed());
        for (_, body) in bodies {
            let center = body.center_of_mass();
            if self.centers_of_mass {
                for axis in Vector::AXES {
                    let arm = axis * (0.25 * self.length);
                    out.line(mark(center - arm, center + arm, CENTER));
                }
            }
            if self.velocities {
                out.line(mark(center, center + body.linvel() * VELOCITY_TIME, VELOCITY));
            }
        }
        if self.impulses {
            self.mark_impulses(world, out);
        }
        if self.solver_colors {
            self.mark_solver_colors(world, out);
        }
    }

    /// A cross at each contact point and its normal, with a hue for each solver colour; white for the
    /// overflow.
    fn mark_solver_colors(&self, world: &PhysicsWorld, out: &mut Drawing) {
        for manifold in world.narrow_phase.contact_pairs().flat_map(|(_, _, pair)| &pair.manifolds)
        {
            let Some(number) = manifold.solver_color() else { continue };
            let look = solver_look(number);
            for contact in &manifold.data {
                for axis in Vector::AXES {
                    let arm = axis * (0.2 * self.length);
                    out.line(mark(contact.point - arm, contact.point + arm, look));
                }
                let tip = contact.point + manifold.data.normal * self.length;
                out.line(mark(contact.point, tip, look));
            }
        }
    }

    /// Impulses of contacts; the largest of the scene has twice the length of a normal.
    fn mark_impulses(&self, world: &PhysicsWorld, out: &mut Drawing) {
        let manifolds =
            || world.narrow_phase.contact_pairs().flat_map(|(_, _, pair)| &pair.manifolds);
        let impulses = manifolds().flat_map(|manifold| &manifold.data).map(|c| c.impulse);
        let largest = impulses.fold(0.0, Real::max);
        if largest <= 0.0 {
            return;
        }
        for manifold in manifolds() {
            for contact in &manifold.data {
                let length = 2.0 * self.length * contact.impulse / largest;
                let tip = contact.point + manifold.data.normal * length;
                out.line(mark(contact.point, tip, IMPULSE));
            }
        }
    }
}

/// The look of a solver colour.
fn solver_look(number: u32) -> [f32; 3] {
    let [saturation, lightness] = SOLVER_COLOR;
    match number {
        OVERFLOW_COLOR => OVERFLOW,
        _ => [spread(number) * 360.0, saturation, lightness],
    }
}

fn mark(from: Vector, to: Vector, [hue, saturation, lightness]: [f32; 3]) -> Line {
    let color = Color::from_hsl(hue, saturation, lightness, 1.0);
    Line { from: point(from), to: point(to), color, on_top: true }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// A tower of boxes on the ground after a step.
    fn tower() -> PhysicsWorld {
        let mut world = PhysicsWorld::new();
        let shape = || ColliderBuilder::new(SharedShape::new(Cuboid::new(Vector::splat(0.5))));
        for i in 0..4 {
            let place = Vector::Y * i as Real;
            let kind = if i == 0 { RigidBodyBuilder::fixed() } else { RigidBodyBuilder::dynamic() };
            world.insert(kind.translation(place), shape());
        }
        world.step();
        world
    }

    #[test]
    fn contacts_of_a_body_have_different_solver_colors() {
        let world = tower();
        let mut taken = HashSet::new();
        for (first, second, pair) in world.narrow_phase.contact_pairs() {
            for manifold in &pair.manifolds {
                let color = manifold.solver_color().expect("the tower is awake");
                assert!(color < OVERFLOW_COLOR);
                let bodies = [first, second].map(|handle| world.colliders[handle].parent());
                for body in bodies.into_iter().flatten().filter(|b| world.bodies[*b].is_dynamic()) {
                    assert!(taken.insert((body, color)), "{body:?} has colour {color} twice");
                }
            }
        }
        assert_eq!(taken.len(), 5, "each inner box has two contacts, the highest has one");
    }

    #[test]
    fn marks_show_each_contact_point_in_its_solver_color() {
        let world = tower();
        let mut drawing = Drawing::default();
        Overlays { solver_colors: true, ..Overlays::default() }.mark(&world, &mut drawing);
        let pairs = world.narrow_phase.contact_pairs();
        let points: usize =
            pairs.flat_map(|(.., pair)| &pair.manifolds).map(|m| m.contacts().len()).sum();
        assert!(points > 0);
        assert_eq!(drawing.lines.len(), points * (DIM + 1));
    }
}
