"""Environments: gymnasium's checker, equal bits of both interfaces, and behaviour of the models."""

import pickle

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

from gymnasium.utils.env_checker import check_env  # noqa: E402

import rapier.envs  # noqa: E402
from rapier._registry import ENVIRONMENTS  # noqa: E402

IDS = list(ENVIRONMENTS)


@pytest.mark.parametrize("name", IDS)
@pytest.mark.filterwarnings("ignore:.*WARN.*")
def test_the_checker_of_gymnasium_accepts_it(name):
    check_env(gymnasium.make(name, render_mode="rgb_array").unwrapped)


@pytest.mark.parametrize("name", IDS)
def test_worlds_of_a_vector_give_the_bits_of_single_ones(name):
    count, steps = 3, 25
    vector = gymnasium.make_vec(name, num_envs=count, vectorization_mode="vector_entry_point")
    vector.action_space.seed(0)
    single = [gymnasium.make(name) for _ in range(count)]
    observations, _ = vector.reset(seed=7)
    for index, env in enumerate(single):
        assert np.array_equal(env.reset(seed=7 + index)[0], observations[index])
    for _ in range(steps):
        actions = vector.action_space.sample()
        observations, rewards, terminations, _, infos = vector.step(actions)
        for index, env in enumerate(single):
            observation, reward, terminated, _, _ = env.step(actions[index])
            last = infos["final_obs"][index] if terminated else observations[index]
            assert np.array_equal(last, observation) and reward == rewards[index] and terminated == terminations[index]
            if terminated:
                assert np.array_equal(env.reset()[0], observations[index])


@pytest.mark.parametrize("name", IDS)
def test_equal_seeds_give_equal_episodes(name):
    episodes = []
    for _ in range(2):
        env = gymnasium.make(name)
        env.action_space.seed(3)
        observation, _ = env.reset(seed=3)
        episode = [observation]
        for _ in range(20):
            observation, _, terminated, _, _ = env.step(env.action_space.sample())
            episode.append(observation)
            if terminated:
                break
        episodes.append(np.array(episode))
    assert np.array_equal(*episodes)


@pytest.mark.parametrize("name", IDS)
def test_both_interfaces_truncate_after_the_same_steps(name):
    task, steps = ENVIRONMENTS[name]
    assert getattr(rapier.envs, task).max_episode_steps == steps == gymnasium.spec(name).max_episode_steps


@pytest.mark.parametrize("name", IDS)
def test_both_interfaces_truncate_in_the_same_step(name):
    single = gymnasium.make(name, max_episode_steps=7)
    vector = gymnasium.make_vec(name, num_envs=1, vectorization_mode="vector_entry_point", max_episode_steps=7)
    vector.action_space.seed(0)
    single.reset(seed=0)
    vector.reset(seed=0)
    for _ in range(20):
        actions = vector.action_space.sample()
        terminated, truncated = single.step(actions[0])[2:4]
        assert (terminated, truncated) == tuple(bool(flags[0]) for flags in vector.step(actions)[2:4])
        if terminated or truncated:
            single.reset()


def test_a_fall_in_the_last_step_is_truncated_as_well():
    single = gymnasium.make("rapier/CartPole-v0")
    single.reset(seed=0)
    steps = 1
    while not single.step(1)[2]:
        steps += 1
    vector = gymnasium.make_vec("rapier/CartPole-v0", num_envs=1, vectorization_mode="vector_entry_point", max_episode_steps=steps)
    vector.reset(seed=0)
    ends = [tuple(bool(flags[0]) for flags in vector.step(np.array([1]))[2:4]) for _ in range(steps)]
    assert ends == [(False, False)] * (steps - 1) + [(True, True)]


def test_each_task_has_two_classes():
    assert [task.__name__ for task in rapier.envs.TASKS] == sorted(task for task, _ in ENVIRONMENTS.values())
    for task in rapier.envs.TASKS:
        for name in (f"{task.__name__}Env", f"{task.__name__}VectorEnv"):
            own = getattr(rapier.envs, name)
            assert name in rapier.envs.__all__ and own.task_type is task and pickle.loads(pickle.dumps(own)) is own


def test_an_ant_in_double_precision_stands_as_in_single():
    heights = []
    for engine in (rapier.dim3, rapier.dim3_f64):
        world = engine.World(dt=0.01)
        world.add_collider(engine.Shape.box([200, 0.5, 200]), position=[0, -0.5, 0], friction=1.0)
        torso, joints = rapier.envs.ant.add_ant(world)
        for joint in joints:
            joint.set_motor_position(0.0, 400.0, 40.0)
        world.step(200)
        heights.append(torso.position[1])
    assert heights[0] == pytest.approx(heights[1], abs=1e-3) and heights[0] > 0.35


def test_a_robot_of_soccer_has_no_friction_with_the_ground():
    env = gymnasium.make("rapier/Soccer-v0").unwrapped
    env.reset(seed=0)
    row = env.task.state[:, env.task.bodies[env.task.robot]]
    row[:, [0, 2]] = [-4.0, 0.0]
    env.task.state[:, env.task.bodies[env.task.ball], 2] = 3.0
    env.task.state[:, env.task.bodies[env.task.robot]] = row
    env.task.batch.set_state(env.task.state)
    for _ in range(30):
        observation = env.step(np.array([1.0, 0.0], np.float32))[0]
    # The motor alone acts: 1 - exp(-8 · 1.5) of the speed.
    assert observation[2] == pytest.approx(3.5, rel=0.01)


