"""The package as a whole: types, studies, recordings, the command."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from murosimf._program import program

import murosimf as ms
from murosimf import _core


def test_has_all_types(root: Path, tmp_path: Path) -> None:
    """mypy --strict over the package, and over what a user writes."""
    pytest.importorskip("mypy")
    user = tmp_path / "user.py"
    user.write_text("import murosimf as ms\ns = ms.Scene('walk', set={'walker.level': 'full_dynamics'})\n"
                    "reveal_type(s['walker'].joint_position)\ns.step('3')\ns['walker'].level = 'x'\n")
    done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), "-p", "murosimf",
                           "-m", "user"], capture_output=True, text=True, check=False,
                          env={"MYPYPATH": f"{root / 'python'}:{tmp_path}", "PATH": ""})
    assert 'Revealed type is "murosimf.joints.JointArray"' in done.stdout
    assert done.stdout.count("error:") == 1, done.stdout
    assert 'Argument 1 to "step" of "Scene"' in done.stdout


def test_the_stub_says_what_the_extension_has(root: Path) -> None:
    import ast

    tree = ast.parse((root / "python/murosimf/_core.pyi").read_text())
    told = {node.name: {each.name for each in node.body if isinstance(each, ast.FunctionDef)} - {"__init__"}
            for node in tree.body if isinstance(node, ast.ClassDef)}
    for name, members in told.items():
        real = {member for member in vars(getattr(_core, name)) if not member.startswith("__")}
        assert real == members, name
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert functions == {name for name in vars(_core) if not name.startswith("_")} - set(told)


def test_everything_public_has_a_docstring_or_says_its_units() -> None:
    for name in ("Scene", "Robot", "Batch", "Kinematics", "Sensor", "Recording"):
        for member, value in vars(getattr(ms, name)).items():
            if isinstance(value, property) and member.startswith(("joint_", "linear_", "angular_", "position")):
                assert value.__doc__, f"{name}.{member}"
                assert "[" in value.__doc__, f"{name}.{member}"


def test_recordings(tmp_path: Path) -> None:
    scene = ms.Scene("walk", set={"walker.level": "simplified_dynamics"})
    file = tmp_path / "run.mcap"
    with scene.record(file, rate=50):
        scene.run(1.0)
    recording = ms.Recording(file)
    z = recording["walker.j_torso.position.z"]
    assert z.unit == "m"
    assert z.times[-1] == pytest.approx(1.0)
    # within what a walking robot's torso moves in a step
    assert z.values[-1] == pytest.approx(scene["walker"]["j_torso"].position[2], abs=1e-3)
    table = recording.table("walker.j_torso.position")
    assert table.dtype.names == ("time", *(f"walker.j_torso.position.{axis}" for axis in "xyz"))
    assert (table["walker.j_torso.position.z"] == z.values).all()
    with pytest.raises(ms.InputError):
        ms.Recording(tmp_path / "none.mcap")


def test_studies() -> None:
    table = ms.sweep("walk", results=["walker.distance"], seeds=[1, 2], grid={"walker.command.0": [0.1, 0.2]}, duration=1.0)
    assert len(table["runs"]) == 4
    scene = ms.Scene("walk", seed=2, set={"walker.command": [0.2, 0, 0]})
    start = scene.robot.position.copy()
    scene.run(1.0)
    way = np.linalg.norm((scene.robot.position - start)[:2])
    run = next(run for run in table["runs"] if run["seed"] == 2 and float(run["values"][0]) == 0.2)
    assert run["results"][0] == pytest.approx(way, abs=0.02)
    compared = ms.compare("walk", "walker", levels=["simplified_dynamics", "articulated_dynamics"], duration=0.5, repeat=1)
    assert [entry["level"] for entry in compared["entries"]] == ["simplified_dynamics", "articulated_dynamics"]
    assert ms.check("kid21")["bodies"] == 22
    with pytest.raises(ms.InputError, match="no_such_robot"):
        ms.check("no_such_robot")


def test_the_command(tmp_path: Path) -> None:
    def said(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-m", "murosimf", *arguments], capture_output=True, text=True, check=False)

    assert said("--version").stdout == f"murosimf {ms.__version__}\n"
    assert json.loads(said("check", "kid21", "--json", "-").stdout)["bodies"] == 22
    done = said("demo", str(tmp_path / "game.png"))
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "game.png").read_bytes().startswith(b"\x89PNG")
    assert Path(program()).is_file()


def test_pictures_without_a_driver(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null")
    monkeypatch.setenv("MUROSIMF_RENDERER", "software")
    scene = ms.Scene.of_robot("kid21")
    seen = scene.picture(eye=(1.5, 0, 0.4), look_at=(0, 0, 0.25), field_of_view=0.6, width=48, height=64)
    red, green, blue = seen.rgb.astype(int)[62, 2]
    assert green > red and green > blue, "the ground below"
    assert seen.labels is not None and seen.labels[22, 24] > 3, "the robot in the middle"
