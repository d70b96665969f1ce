"""Scenes against the program, and what they say."""

import copy
import re
import subprocess

import numpy as np
import pytest
from murosimf._program import program

import murosimf as ms


def hash_of_program(*arguments: str) -> int:
    output = subprocess.run([program(), "run", *arguments], capture_output=True, text=True, check=True).stdout
    found = re.search(r"state hash ([0-9a-f]{16})", output)
    assert found
    return int(found[1], 16)


@pytest.mark.parametrize("level", ["kinematic_walking", "simplified_dynamics", "articulated_dynamics"])
def test_gives_the_states_of_the_program(level: str) -> None:
    scene = ms.Scene("walk", seed=3, set={"walker.level": level})
    scene.run(1.5)
    assert scene.time == 1.5
    assert scene.nanoseconds == 1_500_000_000
    assert scene.state_hash == hash_of_program("walk", "--seed", "3", "--set", f"walker.level={level}", "--duration", "1.5")


def test_threads_do_not_matter() -> None:
    one, two = (ms.Scene("three_on_three", threads=threads) for threads in (1, 2))
    one.run(0.5)
    two.step(round(0.5 / two.step_length))
    assert one.state_hash == two.state_hash


def test_looking_at_joints_does_not_change_the_run() -> None:
    seen, unseen = ms.Scene("walk"), ms.Scene("walk")
    rows = [seen.robot.joint_position, seen.robot.joint_velocity, seen.robot.joint_torque, seen.robot.joint_target]
    for _ in range(100):
        seen.step(5)
        unseen.step(5)
    assert len({row.shape for row in rows}) == 1
    assert seen.state_hash == unseen.state_hash


def test_texts_events_and_values() -> None:
    text = '[[robots]]\nname = "r"\nmodel = "kid21"\nlevel = "kinematic_walking"\ncontroller = "walk"\n'
    scene = ms.Scene.of_text(text, set={"r.command": [0.2, 0, 0]}, events={1.0: {"r.command": np.zeros(3)}})
    scene.run(1.0)
    way = scene["r"].position[0]
    scene.run(3.0)
    assert way > 0.1
    assert scene["r"].position[0] < way + 0.15  # a last step at most


def test_runs_as_long_as_the_clock_says() -> None:
    """Sums of seconds are rounded, and nanoseconds are not."""
    scene = ms.Scene.of_robot("kid21")
    expected = 0
    for milliseconds in [7, 3, 9, 1, 6] * 40:
        assert not scene.run(until=lambda s: False, at_most=milliseconds / 1000)
        expected += milliseconds * 1_000_000
        assert scene.nanoseconds == expected
    for wrong in (float("nan"), float("inf"), -1.0):
        with pytest.raises(ms.InputError, match="0 to 3e9 s"):
            scene.run(until=lambda s: False, at_most=wrong)


def test_runs_until() -> None:
    scene = ms.Scene("walk")
    start = scene.robot.position[0]
    assert scene.run(until=lambda s: s["walker"].position[0] > start + 0.3, at_most=5.0)
    assert start + 0.3 < scene.robot.position[0] < start + 0.31
    assert not scene.run(until=lambda s: False, at_most=0.25)
    for wrong in ({}, {"until": bool}, {"seconds": 1.0, "at_most": 2.0}):
        with pytest.raises(ms.InputError, match="run\\("):
            scene.run(**wrong)


def test_resets_saves_and_copies() -> None:
    scene = ms.Scene("walk", set={"walker.level": "simplified_dynamics"})
    begin = scene.state_hash
    scene.run(0.7)
    state, there = scene.save(), scene.state_hash
    other = copy.copy(scene)
    scene.run(0.4)
    end = scene.state_hash
    other.run(0.4)
    assert other.state_hash == end
    scene.load(state)
    assert scene.state_hash == there
    scene.run(0.4)
    assert scene.state_hash == end
    scene.reset()
    assert scene.state_hash == begin
    scene.reset(seed=8)
    assert scene.state_hash == ms.Scene("walk", seed=8, set={"walker.level": "simplified_dynamics"}).state_hash


