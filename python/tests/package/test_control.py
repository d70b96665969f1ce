"""Control software in Python."""

import gc
import traceback
import weakref

import numpy as np
import pytest

import murosimf as ms


class Wave:
    rate = 50.0

    def __init__(self) -> None:
        self.times: list[float] = []
        self.starts = 0
        self.felt = 0.0

    def start(self, robot: ms.Robot, time: float) -> None:
        self.starts += 1

    def __call__(self, robot: ms.Robot, time: float) -> None:
        self.times.append(time)
        self.felt = float(robot.sensors["imu"]["accelerometer"][2])
        robot.joint_target["j_l_upper_arm"] = 0.5 * np.sin(6 * time)


def test_is_called_at_its_rate_and_moves_the_robot(scene: ms.Scene) -> None:
    wave = Wave()
    scene.robot.controller = wave
    assert scene.robot.controller is wave
    scene.run(1.0)
    assert wave.times == pytest.approx(np.arange(50) / 50)
    assert wave.starts == 1
    assert wave.felt != 0
    assert scene.robot.joint_target["j_l_upper_arm"] == 0.5 * np.sin(6 * wave.times[-1])
    scene.reset()
    scene.run(0.1)
    assert wave.starts == 2
    scene.robot.controller = None
    assert scene.robot.controller is None
    scene.run(0.1)
    assert len(wave.times) == 55


def test_threads_do_not_matter() -> None:
    def by_controller(threads: int) -> int:
        free = {f"{team}{i}.controller": "none" for team in ("blue", "red") for i in (1, 2, 3)}
        scene = ms.Scene("three_on_three", threads=threads, set=free)
        for number, name in enumerate(scene.robots):
            def move(robot: ms.Robot, time: float, number: int = number) -> None:
                robot.joint_target[:] = 0.1 * np.sin(5 * time + number)

            scene[name].controller = move
        scene.run(0.3)
        return scene.state_hash

    assert by_controller(1) == by_controller(2)


def test_what_it_raises_ends_the_step_with_its_traceback(scene: ms.Scene) -> None:
    def fails(robot: ms.Robot, time: float) -> None:
        if time >= 0.2:
            raise ZeroDivisionError("nothing to divide by")

    scene.robot.controller = fails
    line = "the controller of 'robot' failed at 0.200 s: ZeroDivisionError: nothing to divide by"
    with pytest.raises(ms.SimulationError, match=line) as error:
        scene.run(1.0)
    assert isinstance(error.value.__cause__, ZeroDivisionError)
    assert "in fails" in "".join(traceback.format_exception(error.value))
    assert scene.time < 0.21
    scene.robot.controller = None
    scene.run(0.1)

    def interrupted(robot: ms.Robot, time: float) -> None:
        raise KeyboardInterrupt

    scene.robot.controller = interrupted
    with pytest.raises(KeyboardInterrupt):
        scene.run(1.0)


def test_waits_with_all_else_for_the_end_of_the_step(scene: ms.Scene) -> None:
    def meddles(robot: ms.Robot, time: float) -> None:
        scene.step()

    scene.robot.controller = meddles
    with pytest.raises(ms.SimulationError, match="a controller of this scene is being called"):
        scene.run(0.1)
    with pytest.raises(TypeError, match="cannot be called"):
        scene.robot.controller = 3  # type: ignore[assignment]
    walker = ms.Scene("walk", set={"walker.level": "simplified_dynamics"})
    with pytest.raises(ms.InputError, match="are written by"):
        walker.robot.controller = meddles
    assert walker.robot.controller is None


def test_scenes_with_controllers_go(scene: ms.Scene) -> None:
    wave = Wave()
    scene.robot.controller = wave
    scene.run(0.1)
    left = weakref.ref(wave)
    del wave, scene
    gc.collect()
    # the fixture of pytest holds the scene: another one shows that nothing else does
    other, second = ms.Scene.of_robot("kid21"), Wave()
    other.robot.controller = second
    other.run(0.1)
    gone = weakref.ref(second)
    del other, second
    gc.collect()
    assert left() is not None
    assert gone() is None


def test_batches_have_controllers_too() -> None:
    batch = ms.Batch("walk", 3, threads=2, set={"walker.controller": "none", "walker.level": "simplified_dynamics"})

    def fails(robot: ms.Robot, time: float) -> None:
        raise ValueError("no")

    batch[1].robot.controller = fails
    with pytest.raises(ms.SimulationError, match="ValueError: no"):
        batch.step()
