"""A four-legged robot that learns to run. 3D."""

import numpy as np

from .base import box_space, engine_of, limb
from .walker import BODY, GROUND, Walker

RADIUS = 0.25  # of the torso (m)
UPPER, LOWER, THICKNESS = 0.28, 0.57, 0.08  # lengths and radius of the parts of a leg (m)
HEIGHT = 0.65  # of the torso at the start (m)
HIP, KNEE = 0.6, 0.6  # largest angles from the middle (rad)
BENT = 0.9  # angle of the knee in the middle (rad)
STIFFNESS, DAMPING = 400.0, 40.0  # of the motors (1/s², 1/s)


def add_ant(world):
    """Adds an ant to a world. Returns the torso and the eight joints: hip and knee of each leg."""
    options = {"density": 200.0, "friction": 1.0, "collision_groups": (BODY, GROUND)}
    torso = world.add_body(shape=engine_of(world).Shape.ball(RADIUS), position=[0, HEIGHT, 0], can_sleep=False, **options)
    joints = []
    for x, z in [(1, 1), (-1, 1), (-1, -1), (1, -1)]:
        out = np.array([x, 0.0, z]) / np.sqrt(2)
        hip, knee = RADIUS * out, UPPER * out
        foot = LOWER * (np.cos(BENT) * out - np.sin(BENT) * np.array([0.0, 1.0, 0.0]))
        thigh = world.add_body(position=hip + [0, HEIGHT, 0], can_sleep=False)
        shin = world.add_body(position=hip + knee + [0, HEIGHT, 0], can_sleep=False)
        limb(world, thigh, [0, 0, 0], knee, THICKNESS, **options)
        limb(world, shin, [0, 0, 0], foot, THICKNESS, **options)
        joints.append(world.add_joint("revolute", torso, thigh, anchor1=hip, axis=[0, 1, 0], limits=(-HIP, HIP), contacts=False, reduced=True))
        across = np.array([-out[2], 0.0, out[0]])
        joints.append(world.add_joint("revolute", thigh, shin, anchor1=knee, axis=across, limits=(-KNEE, KNEE), contacts=False, reduced=True))
    return torso, joints


class Ant(Walker):
    """Eight actions from -1 to 1 are the targets of the motors of the hips and knees.

    Observation (27): height, quaternion, linear and angular velocity of the torso, angles and velocities of the joints. Reward: speed along x, plus 1, minus 0.05
    times the sum of the squared actions. The episode ends if the torso is below 0.25 m, above 1.2 m, or upside down, and is truncated
    after 1000 actions.
    """

    action_space = box_space(8, -1.0, 1.0)
    observation_space = box_space(27)
    dt = 0.01
    frame_skip = 5
    stiffness, damping = STIFFNESS, DAMPING
    initial_speed = 0.1
    alive_reward = 1.0
    action_cost = 0.05
    heights = (0.25, 1.2)
    up_min = 0.0

    def add_robot(self, world):
        torso, joints = add_ant(world)
        return torso, joints, [(-HIP, HIP), (-KNEE, KNEE)] * 4

    def camera(self, index):
        x, y, z = self.of(self.torso)[index, :3]
        return {"focus": ([x - 1.2, 0, z - 1.2], [x + 1.2, 1.0, z + 1.2]), "pitch": 25}
