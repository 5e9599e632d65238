"""The ids of the environments. Gymnasium imports this module while it is imported itself, so the module imports no environment."""

#: The task and the steps of an episode by id.
ENVIRONMENTS = {
    "rapier/CartPole-v0": ("CartPole", 500),
    "rapier/Ant-v0": ("Ant", 1000),
    "rapier/Humanoid-v0": ("Humanoid", 1000),
    "rapier/Reacher-v0": ("Reacher", 150),
    "rapier/Car-v0": ("Car", 600),
    "rapier/Soccer-v0": ("Soccer", 400),
}


def register_envs():
    """Registers the environments under their ids. Gymnasium calls it as the package's entry point; a second call changes nothing."""
    from gymnasium.envs.registration import register, registry

    for name, (task, steps) in ENVIRONMENTS.items():
        if name not in registry:
            register(name, entry_point=f"rapier.envs:{task}Env", vector_entry_point=f"rapier.envs:{task}VectorEnv", max_episode_steps=steps)
