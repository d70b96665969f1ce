"""Proximal policy optimization in NumPy (Schulman et al., arXiv:1707.06347), for vector environments of Gymnasium that begin
again in the step after an end (AutoresetMode.NEXT_STEP)."""

from dataclasses import dataclass

import numpy as np
from networks import Adam, Mlp


@dataclass
class Settings:
    steps: int = 32  #: of each environment between two updates
    epochs: int = 4
    parts: int = 4  #: minibatches of an epoch
    discount: float = 0.99
    trace: float = 0.95  #: lambda of the advantage estimate
    clip: float = 0.2
    entropy: float = 0.0  #: weight of the policy's entropy
    rate: float = 1e-3  #: of Adam at the start
    divergence: float = 0.02  #: wanted mean KL divergence of an update: the rate follows it (Rudin et al., CoRL 2021, section 3)
    hidden: tuple[int, ...] = (128, 64)
    deviation: float = 0.06  #: of actions at the start


class Scale:
    """Running mean and variance of observations (Chan et al., 1979: variances of two samples joined)."""

    def __init__(self, size):
        self.count, self.mean, self.square = 1e-4, np.zeros(size), np.ones(size)

    def learn(self, rows):
        mean, square, count = rows.mean(axis=0, dtype=np.float64), rows.var(axis=0, dtype=np.float64), len(rows)
        total = self.count + count
        change = mean - self.mean
        self.square = (self.square * self.count + square * count + change**2 * self.count * count / total) / total
        self.mean, self.count = self.mean + change * count / total, total

    def __call__(self, rows):
        return np.clip((rows - self.mean) / np.sqrt(self.square + 1e-4), -10, 10).astype(np.float32)


class Policy:
    """Actions are normal with means of a network and a deviation for each."""

    def __init__(self, observations, actions, settings, seed):
        random = np.random.default_rng(seed)
        self.scale = Scale(observations)
        self.actor = Mlp((observations, *settings.hidden, actions), random, 0.01)
        self.critic = Mlp((observations, *settings.hidden, 1), random)
        self.log_deviation = np.full(actions, np.log(settings.deviation), np.float32)

    def __call__(self, observations):
        """Means, without chance."""
        return self.actor(self.scale(observations))

    def parameters(self):
        return [*self.actor.parameters, self.log_deviation, *self.critic.parameters]

    def save(self, file):
        np.savez(file, *self.parameters(), self.scale.mean, self.scale.square, self.scale.count)

    def load(self, file):
        stored = list(np.load(file).values())
        for parameter, value in zip(self.parameters(), stored, strict=False):
            parameter[:] = value
        self.scale.mean, self.scale.square, self.scale.count = stored[-3], stored[-2], float(stored[-1])


def log_density(actions, means, log_deviation):
    """(n,) of a normal distribution, without its constant."""
    return -0.5 * np.sum(((actions - means) / np.exp(log_deviation)) ** 2, axis=1) - np.sum(log_deviation)


def advantages(rewards, values, ends, breaks, discount, trace):
    """Generalized advantage estimation (Schulman et al., arXiv:1506.02438, equation 16). (steps, n) arrays, `values` of one step
    more; `ends`: nothing follows; `breaks`: an episode ends, or a sample is void, and the sum goes no further."""
    result = np.zeros_like(rewards)
    ahead = np.zeros(rewards.shape[1], rewards.dtype)
    for step in reversed(range(len(rewards))):
        error = rewards[step] + discount * values[step + 1] * ~ends[step] - values[step]
        ahead = error + discount * trace * ahead * ~(ends[step] | breaks[step])
        result[step] = ahead
    return result


def policy_slopes(actions, means, log_deviation, old, gains, settings):
    """Derivatives of the clipped loss and entropy (equations 7 and 9) by means (n, actions) and log_deviation (actions,), and
    the loss."""
    ratio = np.exp(log_density(actions, means, log_deviation) - old)
    plain, clipped = ratio * gains, np.clip(ratio, 1 - settings.clip, 1 + settings.clip) * gains
    weight = (np.where(plain <= clipped, -plain, 0) / len(gains))[:, None]
    error = (actions - means) / np.exp(log_deviation)
    by_means = weight * error / np.exp(log_deviation)
    by_deviation = np.sum(weight * (error**2 - 1), axis=0) - settings.entropy
    loss = -np.mean(np.minimum(plain, clipped)) - settings.entropy * np.sum(log_deviation)
    return by_means, by_deviation, loss


