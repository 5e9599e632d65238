//! Kinematic bodies that move, and the bodies that they approach.
//!
//! Motion is relative. A wall that moves a metre in a step passes a ball at rest just as a ball at that speed
//! passes a wall. So a body is searched as a fast one if it moves against a kinematic body near it as far as
//! a fast body does:
//!
//! ```text
//! |Δx_b - (Δx_k + θ_k × d)| + |θ_b| R_b + |θ_k| R_b + |θ_k|² |d| / 2  >  bound of a fast body,  d = c_b - c_k
//! ```
//!
//! `c` are centres of mass, `θ` rotation vectors in the step, `R_b` the extent of the body about its centre.
//! A door moves far at its edge and hardly at its hinge. A heap that a blade pushes along moves little
//! relative to the blade. The last term bounds the error of the linearised rotation `θ × d`, at the end of
//! the step and during it.
//!
//! Candidates are found before bodies move, from the velocities of awake kinematic bodies. Sleeping ones
//! among them wake. A body whose box is outside the swept region of a kinematic collider needs no search. A
//! body that is not fast keeps its core inside its box. Worlds without moving kinematic bodies pay for one
//! test of an empty list. Many colliders of one body may overlap many of another. The list of pairs is
//! therefore deduplicated each time it has doubled, so its length is at most about twice the number of body
//! pairs.

use super::CcdContext;
use super::path::sweep_of_slow;
use crate::base::bvh::{BoxProbe, BoxTree};
use crate::collide::Sweep;
use crate::dim::math::{AngVector, Pose, Real, Vector, ang_length_squared, cross};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodyType, RigidBodyVelocity};
use crate::model::collider::{Collider, may_interact};
use crate::model::island::{BodyMotion, NONE};
use crate::model::params::IntegrationParameters;
use crate::model::structure::Structure;
use crate::model::tree::{BroadPhaseBvh, TreeKind};
use crate::step::notes::{Approach, FastMotion, MotionPart};
use parry::bounding_volume::{Aabb, BoundingVolume};

/// Candidates that are listed before duplicates are removed for the first time.
const CANDIDATES_MIN: usize = 256;

/// Motion of a kinematic body in a step.
#[derive(Copy, Clone)]
pub(super) struct KinematicMotion {
    pub center: Vector,
    pub shift: Vector,
    pub rotvec: AngVector,
}

impl KinematicMotion {
    /// The motion that the velocity of a body leads to.
    pub fn ahead(body: &RigidBody, params: &IntegrationParameters) -> Self {
        let velocity = match body.body_type {
            RigidBodyType::KinematicPositionBased => {
                body.velocity_to_next_position(params.inv_dt())
            }
            _ => body.vels,
        };
        let RigidBodyVelocity { linvel, angvel } = velocity;
        Self {
            center: body.mprops.world_com,
            shift: linvel * params.dt,
            rotvec: angvel * params.dt,
        }
    }

    fn is_rest(&self) -> bool {
        self.shift == Vector::ZERO && ang_length_squared(self.rotvec) == 0.0
    }

    /// The motion that a body has made.
    fn made(body: &RigidBody, shift: Vector, dt: Real) -> Self {
        Self { center: body.mprops.world_com - shift, shift, rotvec: body.vels.angvel * dt }
    }

    /// Motion of the points within `extent` of a place.
    fn carry(&self, place: Vector, extent: Real) -> BodyMotion {
        let arm = place - self.center;
        let carried = BodyMotion::of(self.shift + cross(self.rotvec, arm), self.rotvec, extent);
        let linearization_error = 0.5 * ang_length_squared(self.rotvec) * arm.length();
        BodyMotion { rest: carried.rest + linearization_error, ..carried }
    }

    /// A bound of the distance of points that arrive within `radius` of a place.
    fn reach(&self, place: Vector, radius: Real) -> Real {
        let length = self.shift.length();
        let angle = ang_length_squared(self.rotvec).sqrt();
        length + angle * (place.distance(self.center) + radius + length)
    }
}

