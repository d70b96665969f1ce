"""Batches against scenes alone."""

import numpy as np
import pytest

import murosimf as ms

FREE = {"walker.controller": "none", "walker.level": "simplified_dynamics"}


def alone(seed: int, targets: np.ndarray, steps: int) -> ms.Scene:
    scene = ms.Scene("walk", seed=seed, set=FREE)
    for target in targets:
        scene.robot.joint_target[:] = target
        scene.step(steps)
    return scene


@pytest.mark.parametrize("threads", [1, 2])
def test_every_world_is_a_scene_alone(threads: int) -> None:
    batch = ms.Batch("walk", 5, threads=threads, seed=11, set=FREE)
    q, v, fallen = batch.joint_position, batch.joint_velocity, batch.fallen
    targets = np.random.default_rng(0).uniform(-0.2, 0.2, (4, 5, batch.joints))
    for target in targets:
        batch.joint_target[:] = target
        batch.step(7)
    for world in range(5):
        scene = alone(11 + world, targets[:, world], 7)
        assert batch[world].state_hash == scene.state_hash
        assert (q[world] == scene.robot.joint_position).all()
        assert (v[world] == scene.robot.joint_velocity).all()
        assert (batch.position[world] == scene.robot.position).all()
        assert batch.quaternion[world] == pytest.approx(scene.robot.quaternion)
        assert (batch.linear_velocity[world] == scene.robot.linear_velocity).all()
        assert (batch.angular_velocity[world] == scene.robot.angular_velocity).all()
        assert fallen[world] == scene.robot.fallen


def test_targets_begin_where_the_robots_have_theirs() -> None:
    batch = ms.Batch("walk", 2, set=FREE)
    assert (batch.joint_target == batch[0].robot.joint_target).all()


def test_targets_are_those_of_controllers() -> None:
    walking = {"walker.level": "simplified_dynamics"}
    batch = ms.Batch("walk", 3, set=walking)
    targets = batch.joint_target
    for steps in (1, 49):
        batch.step(steps)
        for world in range(3):
            scene = ms.Scene("walk", seed=1 + world, set=walking)
            scene.step(steps if steps == 1 else 50)
            assert (targets[world] == scene.robot.joint_target).all()
    assert (targets != batch.joint_position).any()
    batch[1].robot.command(0.1)
    batch.step(30)
    assert (targets[1] == batch[1].robot.joint_target).all()
    batch.reset([True, False, False])
    assert (batch.joint_target[0] == ms.Scene("walk", seed=1, set=walking).robot.joint_target).all()
    targets[0, 0] = 0.3
    with pytest.raises(ms.InputError, match="are written by"):
        batch.step()
    batch.step()


def test_what_was_written_waits_for_the_next_step() -> None:
    batch = ms.Batch("walk", 2, set=FREE)
    batch.joint_target[0, 0] = 0.1
    batch.joint_target[1, 1] = 0.2
    assert batch.joint_target[0, 0] == 0.1 and batch.joint_target[1, 1] == 0.2
    batch.reset([True, False])
    assert batch.joint_target[0, 0] == batch.joint_position[0, 0] and batch.joint_target[1, 1] == 0.2
    batch.step(3)
    assert batch.joint_target[1, 1] == batch[1].robot.joint_target[1] == 0.2


def test_balls_and_pushes_of_worlds_that_stay_in_the_batch() -> None:
    free = {"robot.controller": "none", "robot.level": "articulated_dynamics"}
    batch = ms.Batch("kick", 9, seed=1, set=free, cameras=False)
    positions, velocities = batch.ball_position, batch.ball_velocity
    batch.push(-1, "torso", force=(40, 0, 0), duration=0.05, moment=(0, 0.1, 0))
    batch.step(80)
    for world in (0, 8):
        scene = ms.Scene("kick", seed=1 + world, set=free, cameras=False)
        if world == 8:
            scene.robot.push("torso", force=(40, 0, 0), duration=0.05, moment=(0, 0.1, 0))
        scene.step(80)
        assert (batch.position[world] == scene.robot.position).all()
        ball = scene.entity("ball")
        assert (positions[world] == ball.position).all()
        assert (velocities[world] == ball.linear_velocity).all()
    assert (batch.position[0] != batch.position[8]).any()
    with pytest.raises(IndexError, match="world 9 of a batch of 9"):
        batch.push(9, force=(1, 0, 0), duration=0.1)
    with pytest.raises(ms.UnknownName, match="no ball"):
        _ = ms.Batch("walk", 1, set=FREE).ball_position


def test_resets_chosen_worlds() -> None:
    batch = ms.Batch("walk", 3, set=FREE)
    begin = [batch[i].state_hash for i in range(3)]
    batch.joint_target += 0.1
    batch.step(20)
    moved = batch[2].state_hash
    batch.reset([True, False, False])
    assert batch[0].state_hash == begin[0]
    assert batch[2].state_hash == moved
    assert (batch.joint_target[0] == batch.joint_position[0]).all()
    batch.reset()
    assert [batch[i].state_hash for i in range(3)] == begin
    batch.reset(seed=40)
    assert batch[1].state_hash == ms.Scene("walk", seed=41, set=FREE).state_hash
    with pytest.raises(ms.InputError, match="an entry for each of 3 worlds"):
        batch.reset([True])


def test_mistakes() -> None:
    with pytest.raises(ms.InputError, match="no worlds"):
        ms.Batch("walk", 0)
    batch = ms.Batch("walk", 2, set=FREE)
    with pytest.raises(IndexError, match="world 2 of a batch of 2"):
        batch[2]
    batch.joint_target[0, 0] = np.inf
    with pytest.raises(ms.InputError, match="finite"):
        batch.step()
    batch.step()
