//! The tree of links, as joints come and go.

use super::{Multibody, MultibodyJoint, MultibodyJointHandle, MultibodyJointSet};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{Pose, Real, Rotation, Vector};
use crate::dim::spatial::rotation_about;
use crate::model::body::RigidBodyHandle;
use crate::model::island::BodyGroups;
use crate::model::joint::GenericJoint;

/// Handles as a set would give them out.
fn body(slot: u32) -> RigidBodyHandle {
    RigidBodyHandle::from_raw_parts(slot, 0)
}

fn hinge() -> GenericJoint {
    GenericJoint::new(JointAxesMask::LOCKED_REVOLUTE_AXES)
}

/// Joins body `k` to `parents[k]`.
fn tree(parents: &[Option<u32>]) -> (MultibodyJointSet, Vec<Option<MultibodyJointHandle>>) {
    let mut set = MultibodyJointSet::new();
    let handles = (0..).zip(parents).map(|(k, parent)| {
        parent.map(|parent| set.insert(body(parent), body(k), hinge(), true).expect("it fits"))
    });
    let handles = handles.collect();
    (set, handles)
}

fn validate(set: &MultibodyJointSet) {
    set.check_trees().expect("every tree is whole");
}

#[test]
fn trees_merge_and_split() {
    // 0 - 1 - 2, 1 - 3, and 4 - 5 - 6
    let parents = [None, Some(0), Some(1), Some(1), None, Some(4), Some(5)];
    let (mut set, handles) = tree(&parents);
    validate(&set);
    assert_eq!((set.len(), set.multibodies().count()), (5, 2));
    let bridge = set.insert(body(3), body(4), hinge(), true).expect("4 is a root");
    validate(&set);
    assert_eq!((set.len(), set.multibodies().count()), (6, 1));
    assert!(set.insert(body(6), body(0), hinge(), true).is_none(), "that would be a loop");
    set.remove(bridge, true);
    validate(&set);
    assert_eq!((set.len(), set.multibodies().count()), (5, 2));
    set.remove_joints_attached_to_rigid_body(body(1));
    validate(&set);
    assert_eq!((set.len(), set.multibodies().count()), (2, 1), "0, 2 and 3 are alone");
    assert!(set.rigid_body_link(body(2)).is_none());
    set.remove_multibody_articulations(handles[5].expect("a joint"), true);
    assert!(set.is_empty() && set.multibodies().count() == 0);
}

/// The pairs of links that collide, by body.
fn touching(set: &MultibodyJointSet, bodies: &[u32]) -> Vec<[u32; 2]> {
    let mut groups = BodyGroups::default();
    set.multibodies().for_each(|multibody| groups.insert(&multibody.members()));
    let index = |slot| set.rigid_body_link(body(slot)).expect("it is a link").multibody;
    let pairs = bodies.iter().flat_map(|&one| bodies.iter().map(move |&two| [one, two]));
    let touch =
        |&[one, two]: &[u32; 2]| one < two && index(one) == index(two) && !groups.part(one, two);
    pairs.filter(touch).collect()
}

/// Sets whether the links of the multibody of a body touch each other.
fn set_self_contacts(set: &mut MultibodyJointSet, slot: u32, enabled: bool) {
    let index = set.rigid_body_link(body(slot)).expect("it is a link").multibody;
    set.get_multibody_mut(index).expect("it is there").set_self_contacts_enabled(enabled);
}

/// Each merged multibody keeps its links apart if it did before; links of different ones touch if the
/// parent's do.
#[test]
fn self_contacts_survive_merging() {
    // 0 - 1, and 2 - 3, and 4 - 5 are merged, and the second and third have no self-contacts.
    let (mut set, _) = tree(&[None, Some(0), None, Some(2), None, Some(4)]);
    set_self_contacts(&mut set, 2, false);
    set_self_contacts(&mut set, 4, false);
    let tail = set.insert(body(3), body(4), hinge(), true).expect("it fits");
    assert!(touching(&set, &[2, 3, 4, 5]).is_empty(), "neither multibody has self-contacts");
    set.remove(tail, true);
    let first = set.insert(body(1), body(2), hinge(), true).expect("it fits");
    let second = set.insert(body(1), body(4), hinge(), true).expect("it fits");
    let all: [u32; 6] = core::array::from_fn(|k| k as u32);
    let expected: Vec<_> = all
        .iter()
        .flat_map(|&one| all.iter().map(move |&two| [one, two]))
        .filter(|pair| pair[0] < pair[1] && ![[2, 3], [4, 5]].contains(pair))
        .collect();
    assert_eq!(touching(&set, &all), expected);
    // Parts have the setting that they came with.
    set.remove(first, true);
    assert!(touching(&set, &[2, 3]).is_empty());
    set.remove(second, true);
    assert!(touching(&set, &[4, 5]).is_empty());
    assert_eq!(touching(&set, &[0, 1]), [[0, 1]]);
}

