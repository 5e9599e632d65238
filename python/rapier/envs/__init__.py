"""Environments for gymnasium, written against the public package. `pip install rapier[envs]` installs their dependencies.

``gymnasium.make("rapier/Ant-v0")`` is one world, ``gymnasium.make_vec("rapier/Ant-v0", num_envs=64, vectorization_mode="vector_entry_point")`` is a batch of worlds
that step on all cores with one call. Each task, such as ``Ant``, has two classes: ``AntEnv`` and ``AntVectorEnv``.
"""

from .._registry import register_envs
from .ant import Ant
from .base import Task, WorldEnv, WorldVectorEnv, environments
from .car import Car
from .cart_pole import CartPole
from .humanoid import Humanoid
from .reacher import Reacher
from .soccer import Soccer
from .walker import Walker

TASKS = [Ant, Car, CartPole, Humanoid, Reacher, Soccer]
_CLASSES = {own.__name__: own for task in TASKS for own in environments(task)}
globals().update(_CLASSES)

register_envs()

__all__ = ["TASKS", "Task", "Walker", "WorldEnv", "WorldVectorEnv", "environments", "register_envs", *[task.__name__ for task in TASKS], *_CLASSES]