/// Lists the dynamic bodies that kinematic ones approach, and wakes sleeping ones among them.
pub(crate) fn find_approaches(
    structure: &mut Structure<'_>,
    trees: &BroadPhaseBvh,
    params: &IntegrationParameters,
    approaches: &mut Vec<Approach>,
) {
    approaches.clear();
    if params.max_ccd_substeps == 0 || params.dt <= 0.0 {
        return;
    }
    for &handle in structure.islands.awake.kinematic() {
        if let Some(body) = structure.bodies.get(handle) {
            list(structure, trees, params, (handle, body), approaches);
        }
    }
    // Each kinematic body has listed each of them once: there are no copies.
    approaches.sort_unstable_by_key(order);
    for near in approaches.iter() {
        let body = structure.bodies.get(near.body).filter(|body| body.link.awake == NONE);
        let Some(body) = body else { continue };
        let Some(kinematic) = structure.bodies.get(near.kinematic) else { continue };
        let carried =
            KinematicMotion::ahead(kinematic, params).carry(body.mprops.world_com, body.extent);
        if FastMotion::is_fast(body, carried.bound(), params) {
            structure.wake_body(near.body);
        }
    }
}

fn order(near: &Approach) -> [(u32, u32); 2] {
    [near.body, near.kinematic].map(|body| body.into_raw_parts())
}

/// Lists the bodies that one kinematic body approaches, each of them once.
fn list(
    structure: &Structure<'_>,
    trees: &BroadPhaseBvh,
    params: &IntegrationParameters,
    (kinematic, body): (RigidBodyHandle, &RigidBody),
    approaches: &mut Vec<Approach>,
) {
    let kinematic_motion = KinematicMotion::ahead(body, params);
    if kinematic_motion.is_rest() {
        return;
    }
    let begin = approaches.len();
    let mut limit = begin + CANDIDATES_MIN;
    for collider in body.colliders.iter().filter_map(|&handle| structure.colliders.get(handle)) {
        if collider.is_sensor() || !collider.is_enabled() {
            continue;
        }
        let swath = Swath::new(collider, kinematic_motion, params);
        trees.for_each_overlapping(TreeKind::Dynamic, &swath.region, |slot| {
            let Some((_, other)) = structure.colliders.at_slot(slot) else { return };
            let meets = !other.is_sensor()
                && may_interact(collider, other)
                && swath.overlaps(&other.proxy.fat_aabb);
            let body = other.parent().filter(|_| meets);
            // Most repetitions follow each other: colliders of one body are neighbours.
            let near = body.map(|body| Approach { body, kinematic });
            if near.is_some() && near.as_ref() != approaches.last() {
                approaches.extend(near);
            }
            if approaches.len() >= limit {
                remove_copies(approaches, begin);
                limit = begin + (2 * (approaches.len() - begin)).max(CANDIDATES_MIN);
            }
        });
    }
    remove_copies(approaches, begin);
}

/// The region that a collider sweeps.
struct Swath {
    /// A box around it.
    region: Aabb,
    /// The collider's own box, in its frame.
    own: Aabb,
    to_own: Pose,
    kinematic_motion: KinematicMotion,
    /// Contact distance of bodies.
    margin: Real,
}

impl Swath {
    fn new(
        collider: &Collider,
        kinematic_motion: KinematicMotion,
        params: &IntegrationParameters,
    ) -> Self {
        let sweep = Sweep::new(
            collider.pose,
            kinematic_motion.center,
            kinematic_motion.shift,
            kinematic_motion.rotvec,
        );
        Self {
            region: region_of(collider, &sweep, params),
            own: collider.shape().compute_local_aabb(),
            to_own: collider.pose.inverse(),
            kinematic_motion,
            margin: params.prediction_distance() + collider.contact_skin,
        }
    }

    /// Returns whether the collider may get to a box. The box of a slanted blade contains many bodies far
    /// from the blade. A second test in the frame of the blade excludes them.
    fn overlaps(&self, aabb: &Aabb) -> bool {
        let (center, radius) = (aabb.center(), aabb.half_extents().length());
        let margin = self.margin + radius + self.kinematic_motion.reach(center, radius);
        let apart = (self.to_own * center - self.own.center()).abs() - self.own.half_extents();
        // Boxes without end have no centre.
        apart.is_nan() || apart.max_element() <= margin
    }
}

