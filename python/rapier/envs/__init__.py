"""Environments for gymnasium, written against the public package. `pip install rapier[envs]` installs what they need.

``gymnasium.make("rapier/Ant-v0")`` is one world, ``gymnasium.make_vec("rapier/Ant-v0", num_envs=64, vectorization_mode="vector_entry_point")`` is a batch of worlds
that step on all cores with one call.
"""

from .._registry import register_envs
from .ant import Ant, AntEnv, AntVectorEnv
from .base import Task, WorldEnv, WorldVectorEnv
from .car import Car, CarEnv, CarVectorEnv
from .cart_pole import CartPole, CartPoleEnv, CartPoleVectorEnv
from .humanoid import Humanoid, HumanoidEnv, HumanoidVectorEnv
from .reacher import Reacher, ReacherEnv, ReacherVectorEnv
from .soccer import Soccer, SoccerEnv, SoccerVectorEnv

register_envs()

__all__ = [
    "Ant", "AntEnv", "AntVectorEnv", "Car", "CarEnv", "CarVectorEnv", "CartPole", "CartPoleEnv", "CartPoleVectorEnv", "Humanoid", "HumanoidEnv",
    "HumanoidVectorEnv", "Reacher", "ReacherEnv", "ReacherVectorEnv", "Soccer", "SoccerEnv", "SoccerVectorEnv", "Task", "WorldEnv", "WorldVectorEnv", "register_envs",
]