/// A body that is no link takes the setting of the multibody that it joins, as parent or as child. Settings
/// made after a merge apply to all.
#[test]
fn single_bodies_take_the_setting_of_their_multibody() {
    let (mut set, _) = tree(&[None, Some(0)]);
    set_self_contacts(&mut set, 0, false);
    set.insert(body(1), body(2), hinge(), true).expect("it fits");
    set.insert(body(3), body(0), hinge(), true).expect("it fits");
    assert!(touching(&set, &[0, 1, 2, 3]).is_empty());
    let (mut set, _) = tree(&[None, Some(0), None, Some(2)]);
    set_self_contacts(&mut set, 2, false);
    set.insert(body(1), body(2), hinge(), true).expect("it fits");
    set_self_contacts(&mut set, 0, true);
    assert_eq!(touching(&set, &[0, 1, 2, 3]).len(), 6, "a later setting decides for all");
}

/// Degrees of freedom keep their numbers.
#[test]
fn numbers_follow_their_degrees_of_freedom() {
    let (mut set, handles) = tree(&[None, Some(0), Some(1), Some(2), Some(3)]);
    let handle = handles[4].expect("a joint");
    let (multibody, _) = set.get_mut(handle).expect("it is there");
    for (k, velocity) in multibody.generalized_velocity_mut().iter_mut().enumerate() {
        *velocity = k as Real + 1.0;
    }
    set.remove(handles[2].expect("a joint"), true);
    validate(&set);
    let velocities = |set: &MultibodyJointSet, handle: Option<MultibodyJointHandle>| {
        let (multibody, _) = handle.and_then(|handle| set.get(handle)).expect("it is there");
        multibody.generalized_velocity().to_vec()
    };
    assert_eq!(velocities(&set, handles[1]), [1.0]);
    assert_eq!(velocities(&set, handles[4]), [3.0, 4.0]);
    set.insert(body(1), body(2), hinge(), true).expect("it fits");
    validate(&set);
    assert_eq!(velocities(&set, handles[4]), [1.0, 0.0, 3.0, 4.0]);
}

/// Joints find the coordinates of a pose that they can reach.
#[test]
fn coordinates_are_read_back() {
    let frame1 = Pose::from_parts(Vector::X * 0.3, rotation_about(0, 0.4));
    let frame2 = Pose::from_parts(Vector::Y * -0.2, rotation_about(0, -1.1));
    for bits in 0..=JointAxesMask::all().bits() {
        let locked = JointAxesMask::from_bits_truncate(bits);
        let data = GenericJoint {
            local_frame1: frame1,
            local_frame2: frame2,
            ..GenericJoint::new(locked)
        };
        let mut joint = MultibodyJoint::new(data, false);
        let displacements: Vec<Real> = (0..joint.ndofs()).map(|k| 0.3 - 0.15 * k as Real).collect();
        joint.apply_displacement(&displacements);
        let pose = joint.body_to_parent();
        let mut read = MultibodyJoint::new(data, false);
        read.read_pose(&pose);
        let (from, to) = (joint.coords(), read.coords());
        let apart = from.iter().zip(to).map(|(a, b)| (a - b).abs());
        let error = apart.fold(0.0, Real::max);
        assert!(error < 1.0e-5, "{locked:?}: {error}");
        assert!(
            (joint.joint_rot() * read.joint_rot().inverse() * Vector::X - Vector::X).length()
                < 1.0e-5
        );
    }
}

/// Angles are counted on beyond half a turn.
#[test]
fn turns_are_counted() {
    let mut joint = MultibodyJoint::new(hinge(), false);
    joint.apply_displacement(&[10.0]);
    joint.match_bodies();
    let pose = joint.body_to_parent();
    joint.read_pose(&pose);
    assert!((joint.coords()[JointAxis::AngX as usize] - 10.0).abs() < 1.0e-5);
    joint.read_pose(&Pose::from_parts(Vector::ZERO, Rotation::IDENTITY));
    let turn = 4.0 * core::f64::consts::PI as Real;
    assert!((joint.coords()[JointAxis::AngX as usize] - turn).abs() < 1.0e-5);
}

#[test]
fn an_empty_multibody_is_harmless() {
    let mut multibody = Multibody::new();
    assert!(multibody.root().is_none() && multibody.root_mut().is_none());
    multibody.apply_displacements(&[1.0]);
    assert_eq!(multibody.mass_matrix().size(), 0);
    assert!(multibody.bias_forces().is_empty() && multibody.accelerations_of(&[]).is_empty());
}
