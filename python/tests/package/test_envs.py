"""Environments of Gymnasium: one robot, and many in a batch."""

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import murosimf.envs  # noqa: E402
from murosimf.envs.motion import in_base_axes  # noqa: E402

import murosimf as ms  # noqa: E402

names = sorted(murosimf.envs.tasks)


def make(task: str, **settings):  # type: ignore[no-untyped-def]
    return gymnasium.make(f"murosimf/{task}-v0", **settings)


def make_vector(task: str, n: int, **settings):  # type: ignore[no-untyped-def]
    return gymnasium.make_vec(f"murosimf/{task}-v0", num_envs=n, vectorization_mode="vector_entry_point", **settings)


def episode_of(env, seed: int, steps: int = 60):  # type: ignore[no-untyped-def]
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


@pytest.mark.parametrize("task", names)
def test_passes_the_checker_of_gymnasium(task: str) -> None:
    from gymnasium.utils.env_checker import check_env

    env = make(task).unwrapped
    check_env(env, skip_render_check=True)
    entries = env.task.entries()
    assert env.observation_space.shape == (len(entries),)
    assert len({name for name, _ in entries}) == len(entries)


@pytest.mark.parametrize("task", names)
def test_seeds_decide(task: str) -> None:
    env = make(task)
    first, second, other = episode_of(env, 5), episode_of(env, 5), episode_of(env, 6)
    assert (first[0] == second[0]).all()
    assert first[1] == second[1]
    assert first[0].shape != other[0].shape or (first[0] != other[0]).any()
    again = episode_of(make(task), 5)
    assert (again[0] == first[0]).all()


@pytest.mark.parametrize("task", names)
def test_a_vector_gives_the_same_for_any_number_of_threads(task: str) -> None:
    one, two = make_vector(task, 3), make_vector(task, 3, threads=2)
    assert two.observation_space.contains(two.reset(seed=1)[0])
    assert (episode_of(one, 3)[0] == episode_of(two, 3)[0]).all()
    assert (episode_of(one, 3)[0] == episode_of(one, 3)[0]).all()


def test_a_vector_of_one_is_the_single_environment() -> None:
    """Both begin from the same seed of the scene, because both draw it first."""
    vector, env = make_vector("WalkVelocity", 1), make("WalkVelocity")
    alone, many = env.reset(seed=4)[0], vector.reset(seed=4)[0]
    assert many[0] == pytest.approx(alone, abs=1e-6)
    action = np.full(env.action_space.shape, 0.2, np.float32)
    for _ in range(20):
        single, reward, *_ = env.step(action)
        rows, rewards, *_ = vector.step(action[None])
        assert rows[0] == pytest.approx(single, abs=1e-6)
        assert rewards[0] == pytest.approx(reward, abs=1e-9)


def test_worlds_that_ended_begin_again_in_the_next_step() -> None:
    vector = make_vector("WalkVelocity", 4, threads=2)
    vector.reset(seed=1)
    size = vector.single_action_space.shape[0]
    before, ended, begun = np.zeros(4, bool), 0, 0
    for _ in range(150):
        observation, reward, fallen, late, _ = vector.step(np.ones((4, size), np.float32))
        assert not ((fallen | late) & before).any()
        assert (reward[before] == 0).all()
        assert (np.abs(observation[before][:, 30:42]) == 0).all()  # action.*: none yet
        begun += before.sum()
        before = fallen | late
        ended += before.sum()
    assert ended > 0
    assert begun >= ended - 4


def test_standing_still_is_worth_most_without_a_command() -> None:
    env = make("Stand").unwrapped
    env.reset(seed=1)
    for _ in range(50):
        _, reward, ended, _, _ = env.step(np.zeros(env.action_space.shape, np.float32))
    assert not ended
    assert reward > 0.95


def test_velocities_decide_what_walking_is_worth() -> None:
    """By the formula of the docstring, for a robot that stands, moves forward and turns as one body."""
    env = make("WalkVelocity").unwrapped
    env.reset(seed=1, options={"command": (0.3, 0.0, 0.2)})
    none = np.zeros((1, 12), np.float32)
    still = env._motion()
    still.quaternion[:], still.linear_velocity[:], still.angular_velocity[:] = (1, 0, 0, 0), 0, 0
    worth = {}
    for speed, turning in ((0.0, 0.0), (0.3, 0.2), (0.15, 0.2)):
        still.linear_velocity[0, 0], still.angular_velocity[0, 2] = speed, turning
        worth[speed, turning] = env.task.reward(still, env.memory, none)[0]
    assert worth[0.3, 0.2] == pytest.approx(1)
    assert worth[0.0, 0.0] == pytest.approx(0.7 * np.exp(-4) + 0.3 * np.exp(-0.16))
    assert worth[0.15, 0.2] == pytest.approx(0.7 * np.exp(-1) + 0.3)
    still.quaternion[:] = (np.cos(0.1), 0, np.sin(0.1), 0)  # leans forward by 0.2 rad, at rest
    still.linear_velocity[:], still.angular_velocity[:], env.memory.command[:] = 0, 0, 0
    assert env.task.reward(still, env.memory, none)[0] == pytest.approx(1 - np.sin(0.2) ** 2)
    still.fallen[:] = True
    assert env.task.reward(still, env.memory, none)[0] == -5


