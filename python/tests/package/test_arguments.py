"""Wrong arguments of public calls: one line that names them, and an error of ours."""

from collections.abc import Callable
from typing import Any

import pytest

import murosimf as ms

lib: Any = ms  # of which types are wrong on purpose
#: the call, and what its error says
WRONG: list[tuple[Callable[[Any], object], str]] = [
    (lambda s: s.step(1.5), "Scene.step: steps takes a whole number, not 1.5"),
    (lambda s: s.step(2**70), "Scene.step: steps is out of range: 1180591620717411303424"),
    (lambda s: s.step("a"), "Scene.step: steps takes a whole number, not 'a'"),
    (lambda s: s.step(strides=1), "Scene.step: got an unexpected keyword argument 'strides'"),
    (lambda s: s.reset(seed=-1), "Scene.reset: seed is out of range: -1"),
    (lambda s: s.reset(2**64), "Scene.reset: seed is out of range: 18446744073709551616"),
    (lambda s: s.run("5"), "Scene.run: seconds takes a number, not '5'"),
    (lambda s: s.run(until=lambda s: True, at_most="x"), "Scene.run: at_most takes a number, not 'x'"),
    (lambda s: s.leave(3), "Scene.leave: name takes a text, not 3"),
    (lambda s: s.enter(None), "Scene.enter: name takes a text, not None"),
    (lambda s: s[3], "Scene.__getitem__: name takes a text, not 3"),
    (lambda s: s.entity(3), "Scene.entity: name takes a text, not 3"),
    (lambda s: s.load("x"), "Scene.load: state takes bytes, not 'x'"),
    (lambda s: s.change(5), "a setting is 'PATH=VALUE' or {'PATH': value}, not 5"),
    (lambda s: s.cast("abc", (0, 0, 1)), "numbers are needed, not 'abc'"),
    (lambda s: s.cast((0, 0, 1), (0, 0, -1), range="far"), "Scene.cast: range takes a number, not 'far'"),
    (lambda s: s.distance("robot", 4), "Scene.distance: b takes a text, not 4"),
    (lambda s: s.picture(width=2**40), "Scene.picture: width is out of range: 1099511627776"),
    (lambda s: s.picture(height=1.5), "Scene.picture: height takes a whole number, not 1.5"),
    (lambda s: s.record(3), "Recorder.__init__: file takes a text or a file, not 3"),
    (lambda s: s.record("a.mcap", rate="a"), "Recorder.__init__: rate takes a number, not 'a'"),
    (lambda s: s.show(web=True, speed=0), "speed = 0: above 0, up to 1e6, or None"),
    (lambda s: s.add_robot(3, "kid21"), "Scene.add_robot: name takes a text, not 3"),
    (lambda s: s.add_robot("b", 3), "Scene.add_robot: model takes a text or a file, not 3"),
    (lambda s: s.add_body("b", mass="1"), "Scene.add_body: mass takes a number, not '1'"),
    (lambda s: s.robot.command("a"), "Robot.command: forward takes a number, not 'a'"),
    (lambda s: s.robot.play(3), "Robot.play: motion takes a text, not 3"),
    (lambda s: setattr(s.robot, "level", 3), "Robot.level: level takes a text, not 3"),
    (lambda s: setattr(s.robot, "controller", 3), "a controller is called as controller(robot, time); int cannot be called"),
    (lambda s: setattr(s.robot, "joint_target", "a"), "Robot.joint_target: targets takes numbers, not 'a'"),
    (lambda s: setattr(s.robot, "position", "a"), "numbers are needed, not 'a'"),
    (lambda s: s.robot.push("torso", force=(1, 2, 3), duration="a"), "Entity.push: duration takes a number, not 'a'"),
    (lambda s: s.robot.place((0, 0, 0), heading="a"), "Entity.place: heading takes a number, not 'a'"),
    (lambda s: s.robot["torso"][3], "Object.__getitem__: property takes a text, not 3"),
    (lambda s: s.robot.sensors[3], "ByName.__getitem__: name takes a text, not 3"),
    (lambda s: s.robot.sensors["imu"][3], "Sensor.__getitem__: output takes a text, not 3"),
    (lambda s: s.robot.kinematics.fk(s.robot.joint_position, 3), "Kinematics.fk: object takes a text, not 3"),
    (lambda s: lib.Scene(3), "Scene.__init__: name takes a text or a file, not 3"),
    (lambda s: lib.Scene("walk", seed=-1), "Scene.__init__: seed is out of range: -1"),
    (lambda s: lib.Scene("walk", threads=1.5), "Scene.__init__: threads takes a whole number, not 1.5"),
    (lambda s: lib.Scene("walk", lenient="yes"), "Scene.__init__: lenient takes True or False, not 'yes'"),
    (lambda s: lib.Scene("walk", pushes=[3]), "a push is 'OBJECT=FORCE@BEGIN..END', not 3"),
    (lambda s: lib.Scene.of_robot("kid21", seed="a"), "Scene.of_robot: seed takes a whole number, not 'a'"),
    (lambda s: lib.Batch("walk", 1.5), "Batch.__init__: n takes a whole number, not 1.5"),
    (lambda s: lib.Batch("walk", -1), "Batch.__init__: n is out of range: -1"),
    (lambda s: lib.Recording(3), "Recording.__init__: file takes a text or a file, not 3"),
    (lambda s: lib.check(3), "check: model takes a text or a file, not 3"),
    (lambda s: lib.sweep("walk", results=3), "sweep: results takes texts, not 3"),
]


@pytest.mark.parametrize("call, line", WRONG, ids=[line for _, line in WRONG])
def test_wrong_arguments_are_named(call: Callable[[Any], object], line: str, shared_scene: ms.Scene) -> None:
    with pytest.raises(ms.InputError) as caught:
        call(shared_scene)
    assert str(caught.value) == line
    assert isinstance(caught.value, ValueError)


@pytest.fixture(scope="module")
def shared_scene() -> ms.Scene:
    return ms.Scene.of_robot("kid21")


def test_of_another_kind_is_a_type_error(shared_scene: ms.Scene) -> None:
    with pytest.raises(TypeError, match="^Scene.step: steps takes a whole number, not 1.5$"):
        shared_scene.step(1.5)  # type: ignore[arg-type]


def test_errors_of_callers_stay_theirs(shared_scene: ms.Scene) -> None:
    with pytest.raises(TypeError, match="can only concatenate") as caught:
        shared_scene.run(until=lambda s: "a" + 1, at_most=1.0)  # type: ignore[operator]
    assert not isinstance(caught.value, ms.Error)
