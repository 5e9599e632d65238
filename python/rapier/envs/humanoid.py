"""A robot with two legs and two arms that learns to walk. 3D."""

import numpy as np

from .base import box_space, limb
from .walker import BODY, GROUND, Walker

STIFFNESS, DAMPING = 900.0, 60.0  # of the motors (1/s², 1/s)
PELVIS = 1.0  # height (m)
DENSITY = 1000.0
X, Y, Z = np.eye(3)

#: Joints of a leg and an arm: name of the part, its parent, the place of the joint relative to the pelvis (m, z for the left side), axis, largest angles (rad), the
#: segments of the part relative to the joint with their radii (m). The robot looks along x. A hip and a shoulder are two hinges with a ball between them.
LEG = [
    ("hip", "pelvis", (0.0, -0.05, 0.1), X, (-0.4, 0.4), [((0, 0.02, 0), (0, -0.02, 0), 0.06)]),
    ("thigh", "hip", (0.0, -0.05, 0.1), Z, (-0.6, 1.6), [((0, 0, 0), (0, -0.4, 0), 0.065)]),
    ("shin", "thigh", (0.0, -0.45, 0.1), Z, (-2.0, 0.0), [((0, -0.02, 0), (0, -0.38, 0), 0.05)]),
    ("foot", "shin", (0.0, -0.87, 0.1), Z, (-0.7, 0.5), [((-0.07, -0.08, 0.03), (0.16, -0.08, 0.03), 0.035), ((-0.07, -0.08, -0.03), (0.16, -0.08, -0.03), 0.035)]),
]
ARM = [
    ("shoulder", "chest", (0.0, 0.42, 0.2), X, (-0.3, 1.5), [((0, 0.01, 0), (0, -0.01, 0), 0.05)]),
    ("upper arm", "shoulder", (0.0, 0.42, 0.2), Z, (-1.2, 1.6), [((0, -0.02, 0), (0, -0.26, 0), 0.045)]),
    ("forearm", "upper arm", (0.0, 0.14, 0.2), Z, (0.0, 2.2), [((0, -0.03, 0), (0, -0.25, 0), 0.04)]),
]
WAIST = ("chest", "pelvis", (0.0, 0.1, 0.0), Z, (-0.6, 0.9), [((0, 0.13, 0.09), (0, 0.13, -0.09), 0.11), ((0, 0.28, 0.1), (0, 0.28, -0.1), 0.09), ((0, 0.5, 0), (0, 0.52, 0), 0.1)])


def add_humanoid(world):
    """Adds a humanoid to a world. Returns the pelvis, the fifteen joints and their largest angles."""
    options = {"density": DENSITY, "friction": 1.0, "collision_groups": (BODY, GROUND)}
    parts = {"pelvis": (world.add_body(position=[0, PELVIS, 0], can_sleep=False), np.zeros(3))}
    limb(world, parts["pelvis"][0], [0, 0, 0.08], [0, 0, -0.08], 0.1, **options)
    joints, ranges = [], []

    def add(description, side):
        name, parent, place, axis, limits, segments = description
        mirror = np.array([1.0, 1.0, side])
        # The parts of the body's middle have no side.
        key = name if name == "chest" else (name, side)
        body1, origin = parts[parent] if parent in parts else parts[parent, side]
        place = np.array(place) * mirror
        body2 = world.add_body(position=place + [0, PELVIS, 0], can_sleep=False)
        for start, end, radius in segments:
            limb(world, body2, np.array(start) * mirror, np.array(end) * mirror, radius, **options)
        # Outwards is positive on both sides.
        turn = axis * (-side if axis is X else 1.0)
        joints.append(world.add_joint("revolute", body1, body2, anchor1=place - origin, axis=turn, limits=limits, contacts=False, reduced=True))
        ranges.append(limits)
        parts[key] = (body2, place)

    add(WAIST, 1.0)
    for side in (1.0, -1.0):
        for description in LEG + ARM:
            add(description, side)
    return parts["pelvis"][0], joints, np.array(ranges)


class Humanoid(Walker):
    """Fifteen actions from -1 to 1 are the targets of the motors: 0 is upright, and the ends are the limits of the joints.

    Observation (41): height, quaternion, linear and angular velocity of the pelvis, angles and velocities of the joints. Reward: 1.25 times the speed along x, plus
    2, minus 0.1 times the sum of the squared actions. The episode ends if the pelvis is below 0.7 m, above 1.6 m, or leans by more than 60°, and is truncated
    after 1000 actions.
    """

    action_space = box_space(15, -1.0, 1.0)
    observation_space = box_space(41)
    dt = 0.005
    frame_skip = 5
    stiffness, damping = STIFFNESS, DAMPING
    initial_speed = 0.05
    speed_reward = 1.25
    alive_reward = 2.0
    action_cost = 0.1
    heights = (0.7, 1.6)
    up_min = 0.5

    def add_robot(self, world):
        return add_humanoid(world)

    def camera(self, index):
        x, _, z = self.of(self.torso)[index, :3]
        return {"focus": ([x - 0.6, 0.1, z - 0.6], [x + 0.6, 1.7, z + 0.6]), "yaw": 40, "pitch": 12}
