//! One file for each scene, and the list of all scenes.

pub mod all_shapes;
pub mod arch;
pub mod body_types;
pub mod bridge;
pub mod card_house;
pub mod characters;
pub mod collider_edits;
pub mod collision_groups;
pub mod compound;
pub mod compounds;
pub mod contact_forces;
pub mod convex_polygons;
pub mod conveyor_belts;
pub mod damping;
pub mod deep_overlap;
pub mod dominance;
pub mod dominoes;
pub mod downpour;
pub mod forces;
pub mod friction;
pub mod gravity_scale;
pub mod heavy_chain;
pub mod heavy_on_light;
pub mod heightfield;
pub mod internal_edges;
pub mod joint_grid;
pub mod jointed_car;
pub mod joints;
pub mod junkyard;
pub mod large_pyramid;
pub mod locked_axes;
pub mod many_pyramids;
pub mod motors;
pub mod newton_cradle;
pub mod one_way_platforms;
pub mod pendulum_wave;
pub mod platforms;
pub mod polyline;
pub mod primitives;
pub mod pyramid20;
pub mod radar;
pub mod ragdoll_stairs;
pub mod ragdolls;
pub mod rain;
pub mod restitution;
pub mod robot_arm;
pub mod seesaw;
pub mod sensors;
pub mod sleeping;
pub mod smash;
pub mod solver_groups;
pub mod spinner;
pub mod strider;
pub mod tower30;
pub mod trampoline;
pub mod trimesh;
pub mod tumbler;
pub mod voxels;
pub mod washer;
pub mod wrecking_ball;

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
