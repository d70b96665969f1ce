"""Environments of Gymnasium."""

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import murosimf.envs  # noqa: E402
from murosimf.envs.velocity_task import in_base_axes  # noqa: E402


def episode_of(env, seed: int, steps: int = 30):  # type: ignore[no-untyped-def]
    rows = [env.reset(seed=seed)[0]]
    random = np.random.default_rng(seed)
    total = 0.0
    for _ in range(steps):
        observation, reward, ended, late, _ = env.step(random.uniform(-1, 1, env.action_space.shape).astype(np.float32))
        rows.append(observation)
        total += np.sum(reward)
        if np.any(ended):
            break
    return np.concatenate([np.ravel(row) for row in rows]), total


def test_passes_the_checker_of_gymnasium() -> None:
    from gymnasium.utils.env_checker import check_env

    env = gymnasium.make("murosimf/WalkVelocity-v0")
    check_env(env.unwrapped, skip_render_check=True)


def test_seeds_decide() -> None:
    env = gymnasium.make("murosimf/WalkVelocity-v0")
    first, second, other = episode_of(env, 5), episode_of(env, 5), episode_of(env, 6)
    assert (first[0] == second[0]).all()
    assert first[1] == second[1]
    assert first[0].shape != other[0].shape or (first[0] != other[0]).any()
    again = episode_of(gymnasium.make("murosimf/WalkVelocity-v0"), 5)
    assert (again[0] == first[0]).all()


def test_standing_still_is_worth_most_without_a_command() -> None:
    env = gymnasium.make("murosimf/WalkVelocity-v0").unwrapped
    rewards = {}
    for command in ((0.0, 0.0, 0.0), (0.3, 0.0, 0.0)):
        env.reset(seed=1, options={"command": command})
        for _ in range(25):
            _, reward, ended, _, _ = env.step(np.zeros(env.action_space.shape, np.float32))
        assert not ended
        rewards[command] = reward
    assert rewards[0.0, 0.0, 0.0] > 0.95
    assert rewards[0.3, 0.0, 0.0] < 0.35


def test_a_vector_is_many_of_one() -> None:
    vector = gymnasium.make_vec("murosimf/WalkVelocity-v0", num_envs=4, vectorization_mode="vector_entry_point", threads=2)
    assert isinstance(vector.unwrapped, murosimf.envs.WalkVelocityVector)
    one, _ = vector.reset(seed=3)
    assert vector.observation_space.contains(one)
    env = gymnasium.make("murosimf/WalkVelocity-v0").unwrapped
    for world in range(4):
        alone, _ = env.reset(seed=0, options={"command": vector.unwrapped._commands[world]})
        assert alone == pytest.approx(one[world], abs=1e-6)
    assert (episode_of(vector, 3)[0] == episode_of(vector, 3)[0]).all()
    ended = begun = 0
    vector.reset(seed=1)
    before = np.zeros(4, bool)
    for _ in range(150):
        observation, _, fallen, late, _ = vector.step(np.ones((4, vector.single_action_space.shape[0]), np.float32))
        assert not (fallen & before).any()
        begun += (before & (np.abs(observation[:, -vector.single_action_space.shape[0]:]) == 0).all(axis=1)).sum()
        before = fallen | late
        ended += before.sum()
    assert ended > 0
    assert begun >= ended - 4
    vector.close()


def test_turns_vectors_as_matrices_do() -> None:
    quaternion = np.array([[0.5, 0.5, 0.5, 0.5], [np.cos(0.2), 0, 0, np.sin(0.2)]])  # x -> y -> z -> x; 0.4 rad about z
    turned = in_base_axes(quaternion, np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]))
    assert turned == pytest.approx(np.array([[1, 0, 0], [np.cos(0.4), -np.sin(0.4), 0]]))
