//! One file for each scene, and the list of all scenes.

pub mod primitives;
pub mod all_shapes;
pub mod compound;
pub mod convex_hulls;
pub mod restitution;
pub mod friction;
pub mod damping;
pub mod gravity_scale;
pub mod forces;
pub mod locked_axes;
pub mod dominance;
pub mod gyroscope;
pub mod platforms;
pub mod sensors;
pub mod bullets;
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
pub mod vehicle;
pub mod joints;
pub mod motors;
pub mod bridge;
pub mod newton_cradle;
pub mod jointed_car;
pub mod ragdoll_stairs;
pub mod robot_arm;
pub mod strider;
pub mod voxels;
pub mod heavy_on_light;
pub mod card_house;
pub mod dominoes;
pub mod rain;
pub mod pyramid20;
pub mod tower30;
pub mod large_pyramid;
pub mod many_pyramids;
pub mod convex_pile;
pub mod junkyard;
pub mod washer;
pub mod large_world;
pub mod internal_edges;
pub mod radar;
pub mod fine_mesh;
pub mod tiles;
pub mod cobbles;
pub mod glide;
pub mod joint_grid;
pub mod ragdolls;
pub mod ragdoll_rain;
pub mod trees;
pub mod wrecking_ball;
pub mod pendulum_wave;
pub mod seesaw;
pub mod trampoline;
pub mod heavy_chain;
pub mod deep_overlap;
pub mod marble_run;
pub mod laser_scanner;
pub mod spinning_rods;

use crate::common::SceneInfo;

/// All scenes, in the gallery's order.
pub const SCENES: [SceneInfo; 70] = [
    primitives::INFO,
    all_shapes::INFO,
    compound::INFO,
    convex_hulls::INFO,
    restitution::INFO,
    friction::INFO,
    damping::INFO,
    gravity_scale::INFO,
    forces::INFO,
    locked_axes::INFO,
    dominance::INFO,
    gyroscope::INFO,
    platforms::INFO,
    sensors::INFO,
    bullets::INFO,
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
    vehicle::INFO,
    joints::INFO,
    motors::INFO,
    bridge::INFO,
    newton_cradle::INFO,
    jointed_car::INFO,
    ragdoll_stairs::INFO,
    robot_arm::INFO,
    strider::INFO,
    voxels::INFO,
    heavy_on_light::INFO,
    card_house::INFO,
    dominoes::INFO,
    rain::INFO,
    pyramid20::INFO,
    tower30::INFO,
    large_pyramid::INFO,
    many_pyramids::INFO,
    convex_pile::INFO,
    junkyard::INFO,
    washer::INFO,
    large_world::INFO,
    internal_edges::INFO,
    radar::INFO,
    fine_mesh::INFO,
    tiles::INFO,
    cobbles::INFO,
    glide::ON_MESH,
    glide::ON_BOX,
    joint_grid::INFO,
    ragdolls::INFO,
    ragdoll_rain::INFO,
    trees::TREES100,
    trees::TREES50,
    trees::TREES25,
    wrecking_ball::INFO,
    pendulum_wave::INFO,
    seesaw::INFO,
    trampoline::INFO,
    heavy_chain::INFO,
    deep_overlap::INFO,
    marble_run::INFO,
    laser_scanner::INFO,
    spinning_rods::INFO,
];