class Learner:
    def __init__(self, env, policy, settings, seed):
        self.env, self.policy, self.settings = env, policy, settings
        self.random = np.random.default_rng(seed)
        self.adam = Adam(policy.parameters(), settings.rate)
        self.rows, _ = env.reset(seed=seed)
        self.void = np.zeros(env.num_envs, bool)  # the environment begins again in this step
        self.returns = np.zeros(env.num_envs)
        self.lengths = np.zeros(env.num_envs, int)

    def collect(self):
        """Samples of some steps, and (returns, lengths, falls) of the episodes that ended."""
        observations, actions, rewards, ends, breaks, voids, ended = [self.rows], [], [], [], [], [], []
        for _ in range(self.settings.steps):
            means = self.policy(self.rows)
            chosen = means + np.exp(self.policy.log_deviation) * self.random.standard_normal(means.shape, np.float32)
            self.rows, reward, end, late, _ = self.env.step(chosen)
            self.returns += reward
            self.lengths += ~self.void
            done = end | late
            ended += zip(self.returns[done], self.lengths[done], end[done], strict=True)
            self.returns[done], self.lengths[done] = 0, 0
            for kept, value in zip((observations, actions, rewards, ends, breaks, voids),
                                   (self.rows, chosen, reward, end, late | self.void, self.void), strict=True):
                kept.append(value)
            self.void = done
        return [np.array(each) for each in (observations, actions, rewards, ends, breaks, voids)], ended

    def update(self, samples):
        """One update of the policy; the mean KL divergence of the last epoch."""
        observations, actions, rewards, ends, breaks, voids = samples
        policy, settings = self.policy, self.settings
        policy.scale.learn(observations.reshape(-1, observations.shape[-1]))
        inputs = policy.scale(observations)
        values = policy.critic(inputs.reshape(-1, inputs.shape[-1])).reshape(len(inputs), -1)
        gains = advantages(rewards.astype(np.float32), values, ends, breaks, settings.discount, settings.trace)
        kept = ~voids.ravel()
        targets = (gains + values[:-1]).ravel()[kept]
        gains = gains.ravel()[kept]
        gains = (gains - gains.mean()) / (gains.std() + 1e-8)
        inputs = inputs[:-1].reshape(-1, inputs.shape[-1])[kept]
        actions = actions.reshape(-1, actions.shape[-1])[kept]
        means, deviation = policy.actor(inputs), policy.log_deviation.copy()
        old = log_density(actions, means, deviation)
        for _ in range(settings.epochs):
            for part in np.array_split(self.random.permutation(len(gains)), settings.parts):
                self._descend(inputs[part], actions[part], old[part], gains[part], targets[part])
        return self._adapt(inputs, means, deviation)

    def _descend(self, inputs, actions, old, gains, targets):
        policy = self.policy
        means, kept = policy.actor.forward(inputs)
        by_means, by_deviation, _ = policy_slopes(actions, means, policy.log_deviation, old, gains, self.settings)
        values, kept_values = policy.critic.forward(inputs)
        by_values = (values - targets[:, None]) / len(targets)
        self.adam.step([*policy.actor.backward(kept, by_means), by_deviation, *policy.critic.backward(kept_values, by_values)])

    def _adapt(self, inputs, means, deviation):
        now, now_deviation = self.policy.actor(inputs), self.policy.log_deviation
        divergence = float(np.mean(np.sum(now_deviation - deviation + (np.exp(2 * deviation) + (means - now) ** 2)
                                          / (2 * np.exp(2 * now_deviation)) - 0.5, axis=1)))
        if divergence > 2 * self.settings.divergence:
            self.adam.rate = max(self.adam.rate / 1.5, 1e-5)
        elif divergence < self.settings.divergence / 2:
            self.adam.rate = min(self.adam.rate * 1.5, 3e-3)
        return divergence
