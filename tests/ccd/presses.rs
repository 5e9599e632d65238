//! Bodies in contact with a barrier, hit from behind.
//!
//! Contacts are compliant. A body between a wall and a bullet of a hundred times its mass moves by its own
//! thickness within a substep. Contacts then push it out of the wall on the other side. Deeply penetrating
//! bodies therefore move no deeper, however small the motion.

use super::{PHASES, RADIUS, SPEEDS};
use crate::dim::grounds::{GROUNDS, Ground};
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Bodies farther than this from the impact may have moved around the ground.
const DISTANCE: Real = 3.0;

/// Ground with its surface at y = 0, and the bodies on it.
struct Press<'a> {
    lay: fn(&mut PhysicsWorld, Pose, Real),
    shape: &'a dyn Fn() -> ColliderBuilder,
    /// Number of bodies in the pile.
    pile: usize,
    /// Mass of the hitting body, as a multiple of theirs.
    heavier: Real,
    rate: u32,
}

impl Press<'_> {
    /// Returns the number of passes in 20 runs.
    fn count_passed(&self, speed: Real) -> usize {
        (0..PHASES).filter(|&phase| self.passes(speed, phase as Real / PHASES as Real)).count()
    }

    fn passes(&self, speed: Real, phase: Real) -> bool {
        let mut world = weightless(self.rate);
        (self.lay)(&mut world, Pose::IDENTITY, 0.5);
        let x = 7.31 + 0.26 * phase;
        let mut bodies: Vec<_> = (0..self.pile)
            .map(|k| {
                let at = vec(x, RADIUS * (2 * k + 1) as Real);
                let body = RigidBodyBuilder::dynamic().translation(at);
                world.insert(body, (self.shape)()).0
            })
            .collect();
        (0..5).for_each(|_| world.step());
        let way = speed / self.rate as Real * (1.0 + phase) + 0.001;
        let at = vec(x, RADIUS * (2 * self.pile + 1) as Real + way);
        let bullet = RigidBodyBuilder::dynamic().translation(at).linvel(vec(0.0, -speed));
        let shape = (self.shape)().density(self.heavier);
        bodies.push(world.insert(bullet.ccd_enabled(true), shape).0);
        (0..15).any(|_| {
            world.step();
            let mut places = bodies.iter().map(|&body| world.bodies[body].translation());
            places.any(|at| at.y < -0.5 * RADIUS && (at - vec(x, 0.0)).length() < DISTANCE)
        })
    }
}

fn lay_floor(world: &mut PhysicsWorld, thickness: Real) {
    let half = 0.5 * thickness;
    world.insert_collider(cuboid(100.0, half).translation(vec(0.0, -half)), None);
}

/// Number of bodies that an impact from behind presses through a floor: zero.
#[test]
fn bodies_are_not_pressed_through_a_floor() {
    let columns = ["floor", "pile", "mass", "50", "100", "400", "1000"];
    let mut table = Table::new("bodies that are pressed through, of 20", &columns);
    let floors: [Ground; 2] = [
        ("2 cm", |world, _, _| lay_floor(world, 0.02)),
        ("10 cm", |world, _, _| lay_floor(world, 0.1)),
    ];
    let is_among = |name: &str| ["mesh", "height field", "closed meshes"].contains(&name);
    let grounds = GROUNDS.into_iter().filter(|(name, _)| is_among(name));
    let ball = || ColliderBuilder::ball(RADIUS);
    let cube = || cuboid(RADIUS, RADIUS);
    let shapes: [(&str, &dyn Fn() -> ColliderBuilder); 2] = [("ball", &ball), ("box", &cube)];
    for (name, lay) in floors.into_iter().chain(grounds) {
        for (what, shape) in shapes {
            for (pile, heavier, rate) in
                [(1, 100.0, 60), (3, 1.0, 60), (3, 10.0, 60), (3, 10.0, 30)]
            {
                let press = Press { lay, shape, pile, heavier, rate };
                let counts = SPEEDS.map(|speed| press.count_passed(speed));
                let [a, b, c, d] = counts.map(|count| count.to_string());
                let pile = format!("{pile}, {what}, {rate} Hz");
                table.row([name.to_owned(), pile, format!("{heavier}"), a, b, c, d]);
                table.require(counts == [0; 4], "bodies were pressed through");
            }
        }
    }
}