@pytest.mark.parametrize("command", [(0.2, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.5)])
def test_the_nominal_gait_swings_as_the_command_says(command: tuple[float, float, float]) -> None:
    """A foot that stands goes back with the velocity: 2 a in half a period, seen from the base, by the robot's kinematics."""
    env = make("WalkVelocity").unwrapped
    task, kinematics = env.task, env.scene.robot.kinematics
    memory = task.memory(2)
    memory.command[:] = command
    memory.phase[:] = np.pi, 2 * np.pi  # the left foot lands, and leaves
    frames = [kinematics.fk(row, "l_sole") for row in task.reference(memory)]
    way = frames[0].position - frames[1].position
    wanted = np.array(command) * task.period / 2
    assert way[:2] == pytest.approx(wanted[:2], abs=0.2 * np.abs(wanted[:2]).max() + 0.003)
    headings = [2 * np.arctan2(frame.quaternion[3], frame.quaternion[0]) for frame in frames]
    assert headings[0] - headings[1] == pytest.approx(wanted[2], abs=0.01)
    for frame in frames:
        assert frame.quaternion[1:3] == pytest.approx([0, 0], abs=0.02)  # level
    with pytest.raises(ms.InputError, match="unknown option 'comand'"):
        env.reset(options={"comand": (0, 0, 0)})


def test_pushes_push() -> None:
    pushed, calm = make("PushRecovery"), make("Stand")
    zero = np.zeros(pushed.action_space.shape, np.float32)
    rows = {}
    for env in (pushed, calm):
        env.reset(seed=2)
        rows[env] = np.array([env.step(zero)[0] for _ in range(60)])
    assert (rows[pushed][:50] == rows[calm][:50]).all()
    assert (rows[pushed][51:] != rows[calm][51:]).any()


def test_a_ball_that_is_kicked_is_worth_something() -> None:
    env = make("Kick").unwrapped
    env.reset(seed=1)
    zero = np.zeros(env.action_space.shape, np.float32)
    assert env.step(zero)[1] == pytest.approx(0.1, abs=1e-3)
    env.scene.entity("ball").linear_velocity = (2, 0, 0)
    assert env.step(zero)[1] > 0.8
    env.scene.entity("ball").linear_velocity = (0, 2, 0)
    assert env.step(zero)[1] < 0.1


def test_lying_is_worth_less_than_standing() -> None:
    lying, standing = make("GetUp").unwrapped, make("Stand").unwrapped
    zero = np.zeros(lying.action_space.shape, np.float32)
    lying.reset(seed=1)
    reward = [lying.step(zero)[1] for _ in range(20)][-1]
    assert reward < 0.5
    standing.reset(seed=1)
    motion = standing._motion()
    assert lying.task.reward(motion, lying.memory, zero[None])[0] > 0.9


@pytest.mark.parametrize(("model", "soles"), [("booster_k1", ("left_sole", "right_sole")), ("kid21", ("l_sole", "r_sole"))])
def test_legs_of_other_robots(model: str, soles: tuple[str, str]) -> None:
    env = make("Stand", model=model, soles=soles, level="articulated_dynamics").unwrapped
    assert env.action_space.shape == (12,)
    kinematics, task = env.scene.robot.kinematics, env.task
    for sole in soles:
        straight, bent = (kinematics.fk(q, sole) for q in (task.start, task.posture))
        assert bent.position[2] > straight.position[2] + 0.01
        level = in_base_axes(bent.quaternion[None], np.array([[0.0, 0.0, 1.0]]))[0]
        assert level == pytest.approx([0, 0, 1], abs=1e-3)


def test_bad_names_are_said() -> None:
    with pytest.raises(ms.InputError, match="unknown task 'Jump'; known: Stand, WalkVelocity"):
        murosimf.envs.RobotEnv("Jump")
    with pytest.raises(ms.InputError, match="hip, knee and ankle"):
        murosimf.envs.RobotEnv("Stand", soles=("head.offset", "r_sole"))


def test_turns_vectors_as_matrices_do() -> None:
    quaternion = np.array([[0.5, 0.5, 0.5, 0.5], [np.cos(0.2), 0, 0, np.sin(0.2)]])  # x -> y -> z -> x; 0.4 rad about z
    turned = in_base_axes(quaternion, np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]))
    assert turned == pytest.approx(np.array([[1, 0, 0], [np.cos(0.4), -np.sin(0.4), 0]]))
