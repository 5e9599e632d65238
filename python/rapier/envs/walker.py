"""The part that robots with legs share. 3D."""

import numpy as np

from .base import Task, up_of

GROUND, BODY = 1, 2  # groups of colliders: the parts of a robot touch the ground alone


class Walker(Task):
    """A robot that learns to run along x. Actions from -1 to 1 are the targets of the motors of its joints: the ends are the limits, and 0 is the angle 0.

    A subclass defines the attributes below and the method `add_robot`. Observation: height, quaternion, linear and angular velocity of the torso, angles and velocities
    of the joints. Reward: the speed along x times `speed_reward`, plus `alive_reward`, minus `action_cost` times the sum of the squared actions. The episode ends if the
    torso is outside of `heights`, or if the vertical component of its axis is below `up_min`.
    """

    #: Of the motors (1/s², 1/s).
    stiffness: float
    damping: float
    #: Largest component of the initial velocities (m/s).
    initial_speed: float
    speed_reward = 1.0
    alive_reward: float
    action_cost: float
    #: Smallest and largest height of the torso (m).
    heights: tuple
    up_min: float

    def add_robot(self, world):
        """Adds the robot to a world. Returns the torso, the joints and their limits (rad), an array of the shape (joints, 2)."""
        raise NotImplementedError

    def build(self):
        world = self.engine.World(dt=self.dt)
        world.add_collider(self.engine.Shape.box([200, 0.5, 200]), position=[0, -0.5, 0], friction=1.0, collision_groups=(GROUND, BODY))
        self.torso, self.joints, limits = self.add_robot(world)
        self.low, self.high = np.asarray(limits, np.float32).T
        self.angles = np.zeros((self.count, len(self.joints), 2), np.float32)
        return world

    def randomize(self, row, rng):
        row[:, 7:10] += rng.uniform(-self.initial_speed, self.initial_speed, 3)

    def apply(self, actions):
        actions = np.clip(actions, -1, 1)
        targets = np.where(actions > 0, actions * self.high, -actions * self.low)
        self.batch.set_motors(self.joints, targets, stiffness=self.stiffness, damping=self.damping)

    def observe(self):
        self.batch.joint_state(self.joints, out=self.angles)
        torso = self.of(self.torso)
        parts = [torso[:, 1:2], torso[:, 3:13], self.angles[:, :, 0], self.angles[:, :, 1]]
        return np.concatenate(parts, axis=1).astype(np.float32)

    def judge(self, actions):
        torso = self.of(self.torso)
        cost = self.action_cost * np.square(np.clip(actions, -1, 1)).sum(axis=1)
        low, high = self.heights
        ended = (torso[:, 1] < low) | (torso[:, 1] > high) | (up_of(torso[:, 3:7]) < self.up_min)
        return self.speed_reward * torso[:, 7] + self.alive_reward - cost, ended
