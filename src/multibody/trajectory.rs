//! The trajectory of a multibody through a step: intermediate poses of its links, and the return to them.
//!
//! The trajectory leads from the start of the step by the displacement `Δq` of each degree of freedom at
//! constant rate: `q(s) = q + s Δq`. Rotations of ball joints and of the root are integrated in short pieces.
//! So joints hold everywhere on it.
//!
//! Intermediate velocities follow from those at its end. The inertial change since is reversed, as free
//! motion in the solver (`motion/`), and the momentum is kept. The work of gravity and other forces in that
//! time is removed.

use super::kinematics::Kinematics;
use super::{JointLoad, Motion, usable};
use crate::dim::math::{AngVector, Real, Rotation, Vector};
use crate::dim::spatial::{angular, linear};
use crate::model::body::RigidBodySet;
use crate::model::frozen::Frozen;
use crate::model::multibody::{LinkTrajectory, LinkTravel, Multibody};

/// The largest number of pieces of a trajectory.
const PIECES_MAX: usize = 1024;
/// The largest rotation angle (rad) of a link within a piece.
const ANGLE_PER_PIECE_MAX: Real = 0.5;

/// A sample of a link's trajectory: its rotation, its centre of mass, and its angular velocity (rad per
/// trajectory).
#[derive(Copy, Clone, Debug)]
pub struct LinkSample {
    pub rotation: Rotation,
    pub center: Vector,
    pub angular: AngVector,
}

impl LinkTrajectory {
    /// The number of pieces in which a link moves along a line up to a deviation, and rotates about one axis.
    ///
    /// A path of length `w` that bends by the angle `a` is within `w a / 8` of its chord. A piece of `n` is
    /// within `1/n²` of that.
    pub fn pieces(&self, deviation: Real) -> usize {
        let LinkTravel { path_length, angle } = self.travel;
        let bent = (path_length * angle / (8.0 * deviation.max(Real::MIN_POSITIVE))).sqrt();
        // NaN, or a number that is too large, becomes the largest number of pieces.
        let pieces = bent.max(angle / ANGLE_PER_PIECE_MAX).ceil().min(PIECES_MAX as Real);
        (pieces as usize).max(1)
    }

    /// Calls `visit` with the links at the start of the trajectory, and after each of its pieces.
    pub fn walk(
        &self,
        multibody: &Multibody,
        pieces: usize,
        mut visit: impl FnMut(usize, &[LinkSample]),
    ) {
        let mut ghost = multibody.clone();
        self.put_back(&mut ghost);
        let piece = 1.0 / pieces as Real;
        let (mut kinematics, mut velocities) = (Kinematics::default(), Vec::new());
        let mut samples = Vec::new();
        for at in 0..=pieces {
            if at > 0 {
                ghost.integrate(piece, &self.shift, &self.root);
            }
            kinematics.update(&ghost);
            kinematics.velocities(&self.shift, &self.root, &mut velocities);
            samples.clear();
            samples.extend(kinematics.links.iter().zip(&velocities).map(|(link, velocity)| {
                LinkSample {
                    rotation: link.rotation,
                    center: link.center,
                    angular: angular(velocity),
                }
            }));
            visit(at, &samples);
        }
    }

    /// Moves a multibody and its bodies back from the end to a fraction of the trajectory. `acceleration`
    /// returns the acceleration of each link by forces.
    ///
    /// A root that is not dynamic stays where it is.
    pub fn go_back(
        &self,
        multibody: &mut Multibody,
        bodies: &mut Frozen<'_, RigidBodySet>,
        fraction: Real,
        pieces: usize,
        dt: Real,
        acceleration: impl Fn(usize) -> Vector,
    ) {
        debug_assert!((0.0..=1.0).contains(&fraction) && pieces > 0);
        let centers = |bodies: &RigidBodySet, multibody: &Multibody| -> Vec<Vector> {
            let center = |body| bodies.get(body).map_or(Vector::ZERO, |body| body.center_of_mass());
            multibody.links.iter().map(|link| center(link.body)).collect()
        };
        let (energy, ends) = (kinetic_energy(multibody, bodies), centers(bodies, multibody));
        let (mut motion, has_diverged) = self.rewind(multibody, bodies, fraction, pieces, dt);
        store(multibody, &mut motion, bodies);
        let now = centers(bodies, multibody);
        let mut work = 0.0;
        for (id, link) in multibody.links.iter().enumerate() {
            let mass = bodies.get(link.body).map_or(0.0, |body| body.mass());
            work += acceleration(id).dot(ends[id] - now[id]) * mass;
        }
        // The energy equals that at the end, without the work of forces until then.
        let scale = ((energy - work).max(0.0) / kinetic_energy(multibody, bodies)).sqrt();
        if scale.is_finite() && !(has_diverged && scale > 1.0) {
            motion.rates.iter_mut().for_each(|rate| *rate *= scale);
        }
        store(multibody, &mut motion, bodies);
    }

