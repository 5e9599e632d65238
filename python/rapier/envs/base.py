"""The part that all environments share: tasks over batches, and the two interfaces of gymnasium."""

import sys

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from rapier import dim3


class Task:
    """A task in some independent worlds, which step together.

    A subclass defines the attributes below and the methods `build`, `randomize`, `apply`, `observe` and `judge`. Arrays have a row for each world.
    """

    engine = dim3
    #: Spaces of one world.
    action_space: gymnasium.Space
    observation_space: gymnasium.Space
    #: Length of a step of the engine (s), and such steps for each action.
    dt = 0.01
    frame_skip = 1
    #: Actions after which an episode is truncated.
    max_episode_steps = 1000

    def __init__(self, count):
        self.count = count
        self.world = self.build()
        self.batch = self.engine.WorldBatch(self.world, count)
        self.bodies = {body: row for row, body in enumerate(self.world.bodies)}
        self.state = self.batch.state()
        self.initial = self.state.copy()
        angular = 1 if self.engine.DIM == 2 else 3
        self.forces = np.zeros((*self.state.shape[:2], self.engine.DIM + angular), self.state.dtype)

    def build(self):
        """The world of the task. Actions refer to objects of it."""
        raise NotImplementedError

    def randomize(self, row, rng):
        """Changes the initial state of the bodies of one world: `row` is `self.state[index]`."""

    def begin(self, selected):
        """Notes the begin of episodes. `selected` are booleans, one for each world."""

    def apply(self, actions):
        """Sets forces and motors for the next steps."""
        raise NotImplementedError

    def observe(self):
        """The observations: an array of the shape (count, ...)."""
        raise NotImplementedError

    def judge(self, actions):
        """The rewards and whether the task has ended, by the state after the steps: two arrays of the shape (count,)."""
        raise NotImplementedError

    def camera(self, index):
        """Keyword arguments of the picture of one world: see `WorldBatch.render`."""
        return {}

    def reset(self, selected, rngs):
        """Begins new episodes in the selected worlds."""
        self.batch.reset(selected)
        self.state[selected] = self.initial[selected]
        for index in np.flatnonzero(selected):
            self.randomize(self.state[index], rngs[index])
        self.batch.set_state(self.state, mask=selected)
        self.begin(selected)

    def step(self, actions):
        """Applies actions and moves all worlds forward. Returns rewards and whether the tasks have ended."""
        self.apply(actions)
        self.batch.step(self.frame_skip)
        self.batch.state(out=self.state)
        return self.judge(actions)

    def render(self, index):
        """A picture of one world."""
        return self.batch.render(index, 640, 360, **self.camera(index))

    def of(self, body):
        """The rows of a body: a view of the shape (count, 13) in 3D, (count, 6) in 2D."""
        return self.state[:, self.bodies[body]]


def _metadata(task):
    return {"render_modes": ["rgb_array"], "render_fps": round(1 / (task.dt * task.frame_skip))}


class WorldEnv(gymnasium.Env):
    """A task in one world. `render_mode="rgb_array"` gives pictures that the processor paints.

    `gymnasium.make` truncates an episode after `max_episode_steps` of the task. The class itself does not.
    """

    task_type: type

    def __init_subclass__(cls):
        cls.metadata = _metadata(cls.task_type)

    def __init__(self, render_mode=None):
        self.task = self.task_type(1)
        self.render_mode = render_mode
        self.action_space = self.task.action_space
        self.observation_space = self.task.observation_space

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.task.reset(np.array([True]), [self.np_random])
        return self.task.observe()[0], {}

    def step(self, action):
        rewards, ended = self.task.step(np.asarray(action)[None])
        return self.task.observe()[0], float(rewards[0]), bool(ended[0]), False, {}

    def render(self):
        return self.task.render(0) if self.render_mode == "rgb_array" else None


class WorldVectorEnv(VectorEnv):
    """A task in many worlds, which step on all cores with one call. World i with the seed s gives the bits of one world with the seed s + i.

    An ended episode begins anew in the same step, and `infos["final_obs"]` contains its last observation.
    """

    task_type: type

    def __init_subclass__(cls):
        cls.metadata = {**_metadata(cls.task_type), "autoreset_mode": AutoresetMode.SAME_STEP}

    def __init__(self, num_envs=1, render_mode=None, max_episode_steps=None):
        self.task = self.task_type(num_envs)
        self.num_envs = num_envs
        self.render_mode = render_mode
        self.max_episode_steps = max_episode_steps or self.task_type.max_episode_steps
        self.single_action_space = self.task.action_space
        self.single_observation_space = self.task.observation_space
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.elapsed = np.zeros(num_envs, int)
        self.generators = [None] * num_envs

    def reset(self, *, seed=None, options=None):
        seeds = seed if isinstance(seed, (list, tuple)) else [None if seed is None else seed + index for index in range(self.num_envs)]
        for index, own in enumerate(seeds):
            if own is not None or self.generators[index] is None:
                self.generators[index], _ = gymnasium.utils.seeding.np_random(own)
        every = np.ones(self.num_envs, bool)
        self.task.reset(every, self.generators)
        self.elapsed[:] = 0
        return self.task.observe(), {}

    def step(self, actions):
        rewards, ended = self.task.step(np.asarray(actions))
        self.elapsed += 1
        truncated = self.elapsed >= self.max_episode_steps
        observations, infos = self.task.observe(), {}
        done = ended | truncated
        if done.any():
            infos = {"final_obs": observations, "_final_obs": done, "episode_steps": np.where(done, self.elapsed, 0)}
            self.task.reset(done, self.generators)
            self.elapsed[done] = 0
            observations = self.task.observe()
        return observations, np.asarray(rewards, np.float64), ended, truncated, infos

    def render(self):
        return tuple(self.task.render(index) for index in range(self.num_envs)) if self.render_mode == "rgb_array" else None


def environments(task):
    """The classes of a task: one world, such as `AntEnv`, and many, such as `AntVectorEnv`."""
    attributes = {"task_type": task, "__module__": __package__, "__doc__": task.__doc__}
    return [type(task.__name__ + name, (base,), attributes) for name, base in (("Env", WorldEnv), ("VectorEnv", WorldVectorEnv))]


def engine_of(world):
    """The module of a world: `rapier.dim3` or another one."""
    return sys.modules[type(world).__module__]


def limb(world, body, start, end, radius, **options):
    """Adds a capsule between two points (m, frame of the body) to a body."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    along = end - start
    length = np.linalg.norm(along)
    axis = along / length
    # The shortest rotation from y to the axis.
    rotation = np.array([axis[2], 0.0, -axis[0], 1.0 + axis[1]])
    norm = np.linalg.norm(rotation)
    rotation = rotation / norm if norm > 1e-6 else np.array([1.0, 0.0, 0.0, 0.0])
    shape = engine_of(world).Shape.capsule(0.5 * length, radius)
    return world.add_collider(shape, body, position=0.5 * (start + end), rotation=rotation, **options)


def box_space(size, low=-np.inf, high=np.inf):
    """A space of vectors."""
    return gymnasium.spaces.Box(low, high, (size,), np.float32)


def up_of(rotations):
    """The vertical component of the up axis of bodies with these quaternions (x, y, z, w)."""
    return 1.0 - 2.0 * (rotations[..., 0] ** 2 + rotations[..., 2] ** 2)