def test_an_episode_of_a_vector_is_truncated_and_begins_anew():
    vector = gymnasium.make_vec("rapier/Reacher-v0", num_envs=2, vectorization_mode="vector_entry_point")
    vector.reset(seed=0)
    still = np.zeros((2, 3), np.float32)
    for step in range(1, 151):
        observations, _, terminations, truncations, infos = vector.step(still)
        assert truncations.all() == (step == 150) and not terminations.any()
    assert not np.array_equal(infos["final_obs"], observations)
    assert infos["_final_obs"].all()


def test_a_policy_balances_the_pole():
    env = gymnasium.make("rapier/CartPole-v0")
    for seed in range(5):
        observation, _ = env.reset(seed=seed)
        total, over = 0.0, False
        while not over:
            action = int(observation @ [0.3, 0.6, 8.0, 2.0] > 0)
            observation, reward, terminated, truncated, _ = env.step(action)
            total, over = total + reward, terminated or truncated
        assert total == 500.0


def test_a_constant_push_fells_the_pole():
    env = gymnasium.make("rapier/CartPole-v0")
    env.reset(seed=0)
    steps, terminated = 0, False
    while not terminated:
        _, _, terminated, _, _ = env.step(1)
        steps += 1
    assert 5 <= steps <= 15


@pytest.mark.parametrize("name, least", [("rapier/Ant-v0", 0.35), ("rapier/Humanoid-v0", 0.8)])
def test_a_robot_at_rest_stands(name, least):
    env = gymnasium.make(name)
    env.reset(seed=0)
    still = np.zeros(env.action_space.shape, np.float32)
    for _ in range(40):
        observation, _, terminated, _, _ = env.step(still)
        assert not terminated
    assert observation[0] > least
    # Joints stay near the targets of their motors.
    joints = env.action_space.shape[0]
    assert np.abs(observation[11 : 11 + joints]).max() < 0.3


def test_an_ant_with_a_gait_walks():
    env = gymnasium.make("rapier/Ant-v0")
    env.reset(seed=0)
    # Diagonal legs move together: forwards in the air, and backwards on the ground. The legs are at +x+z, -x+z, -x-z and +x-z.
    phases, swing = np.array([0.0, np.pi, 0.0, np.pi]), np.array([1.0, 1.0, -1.0, -1.0])
    action = np.zeros(8, np.float32)
    for step in range(120):
        phase = 0.6 * step + phases
        action[0::2], action[1::2] = swing * np.sin(phase), np.cos(phase)
        _, _, terminated, _, _ = env.step(action)
        assert not terminated
    torso = env.unwrapped.task.of(env.unwrapped.task.torso)[0]
    assert np.hypot(torso[0], torso[2]) > 0.5


def test_a_reacher_that_follows_the_way_gets_near():
    env = gymnasium.make("rapier/Reacher-v0")
    for seed in range(3):
        observation, _ = env.reset(seed=seed)
        task = env.unwrapped.task
        for _ in range(150):
            # The transposed Jacobian, by finite differences of the forward kinematics.
            angles = observation[[0, 2, 4]].astype(float)
            action = np.clip(jacobian(angles).T @ (observation[6:9] - tip(angles)) * 8.0, -1, 1)
            observation, reward, _, _, _ = env.step(action.astype(np.float32))
        assert np.linalg.norm(task.way()[0]) < 0.05


def tip(angles):
    """The tip of the arm by its angles."""
    base, shoulder, elbow = angles
    out, height = 0.0, 0.4
    for angle in (shoulder, shoulder + elbow):
        out, height = out - 0.45 * np.sin(angle), height + 0.45 * np.cos(angle)
    return np.array([out * np.cos(base), height, -out * np.sin(base)])


def jacobian(angles):
    steps = 1e-4 * np.eye(3)
    return np.stack([(tip(angles + step) - tip(angles - step)) / 2e-4 for step in steps], axis=1)


def test_a_car_that_steers_to_the_flag_reaches_it():
    env = gymnasium.make("rapier/Car-v0")
    reached = 0
    for seed in range(4):
        observation, _ = env.reset(seed=seed)
        total, over = 0.0, False
        while not over:
            ahead, left = observation[14:16]
            speed = observation[6]
            action = np.array([np.clip(0.5 * (6.0 - speed), -1, 1), np.clip(2.0 * np.arctan2(left, ahead), -1, 1)], np.float32)
            observation, reward, terminated, truncated, _ = env.step(action)
            total, over = total + reward, terminated or truncated
        reached += total > 20
    assert reached >= 3


def test_a_striker_scores():
    env = gymnasium.make("rapier/Soccer-v0")
    goals = 0
    for seed in range(6):
        observation, _ = env.reset(seed=seed)
        over = False
        while not over:
            robot, ball = observation[0:2], observation[4:6]
            keeper = observation[10]
            # From behind the ball, at the corner of the goal far from the keeper.
            aim = np.array([6.3, -0.8 if keeper > 0 else 0.8])
            direction = (aim - ball) / np.linalg.norm(aim - ball)
            behind = ball - 0.55 * direction
            offset = robot - ball
            side = offset - (offset @ direction) * direction
            ready = offset @ direction < -0.2 and np.linalg.norm(side) < 0.2
            target = ball + direction if ready else behind + (0.7 * side / (np.linalg.norm(side) + 1e-6) if offset @ direction > -0.2 else 0)
            way = target - robot
            action = np.clip(way * (3.0 if not ready else 10.0), -1, 1)
            observation, reward, terminated, truncated, _ = env.step(action.astype(np.float32))
            over = terminated or truncated
        goals += reward > 10
    assert goals >= 2


@pytest.mark.parametrize("name", IDS)
def test_it_renders(name):
    env = gymnasium.make(name, render_mode="rgb_array")
    env.reset(seed=0)
    picture = env.render()
    assert picture.shape == (360, 640, 3) and len(np.unique(picture)) > 20
