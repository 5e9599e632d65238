"""A car that drives to a flag over hills. 3D."""

import numpy as np

from rapier import dim3

from .base import Task, box_space, up_of

SIDE, CELLS, HILL = 120.0, 60, 2.5  # length of the terrain (m), its cells, its height (m)
DRIVE, BRAKE, STEER = 2500.0, 4000.0, 0.5  # largest forces of a wheel (N), largest angle (rad)
MASS = 1000.0
CLEARANCE = 1.0  # of the chassis above the ground at the begin (m)
GOAL = 4.0  # distance that reaches the flag (m)
#: Points where the observation contains the height of the ground: ahead and to the left of the car (m).
PROBES = np.array([(ahead, left) for ahead in (4.0, 8.0, 14.0) for left in (-3.0, 0.0, 3.0)])


def hills():
    """Heights of the terrain: level in the middle, where cars begin."""
    x, z = np.meshgrid(*[np.linspace(-SIDE / 2, SIDE / 2, CELLS + 1)] * 2)
    waves = np.sin(0.11 * x) * np.cos(0.13 * z) + 0.4 * np.sin(0.31 * x + 1.0) * np.sin(0.27 * z)
    return HILL * waves * np.clip(np.hypot(x, z) / 20.0 - 0.4, 0.0, 1.0)


class Car(Task):
    """Two actions from -1 to 1: drive or brake, and steer (positive to the left).

    Observation (25): the axes of the chassis ahead and up, linear and angular velocity in its frame, the way to the flag ahead and to the left (m) and its
    direction, and the heights of nine points of the ground ahead relative to the car (m). Reward: decrease of the distance to the flag (m), and 20 at the flag,
    which ends the episode. The episode ends as well if the car leans by more than 80° or leaves the terrain. It is
    truncated after 600 actions.
    """

    action_space = box_space(2, -1.0, 1.0)
    observation_space = box_space(25)
    dt = 1 / 60
    frame_skip = 3
    max_episode_steps = 600

    def build(self):
        self.heights = hills()
        world = dim3.World(dt=self.dt)
        world.add_collider(dim3.Shape.heightfield(self.heights, [SIDE, 1, SIDE]), friction=1.0)
        self.chassis = world.add_body(shape=dim3.Shape.box([1.9, 0.35, 0.85]), position=[0, CLEARANCE, 0], mass=MASS, can_sleep=False)
        world.add_collider(dim3.Shape.box([0.9, 0.25, 0.75]), self.chassis, position=[-0.2, 0.6, 0], density=0.0)
        self.vehicle = world.add_vehicle(self.chassis)
        for x in (1.25, -1.25):
            for z in (0.8, -0.8):
                self.vehicle.add_wheel(
                    [x, -0.15, z], rest_length=0.45, radius=0.38, stiffness=40.0, compression=2.5, relaxation=3.5, travel=0.35, grip=1.3, max_force=20000.0,
                )
        flag = world.add_body("fixed", dim3.Shape.cylinder(1.5, 0.12), position=[20, 1.5, 0], sensor=True)
        world.add_collider(dim3.Shape.box([0.5, 0.3, 0.05]), flag, position=[0.6, 1.2, 0], sensor=True)
        self.flag = flag
        self.controls = np.zeros((self.count, 4, 3), np.float32)
        self.distance = np.zeros(self.count)
        return world

    def height(self, points):
        """Heights of the terrain at points of the shape (..., 2): x and z (m)."""
        place = np.clip((points / SIDE + 0.5) * CELLS, 0, CELLS - 1e-6)
        cell = place.astype(int)
        part = place - cell
        (i, j), (u, v) = np.moveaxis(cell, -1, 0), np.moveaxis(part, -1, 0)
        grid = self.heights
        return (1 - v) * ((1 - u) * grid[j, i] + u * grid[j, i + 1]) + v * ((1 - u) * grid[j + 1, i] + u * grid[j + 1, i + 1])

    def randomize(self, row, rng):
        heading, bearing = rng.uniform(-np.pi, np.pi, 2)
        row[self.bodies[self.chassis], 3:7] = [0, np.sin(heading / 2), 0, np.cos(heading / 2)]
        place = rng.uniform(20, 45) * np.array([np.cos(bearing), np.sin(bearing)])
        row[self.bodies[self.flag], :3] = [place[0], self.height(place) + 1.5, place[1]]

    def begin(self, selected):
        self.controls[selected] = 0.0
        self.distance[selected] = np.linalg.norm(self.way(), axis=1)[selected]

    def apply(self, actions):
        throttle, steer = np.clip(actions, -1, 1).T
        self.controls[:, :, 0] = (DRIVE * np.maximum(throttle, 0))[:, None]
        # Against the motion the brakes act, and then the reverse gear.
        backwards = (self.axes()[0] * self.of(self.chassis)[:, 7:10]).sum(axis=1) < 0.5
        self.controls[:, :, 0] += np.where(backwards, 0.5 * DRIVE * np.minimum(throttle, 0), 0.0)[:, None]
        self.controls[:, :, 1] = np.where(backwards, 0.0, BRAKE * np.maximum(-throttle, 0))[:, None]
        self.controls[:, :2, 2] = (STEER * steer)[:, None]
        self.batch.set_vehicle_controls(self.vehicle, self.controls)

    def way(self):
        """From the car to the flag: x and z (m)."""
        return (self.of(self.flag) - self.of(self.chassis))[:, [0, 2]]

    def axes(self):
        """The axes of the chassis ahead, up and to the right (world), each of the shape (count, 3)."""
        x, y, z, w = self.of(self.chassis)[:, 3:7].T
        ahead = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)], axis=1)
        up = np.stack([2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)], axis=1)
        return ahead, up, np.cross(ahead, up)

    def observe(self):
        axes = np.stack(self.axes(), axis=1)
        chassis = self.of(self.chassis)
        linvel, angvel = (np.einsum("nij,nj->ni", axes, chassis[:, part]) for part in (slice(7, 10), slice(10, 13)))
        level = axes[:, 0][:, [0, 2]]
        level = level / np.maximum(np.linalg.norm(level, axis=1, keepdims=True), 1e-6)
        left = np.stack([level[:, 1], -level[:, 0]], axis=1)
        way = self.way()
        flag = np.stack([(way * level).sum(axis=1), (way * left).sum(axis=1)], axis=1)
        bearing = flag / np.maximum(np.linalg.norm(flag, axis=1, keepdims=True), 1e-6)
        points = chassis[:, None, [0, 2]] + PROBES[:, 0, None] * level[:, None] + PROBES[:, 1, None] * left[:, None]
        ground = self.height(points) - chassis[:, 1:2]
        return np.concatenate([axes[:, 0], axes[:, 1], linvel, angvel, flag, bearing, ground], axis=1).astype(np.float32)

    def judge(self, actions):
        distance = np.linalg.norm(self.way(), axis=1)
        rewards, reached = self.distance - distance, distance < GOAL
        self.distance = distance
        chassis = self.of(self.chassis)
        lost = (up_of(chassis[:, 3:7]) < 0.17) | (np.abs(chassis[:, [0, 2]]).max(axis=1) > SIDE / 2 - 3)
        return rewards + 20.0 * reached, reached | lost

    def camera(self, index):
        x, y, z = self.of(self.chassis)[index, :3]
        return {"focus": ([x - 7, y - 1, z - 7], [x + 7, y + 2, z + 7]), "yaw": 40, "pitch": 24}
