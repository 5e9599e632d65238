//! The drawn lines and their colours.

use super::*;
use crate::base::outline::Detail;
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{ANG_DIM, DIM, Real, Vector};
use crate::dim::outline::samples;
use crate::model::body::{RigidBodyBuilder, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderBuilder, ColliderSet};
use crate::model::contact::NarrowPhase;
use crate::model::joint::{GenericJointBuilder, ImpulseJointSet};
use crate::model::multibody::MultibodyJointSet;
use parry::shape::TriMeshFlags;

/// Stores the lines; draws no sensors.
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
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
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
            &self.impulse_joints,
            &self.multibody_joints,
            &NarrowPhase::new(),
        );
        paper
    }

    /// Two bodies without colliders, the second three units along X from the first.
    fn pair(&mut self) -> [RigidBodyHandle; 2] {
        [0.0, 3.0]
            .map(|x| self.bodies.insert(RigidBodyBuilder::dynamic().translation(Vector::X * x)))
    }
}

#[test]
fn color_depends_on_the_type_of_the_body() {
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

/// Meshes keep sums of the normals of faces, which are 0.7 to 2.7 long; the lines have the length of the
/// style.
#[test]
fn pseudo_normals_have_the_length_of_the_style() {
    let corners = [Vector::ZERO].into_iter().chain(Vector::AXES).collect();
    let faces: &[[u32; 3]] =
        if DIM == 2 { &[[0, 1, 2]] } else { &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] };
    let mesh = ColliderBuilder::trimesh_with_flags(corners, faces.to_vec(), TriMeshFlags::ORIENTED);
    let mut world = World::default();
    world.insert(RigidBodyBuilder::dynamic(), mesh.expect("a tetrahedron or triangle is a mesh"));
    let paper = world.draw(DebugRenderMode::PSEUDO_NORMALS);
    assert_eq!(paper.lines.is_empty(), DIM == 2, "only solids have them");
    let expected = DebugRenderStyle::default().pseudo_normal_length;
    for (foot, tip, _) in paper.lines {
        let length = (tip - foot).length();
        assert!((length - expected).abs() < 1.0e-5, "a normal of {length} instead of {expected}");
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
fn outlines_of_dropped_shapes_are_removed() {
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

#[test]
fn joints_are_drawn_from_bodies_to_anchors() {
    let style = DebugRenderStyle::default();
    let joint = || {
        GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES)
            .local_anchor1(Vector::X)
            .local_anchor2(Vector::Y)
            .build()
    };
    let [p1, p2] = [Vector::X, Vector::X * 3.0 + Vector::Y];
    let lines = |anchor, separation| {
        [(Vector::ZERO, p1, anchor), (Vector::X * 3.0, p2, anchor), (p1, p2, separation)]
    };

    let mut world = World::default();
    let [body1, body2] = world.pair();
    world.impulse_joints.insert(body1, body2, joint(), true);
    let drawn = world.draw(DebugRenderMode::IMPULSE_JOINTS).lines;
    let colors = (style.impulse_joint_anchor_color, style.impulse_joint_separation_color);
    assert_eq!(drawn, lines(colors.0, colors.1));
    assert!(world.draw(DebugRenderMode::MULTIBODY_JOINTS).lines.is_empty());

    let mut world = World::default();
    let [body1, body2] = world.pair();
    world.multibody_joints.insert(body1, body2, joint(), true);
    let drawn = world.draw(DebugRenderMode::MULTIBODY_JOINTS).lines;
    let colors = (style.multibody_joint_anchor_color, style.multibody_joint_separation_color);
    assert_eq!(drawn, lines(colors.0, colors.1));
    assert!(world.draw(DebugRenderMode::IMPULSE_JOINTS).lines.is_empty());
}

#[test]
fn joints_without_bodies_are_not_drawn_and_disabled_ones_are_dimmed() {
    let style = DebugRenderStyle::default();
    let mut world = World::default();
    let [body1, body2] = world.pair();
    let joint = GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES).build();
    let handle = world.impulse_joints.insert(body1, body2, joint, true);
    world.impulse_joints.insert(body1, RigidBodyHandle::invalid(), joint, true);
    assert_eq!(world.draw(DebugRenderMode::JOINTS).lines.len(), 3);
    world.impulse_joints[handle].data.set_enabled(false);
    let drawn = world.draw(DebugRenderMode::JOINTS);
    let dimmed = |color| style::times(color, style.disabled_color_multiplier);
    assert!(drawn.has_color(dimmed(style.impulse_joint_anchor_color)));
    assert!(!drawn.has_color(style.impulse_joint_anchor_color));
}

/// An arc goes as far as the limits do, and its pointer shows the angle.
#[test]
fn arcs_and_slides_reach_as_far_as_limits() {
    let length = DebugRenderStyle::default().joint_axes_length;
    let mode = DebugRenderMode::JOINTS | DebugRenderMode::JOINT_AXES;
    // Lines of a joint without the three to and between the anchors.
    let axes_of = |joint: GenericJointBuilder| {
        let mut world = World::default();
        let [body1, body2] = world.pair();
        world.impulse_joints.insert(body1, body2, joint.build(), true);
        world.draw(mode).lines.split_off(3)
    };
    let tolerance = 16.0 * Real::EPSILON;

    let hinge = GenericJointBuilder::new(JointAxesMask::LOCKED_REVOLUTE_AXES);
    let zero = if ANG_DIM == 1 { Vector::X } else { Vector::Y };
    let lines = axes_of(hinge.limits(JointAxis::AngX, [-0.5, 1.0]));
    let (mut smallest, mut largest): (Real, Real) = (0.0, 0.0);
    let (pointer, arc) = lines.split_last().expect("a hinge has an axis");
    for point in arc.iter().flat_map(|line| [line.0, line.1]).filter(|&p| p != Vector::ZERO) {
        assert!((point.length() - length).abs() < tolerance);
        // The direction in which the angle grows is the axis behind the one of angle zero.
        let ahead = if ANG_DIM == 1 { point.y } else { point[DIM - 1] };
        let angle = ahead.atan2(point.dot(zero));
        (smallest, largest) = (smallest.min(angle), largest.max(angle));
    }
    assert!((smallest + 0.5).abs() < tolerance && (largest - 1.0).abs() < tolerance);
    assert_eq!((pointer.0, pointer.1), (Vector::X * 3.0, Vector::X * 3.0 + zero * length));

    let slider = GenericJointBuilder::new(JointAxesMask::LOCKED_PRISMATIC_AXES);
    let lines = axes_of(slider.limits(JointAxis::LinX, [-1.0, 2.0]));
    assert_eq!((lines[0].0, lines[0].1), (-Vector::X, Vector::X * 2.0));
    assert_eq!(lines.len(), 3); // the way and two marks

    // The length of a free axis without limits is that of the style.
    let lines = axes_of(slider);
    assert_eq!((lines[0].0, lines[0].1), (-Vector::X * length, Vector::X * length));
    assert!(axes_of(GenericJointBuilder::new(JointAxesMask::LOCKED_FIXED_AXES)).is_empty());
}

#[test]
fn every_sketch_fills_the_box_of_its_shape() {
    for detail in [Detail::new(0, 0), Detail::new(32, 5)] {
        // With 4 pieces a circle is a square that touches the box at its corners only.
        let tolerance = if detail.subdivisions < 8 { 0.35 } else { 0.05 };
        for shape in samples::shapes() {
            let sketch = sketch::outline(&*shape, detail);
            let aabb = shape.compute_local_aabb();
            let kind = shape.shape_type();
            assert!(!sketch.lines.is_empty(), "{kind:?} is drawn");
            let (mut low, mut high) = (Vector::MAX, Vector::MIN);
            for &id in sketch.lines.as_flattened() {
                low = low.min(sketch.points[id as usize]);
                high = high.max(sketch.points[id as usize]);
            }
            let size = (aabb.maxs - aabb.mins).max_element();
            let near = |a: Vector, b: Vector| (a - b).abs().max_element() < tolerance * size;
            assert!(near(low, aabb.mins), "{kind:?}: {low} in {aabb:?}");
            // The box of voxels is that of the blocks in which they are stored.
            if let Some(voxels) = shape.as_voxels() {
                assert_eq!(high, voxels.voxel_aabb(voxels.voxel_at_point(high * 0.999)).maxs);
            } else {
                assert!(near(high, aabb.maxs), "{kind:?}: {high} in {aabb:?}");
            }
        }
    }
}
