"""A pole on a cart, kept upright by pushes. 2D."""

import gymnasium
import numpy as np

from rapier import dim2

from .base import Task, box_space

FORCE = 10.0  # N
REACH = 2.4  # m
TILT_MAX = np.radians(12.0)
HALF_POLE = 0.5  # m


class CartPole(Task):
    """Two actions push the cart left or right with 10 N.

    Observation: position (m) and velocity (m/s) of the cart, tilt to the right (rad) and its velocity (rad/s). Reward: 1 for each step. The episode ends
    with a tilt above 12° or at a distance above 2.4 m, and is truncated after 500 actions. 475 is a good return.
    """

    engine = dim2
    action_space = gymnasium.spaces.Discrete(2)
    observation_space = box_space(4)
    dt = 0.02
    max_episode_steps = 500

    def build(self):
        world = dim2.World(dt=self.dt)
        rail = world.add_body("fixed")
        world.add_collider(dim2.Shape.box([2 * REACH, 0.02]), rail, collision_groups=(0, 0))
        options = {"can_sleep": False, "collision_groups": (0, 0)}
        self.cart = world.add_body(shape=dim2.Shape.box([0.25, 0.15]), mass=1.0, **options)
        self.pole = world.add_body(shape=dim2.Shape.box([0.03, HALF_POLE]), mass=0.1, position=[0, HALF_POLE], **options)
        world.add_joint("prismatic", rail, self.cart, axis=[1, 0])
        world.add_joint("revolute", self.cart, self.pole, anchor2=[0, -HALF_POLE])
        return world

    def randomize(self, row, rng):
        place, speed, tilt, spin = rng.uniform(-0.05, 0.05, 4)
        middle = HALF_POLE * np.array([-np.sin(tilt), np.cos(tilt)])
        row[self.bodies[self.cart]] = [place, 0, 0, speed, 0, 0]
        row[self.bodies[self.pole]] = [place + middle[0], middle[1], tilt, speed - middle[1] * spin, middle[0] * spin, spin]

    def apply(self, actions):
        self.forces[:, self.bodies[self.cart], 0] = np.where(actions == 1, FORCE, -FORCE)
        self.batch.set_forces(self.forces)

    def observe(self):
        cart, pole = self.of(self.cart), self.of(self.pole)
        return np.stack([cart[:, 0], cart[:, 3], -pole[:, 2], -pole[:, 5]], axis=1).astype(np.float32)

    def judge(self, actions):
        ended = (np.abs(self.of(self.cart)[:, 0]) > REACH) | (np.abs(self.of(self.pole)[:, 2]) > TILT_MAX)
        return np.ones(self.count), ended

    def camera(self, index):
        return {"focus": ([-REACH, -0.5], [REACH, 1.3])}
