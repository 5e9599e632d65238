//! One file for each scene, and the list of all scenes.

pub mod primitives;
pub mod all_shapes;
pub mod compound;
pub mod convex_polygons;
pub mod restitution;
pub mod friction;
pub mod damping;
pub mod gravity_scale;
pub mod forces;
pub mod locked_axes;
pub mod dominance;
pub mod platforms;
pub mod sensors;
pub mod collision_groups;
pub mod solver_groups;
pub mod contact_forces;
pub mod one_way_platforms;
pub mod characters;
pub mod conveyor_belts;
pub mod collider_edits;
pub mod body_types;
pub mod sleeping;
pub mod trimesh;
pub mod heightfield;
pub mod polyline;
pub mod internal_edges;
pub mod radar;
pub mod strider;
pub mod joints;
pub mod motors;
pub mod bridge;
pub mod newton_cradle;
pub mod jointed_car;
pub mod ragdoll_stairs;
pub mod robot_arm;
pub mod voxels;
pub mod heavy_on_light;
pub mod card_house;
pub mod arch;
pub mod dominoes;
pub mod rain;
pub mod pyramid20;
pub mod tower30;
pub mod large_pyramid;
pub mod many_pyramids;
pub mod tumbler;
pub mod spinner;
pub mod compounds;
pub mod smash;
pub mod downpour;
pub mod junkyard;
pub mod ragdolls;
pub mod washer;
pub mod joint_grid;
pub mod wrecking_ball;
pub mod pendulum_wave;
pub mod seesaw;
pub mod trampoline;
pub mod heavy_chain;
pub mod deep_overlap;

use crate::common::SceneInfo;

/// All scenes, in the gallery's order.
pub const SCENES: [SceneInfo; 60] = [
    primitives::INFO,
    all_shapes::INFO,
    compound::INFO,
    convex_polygons::INFO,
    restitution::INFO,
    friction::INFO,
    damping::INFO,
    gravity_scale::INFO,
    forces::INFO,
    locked_axes::INFO,
    dominance::INFO,
    platforms::INFO,
    sensors::INFO,
    collision_groups::INFO,
    solver_groups::INFO,
    contact_forces::INFO,
    one_way_platforms::INFO,
    characters::INFO,
    conveyor_belts::INFO,
    collider_edits::INFO,
    body_types::INFO,
    sleeping::INFO,
    trimesh::INFO,
    heightfield::INFO,
    polyline::INFO,
    internal_edges::INFO,
    radar::INFO,
    strider::INFO,
    joints::INFO,
    motors::INFO,
    bridge::INFO,
    newton_cradle::INFO,
    jointed_car::INFO,
    ragdoll_stairs::INFO,
    robot_arm::INFO,
    voxels::INFO,
    heavy_on_light::INFO,
    card_house::INFO,
    arch::INFO,
    dominoes::INFO,
    rain::INFO,
    pyramid20::INFO,
    tower30::INFO,
    large_pyramid::INFO,
    many_pyramids::INFO,
    tumbler::INFO,
    spinner::INFO,
    compounds::INFO,
    smash::INFO,
    downpour::INFO,
    junkyard::INFO,
    ragdolls::INFO,
    washer::INFO,
    joint_grid::INFO,
    wrecking_ball::INFO,
    pendulum_wave::INFO,
    seesaw::INFO,
    trampoline::INFO,
    heavy_chain::INFO,
    deep_overlap::INFO,
];
