"""The learner of examples/python/learning: gradients, advantages, files, and that it learns."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

folder = Path(__file__).resolve().parents[3] / "examples/python/learning"
sys.path.insert(0, str(folder))

import murosimf.envs  # noqa: E402
from murosimf.envs.tasks import make_task  # noqa: E402
from networks import Adam, Mlp  # noqa: E402
from ppo import Learner, Policy, Scale, Settings, advantages, log_density, policy_slopes  # noqa: E402

import murosimf as ms  # noqa: E402


def differences(loss, array, step=1e-6):  # type: ignore[no-untyped-def]
    """Central finite differences of loss() by the numbers of an array."""
    slopes = np.zeros_like(array)
    for place in np.ndindex(array.shape):
        kept = array[place]
        array[place] = kept + step
        above = loss()
        array[place] = kept - step
        slopes[place] = (above - loss()) / (2 * step)
        array[place] = kept
    return slopes


def test_gradients_of_a_network() -> None:
    random = np.random.default_rng(1)
    network = Mlp((3, 5, 4, 2), random, dtype=np.float64)
    x, wanted = random.normal(size=(7, 3)), random.normal(size=(7, 2))
    y, kept = network.forward(x)
    gradients = network.backward(kept, y - wanted)
    for parameter, gradient in zip(network.parameters, gradients, strict=True):
        assert gradient == pytest.approx(differences(lambda: 0.5 * np.sum((network(x) - wanted) ** 2), parameter), abs=1e-6)


def test_gradients_of_the_policy_loss() -> None:
    random = np.random.default_rng(2)
    settings = Settings(entropy=0.01)
    actions, means = random.normal(size=(9, 3)), random.normal(size=(9, 3))
    deviation, gains = random.normal(size=3) * 0.3, random.normal(size=9)
    old = log_density(actions, means + 0.05 * random.normal(size=means.shape), deviation)
    ratio = np.exp(log_density(actions, means, deviation) - old)
    assert (np.abs(ratio - 1) > settings.clip).any()  # some are clipped
    assert (np.abs(ratio - 1) < settings.clip).any()
    by_means, by_deviation, _ = policy_slopes(actions, means, deviation, old, gains, settings)

    def loss() -> float:
        return float(policy_slopes(actions, means, deviation, old, gains, settings)[2])

    assert by_means == pytest.approx(differences(loss, means), abs=1e-6)
    assert by_deviation == pytest.approx(differences(loss, deviation), abs=1e-6)


def test_density_is_that_of_normal_distributions() -> None:
    """Differences of exponents, by the closed form of one dimension."""
    log_deviation = np.log([0.5])
    a, b = (log_density(np.array([[x]]), np.zeros((1, 1)), log_deviation)[0] for x in (0.0, 1.0))
    assert a - b == pytest.approx(1 / (2 * 0.5**2))
    assert a == pytest.approx(-np.log(0.5))


def test_advantages_are_the_direct_sum() -> None:
    """Sum of (discount trace)^k errors up to the end of the episode, each step for itself."""
    random = np.random.default_rng(3)
    steps, n, discount, trace = 12, 5, 0.9, 0.8
    rewards, values = random.normal(size=(steps, n)), random.normal(size=(steps + 1, n))
    ends, breaks = random.random((steps, n)) < 0.15, random.random((steps, n)) < 0.15
    found = advantages(rewards, values, ends, breaks, discount, trace)
    for world in range(n):
        for step in range(steps):
            total, weight = 0.0, 1.0
            for later in range(step, steps):
                following = 0.0 if ends[later, world] else values[later + 1, world]
                total += weight * (rewards[later, world] + discount * following - values[later, world])
                weight *= discount * trace
                if ends[later, world] or breaks[later, world]:
                    break
            assert found[step, world] == pytest.approx(total)


def test_adam_makes_its_first_step_of_the_rate() -> None:
    """After one step mean and square are unbiased: each number moves by the rate against its slope (the paper, section 2)."""
    parameter = np.zeros(3)
    Adam([parameter], 0.01).step([np.array([0.5, -0.2, 0.1])])
    assert parameter == pytest.approx([-0.01, 0.01, -0.01], rel=1e-3)


def test_scale_joins_samples() -> None:
    rows = np.random.default_rng(4).normal(3, 2, (500, 2))
    scale = Scale(2)
    for part in np.array_split(rows, 7):
        scale.learn(part)
    assert scale.mean == pytest.approx(rows.mean(axis=0), rel=1e-5)
    assert scale.square == pytest.approx(rows.var(axis=0), rel=1e-4)


class Pendulum:
    """Upside down, of 1 m, for n at once, as vector environments of Gymnasium are (NEXT_STEP): observations are angle and rate,
    the action is a torque [5 N m], a reward of 1 for each step, and over 0.5 rad it has fallen. Left alone it falls at once."""

    num_envs = 16
    late = 100  # [steps] of 0.05 s

    def reset(self, seed: int):  # type: ignore[no-untyped-def]
        self.random = np.random.default_rng(seed)
        self.ended = np.ones(self.num_envs, bool)
        self.state, self.steps = np.zeros((self.num_envs, 2)), np.zeros(self.num_envs, int)
        self._begin()
        return self.state.astype(np.float32), {}

    def _begin(self) -> None:
        self.state[self.ended] = self.random.uniform(-0.1, 0.1, (self.ended.sum(), 2))
        self.steps[self.ended] = 0

    def step(self, actions: np.ndarray):  # type: ignore[no-untyped-def]
        begun = self.ended
        self.state[:, 1] += 0.05 * (9.81 * np.sin(self.state[:, 0]) + 5 * np.clip(actions[:, 0], -1, 1))
        self.state[:, 0] += 0.05 * self.state[:, 1]
        self.steps += 1
        self._begin()
        fallen = (np.abs(self.state[:, 0]) > 0.5) & ~begun
        late = (self.steps >= self.late) & ~fallen & ~begun
        self.ended = fallen | late
        return self.state.astype(np.float32), np.where(begun | fallen, 0.0, 1.0), fallen, late, {}


def learned(updates: int) -> tuple[float, float, np.ndarray]:
    """Mean lengths of the episodes that ended in the first and in the last five updates, and the policy's numbers."""
    settings = Settings(hidden=(16,), deviation=0.5, rate=3e-3)
    learner = Learner(Pendulum(), Policy(2, 1, settings, 1), settings, 1)
    lengths = []
    for _ in range(updates):
        samples, ended = learner.collect()
        learner.update(samples)
        lengths.append([length for _, length, _ in ended])
    first, last = (float(np.mean(np.concatenate(part))) for part in (lengths[:5], lengths[-5:]))
    return first, last, np.concatenate([each.ravel() for each in learner.policy.parameters()])


