"""The environment of PettingZoo: two teams with a ball."""

import numpy as np
import pytest

pytest.importorskip("pettingzoo")

from murosimf.envs.teams import Teams, goal  # noqa: E402

import murosimf as ms  # noqa: E402


def test_passes_the_tests_of_pettingzoo() -> None:
    from pettingzoo.test import parallel_api_test, parallel_seed_test

    parallel_api_test(Teams(2, seconds=3.0), num_cycles=50)
    parallel_seed_test(lambda: Teams(2, seconds=3.0))


def test_observations_are_in_axes_of_the_robot() -> None:
    env = Teams(1)
    rows, _ = env.reset(seed=3)
    robot = env.scene["red1"]
    heading = np.arctan2(robot.orientation[1, 0], robot.orientation[0, 0])
    ball = np.array(env.scene.entity("ball").position[:2])
    distance = ball - robot.position[:2]
    angle = np.arctan2(distance[1], distance[0]) - heading
    wanted = np.linalg.norm(distance) * np.array([np.cos(angle), np.sin(angle)])
    assert rows["red1"][:2] == pytest.approx(wanted, abs=1e-6)
    attacked = np.array([-3.0, 0.0]) - robot.position[:2]
    assert np.linalg.norm(rows["red1"][4:6]) == pytest.approx(np.linalg.norm(attacked), abs=1e-6)


def test_commands_move_and_the_ball_pays() -> None:
    env = Teams(1)
    env.reset(seed=1)
    start = np.array(env.scene["blue1"].position)
    actions = {"blue1": np.array([1, 0, 0], np.float32), "red1": np.zeros(3, np.float32)}
    env.scene.entity("ball").linear_velocity = (1, 0, 0)
    before = env.scene.entity("ball").position[0]
    rewards = [env.step(actions)[1] for _ in range(10)]
    moved = env.scene.entity("ball").position[0] - before
    assert moved > 0.05
    assert sum(each["blue1"] for each in rewards) == pytest.approx(moved, abs=1e-9)
    assert sum(each["red1"] for each in rewards) == pytest.approx(-moved, abs=1e-9)
    assert np.linalg.norm(env.scene["blue1"].position - start) > 0.05


def test_a_goal_ends_it() -> None:
    env = Teams(1)
    env.reset(seed=1)
    env.scene.entity("ball").position = (2.9, 0.0, 0.065)
    env.scene.entity("ball").linear_velocity = (3, 0, 0)
    _, rewards, ended, _, infos = env.step({name: np.zeros(3, np.float32) for name in env.agents})
    assert ended == {"blue1": True, "red1": True}
    assert rewards["blue1"] > 10
    assert rewards["red1"] < -10
    assert infos["blue1"]["goal"] == 1
    assert env.agents == []
    assert (goal(3.1, 0.8), goal(-3.1, 0.7), goal(2.9, 0.0)) == (0, -1, 0)


def test_wrong_sizes_are_said() -> None:
    with pytest.raises(ms.InputError, match="1 to 4 robots, not 5"):
        Teams(5)