    /// Moves back to a fraction of the trajectory, with the velocities of that time as far as inertia has
    /// changed them. If inertia cannot be reversed, the links keep their momenta, as far as the joints allow.
    fn rewind(
        &self,
        multibody: &mut Multibody,
        bodies: &RigidBodySet,
        fraction: Real,
        pieces: usize,
        dt: Real,
    ) -> (Motion, bool) {
        let mut motion = Motion::default();
        motion.joint_loads = inertias(multibody);
        motion.begin(multibody, bodies);
        let (last, momenta) = (motion.rates.to_vec(), motion.link_momenta());
        let mut has_diverged = false;
        let count = ((1.0 - fraction) * pieces as Real).ceil().max(1.0);
        let piece = (1.0 - fraction) / count;
        for _ in 0..count as usize {
            has_diverged |= !motion.implicit_inertial_kick(-0.5 * piece * dt);
            motion.displace(multibody, &self.shift, -piece);
            motion.resist(0.0);
            motion.undo_inertial_kick(0.5 * piece * dt);
        }
        self.put_at(multibody, fraction, pieces);
        motion.displace(multibody, &self.shift, 0.0);
        motion.resist(0.0);
        if has_diverged {
            motion.rates.copy_from_slice(&last);
            motion.take_momenta(|id, _| Some(momenta[id]));
        }
        motion.finish(false);
        if !motion.rates.iter().all(|rate| rate.is_finite()) {
            motion.rates.copy_from_slice(&last);
        }
        (motion, has_diverged)
    }

    /// Moves the links back to a fraction of the trajectory, as in [`Self::walk`].
    fn put_at(&self, multibody: &mut Multibody, fraction: Real, pieces: usize) {
        let root = multibody.links[0].pose;
        self.put_back(multibody);
        let piece = 1.0 / pieces as Real;
        let whole_pieces = ((fraction / piece).floor() as usize).min(pieces);
        for _ in 0..whole_pieces {
            multibody.integrate(piece, &self.shift, &self.root);
        }
        let rest = (fraction - whole_pieces as Real * piece).max(0.0);
        multibody.integrate(rest, &self.shift, &self.root);
        if multibody.links[0].free.is_empty() {
            multibody.links[0].pose = root;
        }
    }

    /// Resets the coordinates to the start of the trajectory.
    fn put_back(&self, multibody: &mut Multibody) {
        let (joints, root) = &self.start;
        for (link, joint) in multibody.links.iter_mut().zip(joints) {
            link.joint = joint.clone();
        }
        multibody.links[0].pose = *root;
    }
}

/// Additional inertia of degrees of freedom beyond that of links.
fn inertias(multibody: &Multibody) -> Vec<JointLoad> {
    let armatures = multibody.dofs.iter().zip(&multibody.lists.armature);
    let load = |is_prescribed, armature| JointLoad {
        armature: if is_prescribed { Real::INFINITY } else { usable(armature) },
        ..JointLoad::default()
    };
    armatures
        .map(|(dof, &armature)| load(multibody.links[dof.link].joint.kinematic, armature))
        .collect()
}

/// The energy of motion of all links.
fn kinetic_energy(multibody: &Multibody, bodies: &RigidBodySet) -> Real {
    let links = multibody.links.iter().filter_map(|link| bodies.get(link.body));
    links.filter(|body| body.is_dynamic()).map(|body| body.kinetic_energy()).sum()
}

/// Gives the bodies the poses and velocities of their links.
fn store(multibody: &mut Multibody, motion: &mut Motion, bodies: &mut Frozen<'_, RigidBodySet>) {
    multibody.lists.store_velocities(&motion.rates);
    let velocities = motion.link_velocities().to_vec();
    for (id, velocity) in velocities.iter().enumerate() {
        let pose = match id {
            0 => multibody.links[0].pose,
            _ => motion.kinematics.pose(id, multibody),
        };
        let link = &mut multibody.links[id];
        let Some(body) = bodies.get_unnoted_mut(link.body) else { continue };
        if body.is_dynamic() {
            (body.vels.linvel, body.vels.angvel) = (linear(velocity), angular(velocity));
            body.pose = pose;
            body.update_world_mass_properties();
            link.pose = pose;
        }
        link.match_body(body);
        link.seen_velocity = Some(body.vels);
    }
}