def test_it_learns_to_balance_and_does_so_again() -> None:
    first, last, parameters = learned(60)
    assert first < 30  # steps
    assert last > 3 * first
    assert np.isfinite(parameters).all()
    assert (learned(5)[2] == learned(5)[2]).all()


def test_onnx_files_are_the_policy(tmp_path: Path) -> None:
    onnx = pytest.importorskip("onnx")
    from onnx.reference import ReferenceEvaluator
    from onnx_file import OnnxPolicy, write_onnx

    policy = Policy(47, 12, Settings(hidden=(16, 8)), 3)
    random = np.random.default_rng(5)
    policy.actor = Mlp((47, 16, 8, 12), random)
    rows = random.normal(1, 3, (20, 47)).astype(np.float32)
    policy.scale.learn(rows)
    write_onnx(policy, tmp_path / "walk.onnx")
    policy.save(tmp_path / "walk.npz")
    again = Policy(47, 12, Settings(hidden=(16, 8)), 4)
    again.load(tmp_path / "walk.npz")
    assert (again(rows) == policy(rows)).all()
    played = OnnxPolicy(tmp_path / "walk.onnx")(rows)
    assert played == pytest.approx(policy(rows), abs=1e-5)
    oracle = ReferenceEvaluator(onnx.load(str(tmp_path / "walk.onnx"))).run(None, {"observation": rows})[0]
    assert played == pytest.approx(oracle, abs=1e-5)
    model = onnx.load(str(tmp_path / "walk.onnx"))
    model.graph.node[0].op_type = "Relu"
    onnx.save(model, str(tmp_path / "other.onnx"))
    with pytest.raises(ValueError, match=r"other.onnx: node 'centered' is a Relu that is not played here"):
        OnnxPolicy(tmp_path / "other.onnx")


def test_the_controller_sees_what_the_environment_shows() -> None:
    """On its first call, at rest: gravity, joints, command and clock; the rates of a gyroscope are nearly 0."""
    from play_walk import LearnedWalk

    seen = []

    def policy(rows: np.ndarray) -> np.ndarray:
        seen.append(rows[0])
        return np.zeros((1, 12), np.float32)

    scene = ms.Scene.of_robot("kid21")
    scene.robot.controller = LearnedWalk(policy, make_task("WalkVelocity", {}), (0.2, 0.0, 0.1))
    scene.run(0.1)
    env = gymnasium.make("murosimf/WalkVelocity-v0", level="articulated_dynamics").unwrapped
    env.task.begin(env.memory, 0, np.random.default_rng(0))
    env.memory.command[0], env.memory.phase[0] = (0.2, 0.0, 0.1), 0
    assert len(seen) == 5
    assert seen[0] == pytest.approx(env.task.observe(env._motion(), env.memory)[0], abs=0.05)
    assert seen[4][-2:] == pytest.approx([np.sin(4 * 2 * np.pi / 24), np.cos(4 * 2 * np.pi / 24)], abs=1e-6)


def test_the_script_trains_exports_and_plays(tmp_path: Path) -> None:
    pytest.importorskip("onnx")
    run = [sys.executable, str(folder / "train_walk.py"), "--out", str(tmp_path), "--updates", "2", "--worlds", "4",
           "--threads", "1"]
    subprocess.run(run, check=True, capture_output=True)
    more = ["--stage", "articulated", "--start", str(tmp_path / "walk_simplified.npz")]
    subprocess.run([*run, *more], check=True, capture_output=True)
    play = [sys.executable, str(folder / "play_walk.py"), str(tmp_path / "walk.onnx"), "--seconds", "0.5"]
    done = subprocess.run(play, check=True, capture_output=True, text=True)
    assert done.stdout.startswith("articulated_dynamics: ")
    assert "in 0.5 s" in done.stdout