/// Sorts the list from `begin` on, and keeps one of each.
fn remove_copies(approaches: &mut Vec<Approach>, begin: usize) {
    let added = &mut approaches[begin..];
    added.sort_unstable_by_key(order);
    let mut kept = 0;
    for at in 0..added.len() {
        if kept == 0 || added[kept - 1] != added[at] {
            added[kept] = added[at];
            kept += 1;
        }
    }
    approaches.truncate(begin + kept);
}

/// Box around the swept region of a collider and around its contacts.
fn region_of(collider: &Collider, sweep: &Sweep<'_>, params: &IntegrationParameters) -> Aabb {
    sweep.region(collider.shape()).loosened(params.prediction_distance() + collider.contact_skin)
}

/// Adds approached bodies to the fast bodies if their motion relative to a kinematic body is fast.
pub(crate) fn add_approached(
    context: CcdContext<'_>,
    approaches: &[Approach],
    fast: &mut Vec<FastMotion>,
) {
    debug_assert!(approaches.is_sorted_by_key(order), "the approaches of a body stand together");
    let mut last = None;
    for near in approaches {
        let body = context.bodies.get(near.body).filter(|body| body.is_dynamic());
        let Some(body) = body.filter(|body| !body.ccd_active && last != Some(near.body)) else {
            continue;
        };
        let Some(kinematic) = context.bodies.get(near.kinematic) else { continue };
        let motion = |handle: RigidBodyHandle| context.islands.motion_of(handle.into_raw_parts().0);
        let kinematic_motion =
            KinematicMotion::made(kinematic, motion(near.kinematic).shift, context.params.dt);
        let own = motion(near.body);
        let relative =
            own.against(&kinematic_motion.carry(body.mprops.world_com - own.shift, body.extent));
        let is_link = || context.multibodies.rigid_body_link(near.body).is_some();
        if FastMotion::is_fast(body, relative, context.params) && !is_link() {
            fast.extend(motion_of(context, near.body, body));
            last = Some(near.body);
        }
    }
}

/// Motion of a body that is not fast, from the old poses of its colliders.
fn motion_of(
    context: CcdContext<'_>,
    handle: RigidBodyHandle,
    body: &RigidBody,
) -> Option<FastMotion> {
    let colliders = body.colliders.iter().filter_map(|&handle| context.colliders.get(handle));
    let (parent, pose) =
        colliders.filter_map(|collider| Some((collider.parent.as_ref()?, collider.pose))).next()?;
    let start = pose * parent.pos_wrt_parent.inverse();
    let center = start * body.local_center_of_mass();
    Some(FastMotion {
        body: handle,
        start,
        center,
        shift: body.mprops.world_com - center,
        rotvec: body.vels.angvel * context.params.dt,
        acceleration: Vector::ZERO,
        link: None,
        part: MotionPart::Whole,
    })
}

/// Moved kinematic colliders with the boxes of their swept regions.
#[derive(Default)]
pub(super) struct Movers {
    boxes: BoxTree,
    /// Their slots, by the numbers of their boxes.
    slots: Vec<u32>,
}

impl Movers {
    /// Lists them.
    pub fn find(&mut self, context: CcdContext<'_>) {
        self.boxes.clear();
        self.slots.clear();
        for &handle in context.islands.awake.kinematic() {
            if context.islands.motion_of(handle.into_raw_parts().0).bound() == 0.0 {
                continue;
            }
            let Some(body) = context.bodies.get(handle) else { continue };
            for &handle in &body.colliders {
                let collider =
                    context.colliders.get(handle).filter(|collider| collider.is_enabled());
                let Some(collider) = collider else { continue };
                let sweep = sweep_of_slow(context, body, collider);
                let region = region_of(collider, &sweep, context.params);
                self.boxes.insert(&region, self.slots.len() as u32);
                self.slots.push(handle.into_raw_parts().0);
            }
        }
    }

    /// Returns whether no kinematic collider has moved.
    pub fn is_empty(&self) -> bool {
        self.slots.is_empty()
    }

    /// Calls `visit` with the slots of the colliders whose paths intersect a region.
    pub fn for_each_in(&self, region: &Aabb, mut visit: impl FnMut(u32)) {
        if !self.slots.is_empty() {
            self.boxes.for_each_leaf(&BoxProbe(*region), |at| visit(self.slots[at as usize]));
        }
    }
}
