"""Constants of models and materials that change while a scene runs: as if the scene had been built with them."""

import copy

import numpy as np
import pytest

import murosimf as ms

LEVELS = ("kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics")

CHANGES = {
    "walker.torso.mass": 2.5,
    "walker.torso.center_of_mass": [0.01, 0, 0.03],
    "walker.l_foot.mass": 0.2,
    "walker.joint_damping": 0.3,
    "walker.servo.position_gain": 12.0,
    "walker.j_l_shin.servo.stall_torque": 2.0,
    "materials.friction": 0.4,
    "materials.*.carpet.restitution": 0.3,
    "field.friction": 0.25,
}


def scene(level: str, changes: "dict[str, object] | None" = None) -> ms.Scene:
    set_ = {"walker.level": level, "walker.controller": "none", "walker.sensors": False}
    return ms.Scene("walk", set={**set_, **(changes or {})})


def disturb(one: ms.Scene) -> None:
    """It falls, and lies on the ground in the end."""
    one["walker"].joint_target["j_l_shin"] = 0.8
    if one["walker"].level != "kinematic_walking":  # motion without forces
        one["walker"].push("torso", force=(40, 25, 0), duration=0.1)


@pytest.mark.parametrize("level", LEVELS)
def test_equal_a_scene_that_was_built_with_them_bit_for_bit(level: str) -> None:
    built, changed, plain = scene(level, CHANGES), scene(level), scene(level)
    changed.change(CHANGES)
    for one in (built, changed, plain):
        disturb(one)
        one.run(0.7)
    assert changed.state_hash == built.state_hash
    if level != "kinematic_walking":
        assert changed.state_hash != plain.state_hash


@pytest.mark.parametrize("change", CHANGES)
def test_each_acts_on_its_own_in_the_middle_of_a_run(change: str) -> None:
    first, second, plain = (scene("articulated_dynamics") for _ in range(3))
    for one in (first, second, plain):
        disturb(one)
        one.run(0.2)
    for one in (first, second):
        one.change({change: CHANGES[change]})
    assert np.array_equal(first["walker"].joint_position, plain["walker"].joint_position)
    assert np.array_equal(first["walker"].linear_velocity, plain["walker"].linear_velocity)
    for one in (first, second, plain):
        one.run(0.5)
    assert first.state_hash == second.state_hash
    assert np.isfinite(first["walker"].position).all()
    if "restitution" not in change:  # of round bodies
        assert first.state_hash != plain.state_hash


def test_as_properties_of_objects() -> None:
    one = scene("articulated_dynamics")
    torso = one["walker"]["torso"]
    mass = torso["mass"][0]
    torso["mass"] = 2 * mass
    one["walker"]["j_l_shin"]["servo.stall_torque"] = 1.5
    assert torso["mass"][0] == 2 * mass
    torso["mass"] = 3 * mass  # what was in between leaves no trace
    disturb(one)
    one.run(0.2)
    built = scene("articulated_dynamics", {"walker.torso.mass": 3 * mass, "walker.j_l_shin.servo.stall_torque": 1.5})
    disturb(built)
    built.run(0.2)
    assert one.state_hash == built.state_hash


def test_go_with_states_and_end_with_a_reset() -> None:
    one = scene("articulated_dynamics")
    start = one.save()
    one.run(0.05)
    one.change({"walker.torso.mass": 2.0, "field.friction": 0.3})
    saved, other = one.save(), copy.copy(one)
    for each in (one, other):
        each.run(0.2)
    end = one.state_hash
    assert other.state_hash == end
    one.reset()
    assert one["walker"]["torso"]["mass"][0] != 2.0
    one.load(saved)
    assert one["walker"]["torso"]["mass"][0] == 2.0
    one.run(0.2)
    assert one.state_hash == end
    one.load(start)
    fresh = scene("articulated_dynamics")
    for each in (one, fresh):
        each.run(0.25)
    assert one.state_hash == fresh.state_hash


def test_a_level_that_comes_later_has_them() -> None:
    one, built = scene("simplified_dynamics"), scene("simplified_dynamics", {"walker.torso.mass": 2.0})
    one["walker"]["torso"]["mass"] = 2.0
    for each in (one, built):
        each.run(0.1)
        each["walker"].level = "articulated_dynamics"
        each.run(0.2)
    assert one.state_hash == built.state_hash


@pytest.mark.parametrize(
    ("change", "value", "line"),
    [
        ("walker.torso.mass", -1, "must be above 0"),
        ("walker.j_l_shin.joint_damping", -1, "'joint_damping' is -1; it must be at least 0"),
        ("walker.pelvis.servo.stall_torque", 1, "is no joint"),
        ("materials.rubbr.friction", 0.5, "unknown material 'rubbr'"),
        ("materials.frition", 0.5, "did you mean 'friction'?"),
        ("field.friction", -0.5, "the friction of the field is a number, at least 0"),
    ],
)
def test_what_cannot_be_is_refused_in_one_line_and_changes_nothing(change: str, value: float, line: str) -> None:
    one = scene("articulated_dynamics")
    before = one.state_hash
    with pytest.raises(ms.InputError) as wrong:
        one.change({"walker.torso.mass": 2.0, change: value} if "torso.mass" not in change else {change: value})
    assert line in str(wrong.value)
    assert "\n" not in str(wrong.value)
    assert one.state_hash == before
    assert one["walker"]["torso"]["mass"][0] != 2.0
