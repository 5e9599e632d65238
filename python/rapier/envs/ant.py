"""A four-legged robot that learns to run. 3D."""

import numpy as np

from rapier import dim3

from .base import Task, WorldEnv, WorldVectorEnv, box_space, limb, up_of

RADIUS = 0.25  # of the torso (m)
UPPER, LOWER, THICKNESS = 0.28, 0.57, 0.08  # lengths and radius of the parts of a leg (m)
HEIGHT = 0.65  # of the torso at the begin (m)
HIP, KNEE = 0.6, 0.6  # largest angles from the middle (rad)
BENT = 0.9  # angle of the knee in the middle (rad)
STIFFNESS, DAMPING = 400.0, 40.0  # of the motors (1/s², 1/s)
GROUND, BODY = 1, 2


def add_ant(world):
    """Adds an ant to a world. Returns the torso and the eight joints: hip and knee of each leg."""
    options = {"density": 200.0, "friction": 1.0, "collision_groups": (BODY, GROUND)}
    torso = world.add_body(shape=dim3.Shape.ball(RADIUS), position=[0, HEIGHT, 0], can_sleep=False, **options)
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


class Ant(Task):
    """Eight actions from -1 to 1 are the targets of the motors of the hips and knees.

    Observation (27): height, quaternion, linear and angular velocity of the torso, angles and velocities of the joints. Reward: speed along x, plus 1, minus 0.05
    times the sum of the squared actions. The episode ends if the torso is below 0.25 m, above 1.2 m, or upside down.
    """

    action_space = box_space(8, -1.0, 1.0)
    observation_space = box_space(27)
    dt = 0.01
    frame_skip = 5

    def build(self):
        world = dim3.World(dt=self.dt)
        world.add_collider(dim3.Shape.box([200, 0.5, 200]), position=[0, -0.5, 0], friction=1.0, collision_groups=(GROUND, BODY))
        self.torso, self.joints = add_ant(world)
        self.targets = np.zeros((self.count, len(self.joints)), np.float32)
        self.angles = np.zeros((self.count, len(self.joints), 2), np.float32)
        self.scale = np.array([HIP, KNEE] * 4, np.float32)
        return world

    def randomize(self, row, rng):
        row[:, 7:10] += rng.uniform(-0.1, 0.1, 3)

    def apply(self, actions):
        np.multiply(np.clip(actions, -1, 1), self.scale, out=self.targets, casting="same_kind")
        self.batch.set_motors(self.joints, self.targets, stiffness=STIFFNESS, damping=DAMPING)

    def observe(self):
        self.batch.joint_state(self.joints, out=self.angles)
        torso = self.of(self.torso)
        parts = [torso[:, 1:2], torso[:, 3:13], self.angles[:, :, 0], self.angles[:, :, 1]]
        return np.concatenate(parts, axis=1).astype(np.float32)

    def judge(self, actions):
        torso = self.of(self.torso)
        cost = 0.05 * np.square(np.clip(actions, -1, 1)).sum(axis=1)
        ended = (torso[:, 1] < 0.25) | (torso[:, 1] > 1.2) | (up_of(torso[:, 3:7]) < 0)
        return torso[:, 7] + 1.0 - cost, ended

    def camera(self, world):
        x, y, z = world.bodies[self.bodies[self.torso]].position
        return {"focus": ([x - 1.2, 0, z - 1.2], [x + 1.2, 1.0, z + 1.2]), "pitch": 25}


class AntEnv(WorldEnv):
    task_type = Ant


class AntVectorEnv(WorldVectorEnv):
    task_type = Ant
