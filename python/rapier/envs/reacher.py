"""An arm with three hinges that reaches for a point. 3D."""

import numpy as np

from rapier import dim3

from .base import Task, box_space, limb

SHOULDER = 0.4  # height (m)
LENGTH = 0.45  # of both parts (m)
RADIUS = 0.05
SPEED = 3.0  # of the motors with an action of 1 (rad/s)
FIRMNESS = 400.0  # of the motors (1/s)
NEAR, FAR = 0.35, 0.8  # distances of targets from the shoulder (m)


class Reacher(Task):
    """Three actions from -1 to 1 are the speeds of the motors: of the base, of the shoulder and of the elbow.

    Observation (12): angles and velocities of the joints, the target and the way from the tip to the target (m). Reward: minus the distance (m), minus 0.01 times the
    sum of the squared actions, plus 1 within 5 cm. The episode is truncated after 150 actions.
    """

    action_space = box_space(3, -1.0, 1.0)
    observation_space = box_space(12)
    dt = 0.01
    frame_skip = 2
    max_episode_steps = 150

    def build(self):
        world = dim3.World(dt=self.dt)
        world.add_collider(dim3.Shape.box([3, 0.1, 3]), position=[0, -0.1, 0], collision_groups=(0, 0))
        options = {"density": 300.0, "collision_groups": (0, 0)}
        foot = world.add_body("fixed")
        world.add_collider(dim3.Shape.cylinder(0.5 * SHOULDER - RADIUS, 0.09), foot, position=[0, 0.5 * SHOULDER - RADIUS, 0], collision_groups=(0, 0))
        base = world.add_body(shape=dim3.Shape.cylinder(RADIUS, 0.09), position=[0, SHOULDER - RADIUS, 0], can_sleep=False, **options)
        upper = world.add_body(position=[0, SHOULDER, 0], can_sleep=False)
        self.lower = world.add_body(position=[0, SHOULDER + LENGTH, 0], can_sleep=False)
        for part in (upper, self.lower):
            limb(world, part, [0, 0, 0], [0, LENGTH, 0], RADIUS, **options)
        self.target = world.add_body("fixed", dim3.Shape.ball(0.06), position=[NEAR, SHOULDER, 0], sensor=True)
        self.joints = [
            world.add_joint("revolute", foot, base, anchor1=[0, SHOULDER - RADIUS, 0], axis=[0, 1, 0], contacts=False, reduced=True),
            world.add_joint("revolute", base, upper, anchor1=[0, RADIUS, 0], axis=[0, 0, 1], limits=(-2.0, 2.0), contacts=False, reduced=True),
            world.add_joint("revolute", upper, self.lower, anchor1=[0, LENGTH, 0], axis=[0, 0, 1], limits=(-2.5, 2.5), contacts=False, reduced=True),
        ]
        self.angles = np.zeros((self.count, 3, 2), np.float32)
        return world

    def randomize(self, row, rng):
        direction = rng.normal(size=3)
        direction[1] = abs(direction[1])
        direction /= np.linalg.norm(direction)
        row[self.bodies[self.target], :3] = rng.uniform(NEAR, FAR) * direction + [0, SHOULDER, 0]

    def apply(self, actions):
        self.batch.set_motors(self.joints, SPEED * np.clip(actions, -1, 1), damping=FIRMNESS)

    def way(self):
        """From the tip of the arm to the target (m)."""
        lower = self.of(self.lower)
        x, y, z, w = lower[:, 3:7].T
        axis = np.stack([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], axis=1)
        return self.of(self.target)[:, :3] - lower[:, :3] - LENGTH * axis

    def observe(self):
        self.batch.joint_state(self.joints, out=self.angles)
        parts = [self.angles.reshape(self.count, 6), self.of(self.target)[:, :3], self.way()]
        return np.concatenate(parts, axis=1).astype(np.float32)

    def judge(self, actions):
        distance = np.linalg.norm(self.way(), axis=1)
        cost = 0.01 * np.square(np.clip(actions, -1, 1)).sum(axis=1)
        return (distance < 0.05) - distance - cost, np.zeros(self.count, bool)

    def camera(self, index):
        return {"focus": ([-0.8, 0.0, -0.8], [0.8, 1.3, 0.8]), "pitch": 22}