def test_mistakes_are_said_as_the_program_says_them() -> None:
    def said(*arguments: str) -> str:
        ended = subprocess.run([program(), "run", *arguments], capture_output=True, text=True, check=False)
        assert ended.returncode == 2
        return ended.stderr.strip().removeprefix("murosimf: ")

    with pytest.raises(ms.InputError) as error:
        ms.Scene("no_such_scene")
    assert str(error.value) == said("no_such_scene")
    with pytest.raises(ms.SetupError) as error:
        ms.Scene("walk", set={"walker.levle": "full_dynamics"})
    assert str(error.value) == said("walk", "--set", "walker.levle=full_dynamics")
    scene = ms.Scene("walk")
    with pytest.raises(KeyError, match="^unknown robot 'waker'; did you mean 'walker'\\?$"):
        scene["waker"]
    with pytest.raises(ValueError, match="full_dynamics"):
        scene["walker"].level = "full_dynamic"
    with pytest.raises(ms.InputError, match="-3 steps"):
        scene.step(-3)
    with pytest.raises(ms.InputError, match="3e9 s"):
        scene.run(float("nan"))
    with pytest.raises(ms.InputError, match="takes 3 numbers"):
        scene.robot.push(force=(1, 2), duration=0.1)
    assert scene.time == 0


def test_robots_and_bodies_come_and_go() -> None:
    scene = ms.Scene("three_on_three")
    added = scene.add_robot("b4", "kid21", position=(-2, 1.5, 0), level="kinematic_walking")
    assert scene.robots[-1] == "b4"
    assert added.position[:2] == pytest.approx([-2, 1.5], abs=0.1)  # starts vary, as the scene says
    crate = scene.add_body("crate", "box", size=(0.2, 0.3, 0.4), mass=2.0, position=(0, 1, 0.5))
    scene.run(0.2)
    # falls freely: g t^2 / 2 of the semi-implicit steps, a millimeter or so beside it
    assert crate.position[2] == pytest.approx(0.7 - 9.81 * 0.2**2 / 2, abs=2e-3)
    scene.leave("b4")
    assert not added.present
    scene.enter("b4")
    assert added.present
    with pytest.raises(ms.InputError, match="unknown shape 'cube'"):
        scene.add_body("other", "cube")  # type: ignore[arg-type]


def test_contacts_carry_the_weight() -> None:
    scene = ms.Scene.of_text('[[bodies]]\nname = "crate"\nshape = "box"\nsize = [0.2, 0.2, 0.2]\nmass = 3.0\nposition = [0, 0]\n')
    scene.run(1.0)
    contacts = scene.contacts()
    assert contacts.dtype.names == ("a", "a_object", "b", "b_object", "position", "normal", "force", "depth")
    assert set(contacts["a"]) == {"crate"}
    assert set(contacts["b"]) == {"field"}
    assert contacts["force"].sum(axis=0) == pytest.approx([0, 0, 3 * 9.81], abs=1e-2)
    assert contacts["normal"] == pytest.approx(np.tile([0, 0, 1], (len(contacts), 1)))
    hit = scene.cast((0, 0, 5), (0, 0, -2))
    assert hit
    assert (hit.entity, hit.distance) == ("crate", pytest.approx(4.8, abs=1e-3))
    assert scene.cast((0, 0, 5), (0, 0, 1)) is None
    assert scene.distance("crate", "field") == pytest.approx(0, abs=1e-3)


def test_says_what_it_is() -> None:
    scene = ms.Scene("walk")
    assert re.fullmatch(r"scene 'Walk' at 0\.000 s\n  walker +kinematic_walking", repr(scene))
    assert "position" not in repr(scene.robot)
    camera = scene.robot.cameras["camera"]  # looking at it has not begun the run
    scene.run(0.1)
    assert camera.period == pytest.approx(0.05)
    assert re.fullmatch(r"scene 'Walk' at 0\.100 s\n  walker +kinematic_walking +-2\.00\d, .* m +0 falls", repr(scene))
    assert "<td>walker</td>" in scene._repr_html_()
    assert "level     kinematic_walking" in repr(scene.robot)
    assert "<caption>robot walker</caption>" in scene.robot._repr_html_()
    assert len(repr(scene.robot.joints).splitlines()) == 1 + len(scene.robot.joints)
