"""A robot that dribbles a ball past a keeper into a goal. 3D."""

import numpy as np

from rapier import dim3

from .base import Task, box_space

LENGTH, WIDTH, GOAL = 12.0, 8.0, 2.4  # of the pitch and of the opening of the goals (m)
BALL = 0.22  # radius (m)
SPEED, KEEPER_SPEED = 3.5, 1.2  # m/s
GAIN = 8.0  # of the motors of the robots (1/s)
ROBOT_MASS = 6.0


class Soccer(Task):
    """Two actions from -1 to 1 are the velocity of the robot along x and z, times 3.5 m/s. The keeper follows the ball along its goal at 1.2 m/s.

    Observation (20): positions and velocities (x, z) of the robot, the ball and the keeper, the ways from the robot to the ball and from the ball to the goal, and
    the direction of both. Reward: decrease of the distance of the robot to the ball (m), twice that of the ball to the goal, and 20 for a goal, -20 for an own goal.
    A goal ends the episode, and it is truncated after 400 actions.
    """

    action_space = box_space(2, -1.0, 1.0)
    observation_space = box_space(20)
    dt = 1 / 60
    frame_skip = 3
    max_episode_steps = 400

    def build(self):
        world = dim3.World(dt=self.dt)
        world.add_collider(dim3.Shape.box([LENGTH, 0.5, WIDTH]), position=[0, -0.5, 0], friction=0.6)
        x, z = LENGTH / 2, WIDTH / 2
        for side in (-1, 1):
            world.add_collider(dim3.Shape.box([x + 0.1, 0.2, 0.1]), position=[0, 0.2, side * (z + 0.1)], restitution=0.5)
            for corner in (-1, 1):
                half = (z - GOAL / 2) / 2
                world.add_collider(dim3.Shape.box([0.1, 0.2, half]), position=[side * (x + 0.1), 0.2, corner * (GOAL / 2 + half)], restitution=0.5)
                world.add_collider(dim3.Shape.cylinder(0.5, 0.06), position=[side * x, 0.5, corner * GOAL / 2])
            world.add_collider(dim3.Shape.box([0.05, 0.2, GOAL / 2]), position=[side * (x + 0.9), 0.2, 0])
        robot = {"mass": ROBOT_MASS, "friction": 0.0, "friction_combine_rule": "min", "lock_rotations": True, "can_sleep": False}
        self.robot = world.add_body(shape=dim3.Shape.cylinder(0.3, 0.25), position=[-2, 0.3, 0], **robot)
        self.keeper = world.add_body(shape=dim3.Shape.box([0.15, 0.3, 0.4]), position=[x - 0.5, 0.3, 0], **robot)
        self.ball = world.add_body(
            shape=dim3.Shape.ball(BALL), position=[0, BALL, 0], mass=0.43, friction=0.6, restitution=0.5, linear_damping=0.3, angular_damping=0.3, can_sleep=False,
        )
        self.distances = np.zeros((self.count, 2))
        return world

    def randomize(self, row, rng):
        row[self.bodies[self.robot], [0, 2]] = rng.uniform([-5, -3], [-2, 3])
        row[self.bodies[self.ball], [0, 2]] = rng.uniform([-1, -3], [2, 3])

    def begin(self, selected):
        self.distances[selected] = self.measure()[selected]

    def measure(self):
        """Distances (m): of the robot to the ball, and of the ball to the goal."""
        return np.stack([np.linalg.norm(way, axis=1) for way in self.ways()], axis=1)

    def ways(self):
        """From the robot to the ball, and from the ball to the goal: x and z (m)."""
        robot, ball = (self.of(body)[:, [0, 2]] for body in (self.robot, self.ball))
        return ball - robot, np.array([LENGTH / 2, 0.0]) - ball

    def apply(self, actions):
        wanted = SPEED * np.clip(actions, -1, 1)
        follow = np.zeros_like(wanted, dtype=float)
        keeper = self.of(self.keeper)
        follow[:, 0] = 4.0 * (LENGTH / 2 - 0.5 - keeper[:, 0])
        limit = 0.5 * GOAL
        follow[:, 1] = np.clip(4.0 * (np.clip(self.of(self.ball)[:, 2], -limit, limit) - keeper[:, 2]), -KEEPER_SPEED, KEEPER_SPEED)
        for body, velocity in ((self.robot, wanted), (self.keeper, follow)):
            row = self.of(body)
            self.forces[:, self.bodies[body], [0, 2]] = ROBOT_MASS * GAIN * (velocity - row[:, [7, 9]])
        self.batch.set_forces(self.forces)

    def observe(self):
        parts = [self.of(body)[:, [0, 2, 7, 9]] for body in (self.robot, self.ball, self.keeper)]
        ways = self.ways()
        directions = [way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-6) for way in ways]
        return np.concatenate([*parts, *ways, *directions], axis=1).astype(np.float32)

    def judge(self, actions):
        distances = self.measure()
        rewards = (self.distances - distances) @ [1.0, 2.0]
        self.distances = distances
        x = self.of(self.ball)[:, 0]
        scored, conceded = x > LENGTH / 2 + BALL, x < -LENGTH / 2 - BALL
        return rewards + 20.0 * scored - 20.0 * conceded, scored | conceded

    def camera(self, index):
        return {"focus": ([-LENGTH / 2, 0, -WIDTH / 2], [LENGTH / 2, 0.6, WIDTH / 2]), "yaw": 0, "pitch": 48}
