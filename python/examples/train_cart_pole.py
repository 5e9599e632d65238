"""Trains a policy for the cart-pole with PPO in one file, measures it, and records it as a moving picture.

    pip install rapier[envs] torch
    python python/examples/train_cart_pole.py --goal 475 --picture cart_pole.png

The program ends with an error if the mean return of 20 episodes stays below the goal. The learner is proximal policy optimisation (Schulman et al. 2017, "Proximal
Policy Optimization Algorithms") with generalised advantages (Schulman et al. 2016, "High-Dimensional Continuous Control Using Generalized Advantage Estimation").
"""

import argparse
import time

import gymnasium
import numpy as np
import torch
from torch import nn

import rapier
import rapier.envs  # noqa: F401 - registers the environments

WORLDS, STEPS, EPOCHS, BATCH = 32, 128, 4, 1024
DISCOUNT, SMOOTHING, CLIP, ENTROPY, VALUE, RATE = 0.99, 0.95, 0.2, 0.01, 0.5, 1.0e-3


def layers(outputs, scale):
    """Two hidden layers of 64. The last layer begins small."""
    last = nn.Linear(64, outputs)
    nn.init.orthogonal_(last.weight, scale)
    nn.init.zeros_(last.bias)
    return nn.Sequential(nn.Linear(4, 64), nn.Tanh(), nn.Linear(64, 64), nn.Tanh(), last)


class Agent(nn.Module):
    """A policy over two actions, and an estimate of the return."""

    def __init__(self):
        super().__init__()
        self.policy, self.value = layers(2, 0.01), layers(1, 1.0)
        self.scale = torch.tensor([1.0, 1.0, 5.0, 1.0])

    def forward(self, observations):
        scaled = observations * self.scale
        return torch.distributions.Categorical(logits=self.policy(scaled)), self.value(scaled).squeeze(-1)

    def best(self, observations):
        """The most probable actions."""
        with torch.no_grad():
            return self(torch.as_tensor(observations))[0].logits.argmax(-1).numpy()


def collect(agent, envs, observations):
    """Steps all worlds with the policy. Returns the samples, and the observations after them."""
    samples = {name: [] for name in ("observations", "actions", "chances", "values", "rewards", "dones")}
    for _ in range(STEPS):
        with torch.no_grad():
            policy, values = agent(observations)
            actions = policy.sample()
        following, rewards, terminated, truncated, infos = envs.step(actions.numpy())
        if truncated.any():
            # A truncated episode would go on: its reward contains the estimate of the rest.
            with torch.no_grad():
                rest = agent(torch.as_tensor(infos["final_obs"]))[1].numpy()
            rewards = rewards + DISCOUNT * rest * truncated
        record = (observations, actions, policy.log_prob(actions), values, torch.as_tensor(rewards).float(), torch.as_tensor(terminated | truncated).float())
        for place, value in zip(samples.values(), record):
            place.append(value)
        observations = torch.as_tensor(following)
    return {name: torch.stack(values) for name, values in samples.items()}, observations


def advantages_of(samples, last):
    """Generalised advantages."""
    advantages, carry = torch.zeros_like(samples["rewards"]), 0.0
    for step in reversed(range(STEPS)):
        goes_on = 1.0 - samples["dones"][step]
        error = samples["rewards"][step] + DISCOUNT * last * goes_on - samples["values"][step]
        carry = error + DISCOUNT * SMOOTHING * goes_on * carry
        advantages[step], last = carry, samples["values"][step]
    return advantages


def improve(agent, optimiser, samples, advantages):
    """One update of the policy and of the estimate."""
    flat = {name: values.flatten(0, 1) for name, values in samples.items()}
    advantages, returns = advantages.flatten(), (advantages + samples["values"]).flatten()
    for _ in range(EPOCHS):
        for part in torch.randperm(len(returns)).split(BATCH):
            policy, values = agent(flat["observations"][part])
            ratio = (policy.log_prob(flat["actions"][part]) - flat["chances"][part]).exp()
            gain = advantages[part]
            gain = (gain - gain.mean()) / (gain.std() + 1e-8)
            surrogate = torch.minimum(ratio * gain, ratio.clamp(1 - CLIP, 1 + CLIP) * gain).mean()
            loss = VALUE * (values - returns[part]).square().mean() - surrogate - ENTROPY * policy.entropy().mean()
            optimiser.zero_grad()
            loss.backward()
            nn.utils.clip_grad_norm_(agent.parameters(), 0.5)
            optimiser.step()


def make(count):
    """Worlds that step together."""
    return gymnasium.make_vec("rapier/CartPole-v0", num_envs=count, vectorization_mode="vector_entry_point")


def returns_of(agent, episodes, seed):
    """The returns of some episodes with the best actions."""
    envs = make(episodes)
    observations, returns, going = envs.reset(seed=seed)[0], np.zeros(episodes), np.ones(episodes, bool)
    while going.any():
        observations, rewards, terminated, truncated, _ = envs.step(agent.best(observations))
        returns += rewards * going
        going &= ~(terminated | truncated)
    return returns


def record(agent, path, seed=1234, stride=2):
    """Writes a moving picture of one episode."""
    env = gymnasium.make("rapier/CartPole-v0", render_mode="rgb_array")
    observation, _ = env.reset(seed=seed)
    animation = rapier.Animation(fps=50 // stride)
    for step in range(300):
        if step % stride == 0:
            animation.append(env.render())
        observation, _, terminated, _, _ = env.step(agent.best(observation))
        if terminated:
            break
    animation.save(path)


def train(goal, updates, seed):
    """Trains until the mean return of 20 episodes reaches the goal. Returns the agent and that mean."""
    torch.manual_seed(seed)
    # The networks are small: threads would wait for each other. The worlds use all cores.
    torch.set_num_threads(1)
    agent = Agent()
    optimiser = torch.optim.Adam(agent.parameters(), RATE, eps=1e-5)
    envs = make(WORLDS)
    observations, begin, mean = torch.as_tensor(envs.reset(seed=seed)[0]), time.perf_counter(), 0.0
    for update in range(1, updates + 1):
        samples, observations = collect(agent, envs, observations)
        with torch.no_grad():
            last = agent(observations)[1]
        improve(agent, optimiser, samples, advantages_of(samples, last))
        if update % 5 == 0:
            mean = returns_of(agent, 20, 10_000).mean()
            print(f"{update * STEPS * WORLDS:8} steps, {time.perf_counter() - begin:6.1f} s: mean return {mean:.1f}", flush=True)
            if mean >= goal:
                break
    return agent, mean


def main():
    parser = argparse.ArgumentParser(description="Trains a policy for the cart-pole.")
    parser.add_argument("--goal", type=float, default=475.0, help="mean return of 20 episodes to reach")
    parser.add_argument("--updates", type=int, default=100, help="most updates of the policy")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--picture", help="file of a moving picture of one episode")
    arguments = parser.parse_args()
    agent, mean = train(arguments.goal, arguments.updates, arguments.seed)
    if arguments.picture:
        record(agent, arguments.picture)
    if mean < arguments.goal:
        raise SystemExit(f"the mean return is {mean:.1f}, below the goal of {arguments.goal}")


if __name__ == "__main__":
    main()
