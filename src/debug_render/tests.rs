//! What is drawn, in which colours.

use super::*;
use crate::dim::math::{DIM, Real, Vector};
use crate::model::body::{RigidBodyBuilder, RigidBodySet};
use crate::model::collider::{ColliderBuilder, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;

/// Keeps what is drawn; draws nothing of sensors.
#[derive(Default)]
struct Paper {
    lines: Vec<(Vector, Vector, DebugColor)>,
}

impl DebugRenderBackend for Paper {
    fn filter_object(&self, object: DebugRenderObject) -> bool {
        !matches!(object, DebugRenderObject::Collider(_, collider) if collider.is_sensor())
    }

    fn draw_line(&mut self, _: DebugRenderObject, a: Vector, b: Vector, color: DebugColor) {
        self.lines.push((a, b, color));
    }
}

impl Paper {
    fn has_color(&self, color: DebugColor) -> bool {
        self.lines.iter().any(|line| line.2 == color)
    }
}

#[derive(Default)]
struct World {
    bodies: RigidBodySet,
    colliders: ColliderSet,
}

impl World {
    fn insert(&mut self, body: RigidBodyBuilder, collider: ColliderBuilder) {
        let body = self.bodies.insert(body.build());
        self.colliders.insert_with_parent(collider.build(), body, &mut self.bodies);
    }

    fn draw(&self, mode: DebugRenderMode) -> Paper {
        let mut paper = Paper::default();
        DebugRenderPipeline::new(DebugRenderStyle::default(), mode).render(
            &mut paper,
            &self.bodies,
            &self.colliders,
            &ImpulseJointSet::new(),
            &MultibodyJointSet::new(),
            &NarrowPhase::new(),
        );
        paper
    }
}

#[test]
fn color_tells_the_type_of_the_body() {
    let style = DebugRenderStyle::default();
    let kinds = [
        (RigidBodyBuilder::dynamic(), style.collider_dynamic_color),
        (RigidBodyBuilder::fixed(), style.collider_fixed_color),
        (RigidBodyBuilder::kinematic_velocity_based(), style.collider_kinematic_color),
        (RigidBodyBuilder::kinematic_position_based(), style.collider_kinematic_color),
        (
            RigidBodyBuilder::dynamic().sleeping(true),
            style::times(style.collider_dynamic_color, style.sleep_color_multiplier),
        ),
    ];
    for (body, color) in kinds {
        let mut world = World::default();
        world.insert(body, ColliderBuilder::ball(1.0));
        let paper = world.draw(DebugRenderMode::COLLIDER_SHAPES);
        assert!(paper.has_color(color));
        assert!(paper.lines.iter().all(|line| line.2 == color));
    }
    let mut world = World::default();
    world.colliders.insert(ColliderBuilder::ball(1.0).build());
    let paper = world.draw(DebugRenderMode::COLLIDER_SHAPES);
    assert!(paper.has_color(style.collider_parentless_color));
}

#[test]
fn shapes_are_drawn_where_they_are() {
    let center = Vector::ONE * 3.0;
    let mut world = World::default();
    let body = RigidBodyBuilder::dynamic().translation(center);
    world.insert(body, ColliderBuilder::ball(0.5));
    let paper = world.draw(DebugRenderMode::COLLIDER_SHAPES);
    for (a, b, _) in &paper.lines {
        assert!((*a - center).length() < 0.5001 && (*b - center).length() < 0.5001);
    }
}

#[test]
fn the_mode_and_the_filter_are_obeyed() {
    let mut world = World::default();
    world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(1.0).sensor(true));
    assert!(world.draw(DebugRenderMode::empty()).lines.is_empty());
    assert!(world.draw(DebugRenderMode::COLLIDER_SHAPES).lines.is_empty());
    assert_eq!(world.draw(DebugRenderMode::RIGID_BODY_AXES).lines.len(), DIM);
    let edges_of_a_box = DIM << (DIM - 1);
    assert_eq!(world.draw(DebugRenderMode::COLLIDER_AABBS).lines.len(), edges_of_a_box);
    assert_eq!(world.draw(DebugRenderMode::all()).lines.len(), DIM + edges_of_a_box);
}

#[test]
fn absurd_styles_draw_all_the_same() {
    let mut world = World::default();
    world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::capsule_y(1.0, 0.5));
    for subdivisions in [0, 1, 3, u32::MAX] {
        let mut paper = Paper::default();
        let style = DebugRenderStyle {
            subdivisions,
            border_subdivisions: subdivisions,
            ..Default::default()
        };
        let mut pipeline = DebugRenderPipeline::new(style, DebugRenderMode::COLLIDER_SHAPES);
        pipeline.render_colliders(&mut paper, &world.bodies, &world.colliders);
        assert!(!paper.lines.is_empty());
        assert!(paper.lines.iter().all(|line| line.0.is_finite() && line.1.is_finite()));
    }
}

#[test]
fn strips_close_and_bad_indices_are_left_out() {
    let body = RigidBodyBuilder::dynamic().build();
    let object =
        DebugRenderObject::RigidBody(crate::model::body::RigidBodyHandle::invalid(), &body);
    let corners: Vec<Vector> = (0..4).map(|i| Vector::X * i as Real).collect();
    let pose = crate::dim::math::Pose::IDENTITY;
    for (count, closed, expected) in [(4, true, 4), (4, false, 3), (2, true, 1), (1, true, 0)] {
        let mut paper = Paper::default();
        let strip = &corners[..count];
        paper.draw_line_strip(object, strip, &pose, &Vector::ONE, [0.0; 4], closed);
        assert_eq!(paper.lines.len(), expected);
    }
    let mut paper = Paper::default();
    let scale = Vector::ONE * 2.0;
    paper.draw_polyline(object, &corners, &[[0, 3], [0, 9]], &pose, &scale, [0.0; 4]);
    assert_eq!(paper.lines, [(Vector::ZERO, Vector::X * 6.0, [0.0; 4])]);
}

#[test]
fn outlines_of_dropped_shapes_are_forgotten() {
    let mut world = World::default();
    let vertices: Vec<Vector> = (0..300).map(|i| Vector::X * i as Real).collect();
    let line = parry::shape::SharedShape::polyline(vertices, None);
    let handle = world.colliders.insert(ColliderBuilder::new(line).build());
    let mut pipeline = DebugRenderPipeline::default();
    let mut paper = Paper::default();
    pipeline.render_colliders(&mut paper, &world.bodies, &world.colliders);
    assert_eq!(pipeline.outlines_kept(), 1);
    let islands = &mut crate::model::island::IslandManager::new();
    world.colliders.remove(handle, islands, &mut world.bodies, true);
    pipeline.render_colliders(&mut paper, &world.bodies, &world.colliders);
    assert_eq!(pipeline.outlines_kept(), 0);
}
