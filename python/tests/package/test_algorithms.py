"""Classes in Python that are no controllers: algorithms, sensors and referees of scene files."""

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from murosimf._program import program

import murosimf as ms

PRACTICE = Path(__file__).parents[3] / "examples/python/algorithms/practice.toml"

ROBOTS = 'name = "Soft"\nduration = 0.3\n[ball]\nposition = [1.0, 0.0]\n' + "".join(
    f'[[robots]]\nname = "r{i}"\nmodel = "kid21"\nlevel = "simplified_dynamics"\nposition = [0.0, {i}.0]\ncontroller = "none"\n'
    for i in range(2)
)


def scene_of(folder: Path, text: str, *algorithms: str) -> Path:
    """Two robots and a ball, and a module `soft` with the classes that the tables name."""
    (folder / "soft.py").write_text(text)
    (folder / "soft.toml").write_text(ROBOTS + "".join(f"[[algorithms]]\n{one}\n" for one in algorithms))
    return folder / "soft.toml"


def run(*arguments: object, expect: int = 0) -> "subprocess.CompletedProcess[str]":
    done = subprocess.run([program(), "run", *map(str, arguments)], capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == expect, done.stderr + done.stdout
    return done


def report(*arguments: object, expect: int = 0) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(run(*arguments, "--libraries", "--json", "-", expect=expect).stdout)
    return found


def test_the_example_is_the_same_in_every_run() -> None:
    runs = [report(PRACTICE, "--threads", threads) for threads in (1, 2)]
    scene = ms.Scene(str(PRACTICE), libraries=True)
    assert not scene.run(20.0)
    assert scene.ended == "Referee: the ball was out 2 times"
    assert {f"{scene.state_hash:016x}"} == {one["state_hash"] for one in runs}
    assert runs[0]["stopped"]["by"] == scene.ended
    assert runs[0]["stopped"]["time_s"] == pytest.approx(scene.time)
    assert [one["robot"] for one in runs[0]["control"]] == ["range", "Wind", "Referee"]
    assert [one["text"] for one in runs[0]["control"][2]["said"]] == ["out for the 1. time", "out for the 2. time"]
    assert abs(scene["walker"][scene["walker"].objects.names[0]]["applied_force"][0]) > 0
    scene.reset(seed=5)
    assert scene.ended == ""
    scene.run(0.5)
    saved = scene.save()
    scene.run(0.3)
    end = scene.state_hash
    scene.load(saved)
    scene.run(0.3)
    assert scene.state_hash == end


def test_examples_play() -> None:
    scenes = sorted(PRACTICE.parent.glob("*.toml"))
    assert scenes
    for scene in scenes:
        assert {one["ended"] for one in report(scene, "--duration", 0.5)["control"]} == {""}


@pytest.mark.parametrize(("kind", "duration", "stopped"), [("sensor", 0.2, None), ("algorithm", 0.2, None),
                                                           ("referee", 5, "roll_on: the ball has rolled 1 m")])
def test_a_new_one_is_made_and_plays(tmp_path: Path, kind: str, duration: float, stopped: str | None) -> None:
    root = Path(__file__).parents[3]
    shutil.copytree(root / "scripts/templates", tmp_path / "scripts/templates")
    shutil.copy(root / "scripts/new", tmp_path / "scripts/new")
    subprocess.run([sys.executable, tmp_path / "scripts/new", f"python-{kind}", "roll_on"], check=True, capture_output=True)
    found = report(tmp_path / "examples/python/algorithms/roll_on.toml", "--duration", duration)
    control = [one for one in found["control"] if one["robot"] == "roll_on"][0]
    assert control["calls"] > 0
    assert (found.get("stopped") or {}).get("by") == stopped
    if kind == "referee":
        assert found["stopped"]["time_s"] < 2
    else:
        assert control["ended"] == ""


def test_a_sensor_is_read_by_control_software_and_by_others(tmp_path: Path) -> None:
    text = """
class Range:
    rate = 50.0
    reads = ("position", "ball.position")
    gives = {"distance": "m", "way": ("m", ("x", "y"))}
    def __call__(self, robot, time):
        way = robot.signals["ball.position"][0, :2] - robot.position[0, :2]
        robot.outputs["way"] = way
        robot.outputs["way"]["x"] += 1
        robot.outputs["distance"] = (way @ way) ** 0.5

class Reader:
    phase = "observe"
    reads = ("r0.eye0.distance", "r1.eye1.way")
    def __call__(self, scene, time):
        if time == 0.1:
            print(round(float(scene.signals["r0.eye0.distance"][0]), 2), *scene.signals["r1.eye1.way"].round(2))

class Steers:
    reads = ("eye0.distance",)
    writes = ("joint_target",)
    def __call__(self, robot, time):
        robot.joint_target[0] = 0.1 * robot.signals["eye0.distance"][0]
"""
    eyes = [f'name = "eye{i}"\nclass = "soft:Range"\non = "r{i}"' for i in range(2)]
    path = scene_of(tmp_path, text, *eyes, 'class = "soft:Reader"')
    steers = 'controller = "python"\noptions = {class = "soft:Steers"}'
    path.write_text(path.read_text().replace('controller = "none"', steers, 1))
    found = report(path)
    said = [one["said"] for one in found["control"] if one["robot"] == "Reader"]
    assert [one["text"] for one in said[0]] == ["1.0 2.0 -1.0"]
    scene = ms.Scene(str(path), libraries=True)
    scene.run(0.3)
    assert scene["r0"].joint_target[0] == pytest.approx(0.1, abs=0.01)
    assert scene["r0"].sensors["eye0"].units == {"distance": "m", "way": "m"}
    assert scene["r0"].sensors["eye0"]["way"].shape == (2,)


CLOCK = """
class Clock:
    rate = 50.0
    gives = {"time": "s", "pair": ("s", ("a", "b"))}
    def __call__(self, robot, time):
        robot.outputs["time"] = time
        robot.outputs["pair"] = time

class Reader:
    rate, phase = 1000.0, "control"
    reads = ("r0.clock.time", "r0.clock.pair")
    writes = ("ball.applied_force",)
    def start(self, scene, time): self.sum = 0.0
    def __call__(self, scene, time):
        self.sum += scene.signals["r0.clock.time"][0] + scene.signals["r0.clock.pair"].sum()
        scene.commands["ball.applied_force"][0, 0, 0] = 1e-3 * self.sum  # the state hash depends on every sample
    def save(self): return repr(float(self.sum)).encode()
    def load(self, saved): self.sum = float(saved)
"""


def test_a_sensor_has_delay_noise_and_rate(tmp_path: Path) -> None:
    path = scene_of(tmp_path, CLOCK, 'name = "clock"\nclass = "soft:Clock"\non = "r0"', 'class = "soft:Reader"')

    def samples(*settings: str) -> "np.typing.NDArray[np.float64]":
        """Rows: simulated time, then the three numbers that are read at that time."""
        scene = ms.Scene(str(path), libraries=True, set=dict(one.split("=", 1) for one in settings))
        rows = []
        for _ in range(200):
            scene.step()
            clock = scene["r0"].sensors["clock"]
            rows.append([scene.time, float(clock["time"].item()), *np.ravel(clock["pair"])])
        return np.array(rows)

    plain, late = samples(), samples("algorithms.clock.delay=0.033")
    step, period, delay = np.arange(200), 20, 33  # [ms] what the last step has shown: it began a millisecond before
    np.testing.assert_allclose(plain[:, 1], step // period * period * 1e-3, atol=1e-12)
    np.testing.assert_allclose(late[:, 1], np.maximum(0, (step - delay) // period) * period * 1e-3, atol=1e-12)
    fast = samples("algorithms.clock.rate=1000")
    np.testing.assert_allclose(fast[:, 1], step * 1e-3, atol=1e-12)
    errors = (samples("algorithms.clock.rate=1000", "algorithms.clock.noise=0.01") - fast)[:, 1:]
    assert errors.std() == pytest.approx(0.01, rel=0.12)  # of 600 numbers: four deviations of their deviation
    assert abs(errors.mean()) < 0.0017
    assert len(np.unique(errors)) == errors.size  # each number and each sample has its own
    noisy = samples("algorithms.clock.noise=0.01", "algorithms.clock.delay=0.033")
    at_once = samples("algorithms.clock.noise=0.01")
    np.testing.assert_array_equal(noisy[delay:, 1:], at_once[:-delay, 1:])  # the same samples, later
    one = samples("algorithms.clock.noise={pair=0.01}")
    np.testing.assert_array_equal(one, samples("algorithms.clock.noise.pair=0.01"))
    np.testing.assert_array_equal(one[:, 1], plain[:, 1])
    assert (one[1:, 2] != plain[1:, 2]).any()
    hashes = [report(path, "--set", "algorithms.clock.noise=0.01", "--set", "algorithms.clock.delay=0.033", *more)["state_hash"]
              for more in (("--threads", 1), ("--threads", 2), ("--seed", 9))]
    assert hashes[0] == hashes[1] != hashes[2]
    scene = ms.Scene(str(path), libraries=True, set={"algorithms.clock.noise": 0.01, "algorithms.clock.delay": 0.033})
    scene.run(0.15)
    saved = scene.save()
    scene.run(0.15)
    assert f"{scene.state_hash:016x}" == hashes[0]
    scene.load(saved)
    scene.run(0.15)
    assert f"{scene.state_hash:016x}" == hashes[0]
    for wrong, says in (("clock.noise=-1", "'noise' must be a deviation"), ("clock.noise={tim=1}", "did you mean 'time'?"),
                        ("Reader.delay=0.1", "gives no readings"), ("clock.delay=11", "10"),
                        ("clock.rate.x=3", "write algorithms.NAME.KEY")):
        assert says in run(path, "--libraries", "--set", f"algorithms.{wrong}", expect=2).stderr


FORCE = """
class Force:
    rate, phase = 1000.0, "contact"
    writes = ("r1.applied_force",)
    def __init__(self, x=0.0): self.x = x
    def __call__(self, scene, time): scene.commands["r1.applied_force"][0, 0, 0] = self.x
"""


def test_writes_properties_as_set_does(tmp_path: Path) -> None:
    by_class = ms.Scene(str(scene_of(tmp_path, FORCE, 'class = "soft:Force"\noptions = {x = 3.0}')), libraries=True)
    base = by_class["r1"].objects.names[0]
    plain = ms.Scene(str(scene_of(tmp_path, "")), set={f"r1.{base}.applied_force": [3, 0, 0, 0, 0, 0]})
    for one in (by_class, plain):
        one.run(0.2)
    np.testing.assert_array_equal(by_class["r1"].position, plain["r1"].position)
    assert by_class["r1"].position[0] != by_class["r0"].position[0]


def test_the_command_line_reaches_keys_and_options(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, FORCE, 'class = "soft:Force"\noptions = {x = 3.0}', 'name = "push"\nclass = "soft:Force"')
    hashes = [report(scene, *options)["state_hash"] for options in (
        ("--set", "algorithms.push.options.x=3"), ("--set", "algorithms.push.x=3"),
        ("--set", "algorithms.Force.x=4", "--set", "algorithms.push.x=3"), ())]
    assert hashes[0] == hashes[1] == hashes[2] != hashes[3]  # the later one writes last
    assert report(scene, "--set", "algorithms.push.rate=500")["control"][1]["rate_hz"] == 500
    for wrong, says in (("pull.x=3", "did you mean 'push'?"), ("push.y=3", "'y'"), ("push.x.y.z=3", "write algorithms.NAME.KEY")):
        assert says in run(scene, "--libraries", "--set", f"algorithms.{wrong}", expect=2).stderr
    assert "no [[algorithms]]" in run("walk", "--set", "algorithms.push.x=3", expect=2).stderr


def test_an_exception_freezes_the_entity_or_ends_the_run(tmp_path: Path) -> None:
    text = "class A:\n    def __call__(self, robot, time):\n        if time > 0.1: raise ValueError('lost')\n"
    on = report(scene_of(tmp_path, text, 'class = "soft:A"\non = "r0"'))
    why = f"class 'soft:A' of 'A': its step raised {tmp_path}/soft.py:3: ValueError: lost"
    assert [one["frozen"] for one in on["entities"] if one["name"] != "ball"] == [True, False]
    assert on["control"][0]["ended"] == f"at 0.110 s: {why}"
    assert on["control"][0]["said"][-1]["text"] == "ValueError: lost"
    assert on["simulated_s"] == pytest.approx(0.3)
    whole = report(scene_of(tmp_path, text, 'class = "soft:A"'), expect=3)
    assert whole["stopped"]["by"] == "a crash"
    assert whole["simulated_s"] < 0.12
    assert whole["control"][0]["ended"] == f"at 0.110 s: {why}"
    with pytest.raises(ms.SimulationError, match="ValueError: lost"):
        (loaded := ms.Scene(str(tmp_path / "soft.toml"), libraries=True)).run(0.3)
    loaded.reset()
    loaded.run(0.05)


CALL = "    def __call__(self, robot, time): pass\n"


@pytest.mark.parametrize(
    ("text", "table", "line"),
    [
        (CALL, 'on = "r9"', "unknown entity 'r9'"),
        ("    writes = ('r0.positon',)\n" + CALL, "", "unknown property 'positon'; did you mean 'position'?"),
        ("    reads = ('r0.imu.gyro',)\n" + CALL, "", "reads 'r0.imu.gyro': "),
        ("    writes = ('imu.gyroscope',)\n" + CALL, 'on = "r0"', "only properties of entities can be written"),
        ("    gives = {'x': 'm'}\n" + CALL, "", "'A' gives readings, so it needs a robot"),
        ("    gives = ('x',)\n" + CALL, 'on = "r0"', "'gives' of A must be a dictionary"),
        ("    gives = {'x': 'm'}\n    phase = 'observe'\n" + CALL, 'on = "r0"', "its phase is 'sense', not 'observe'"),
        ("    gives = {'x': 'm'}\n" + CALL, 'on = "r0"\nname = "imu"', "'r0' has two sensors called 'imu'"),
    ],
)
def test_mistakes_are_said_in_one_line(tmp_path: Path, text: str, table: str, line: str) -> None:
    scene = scene_of(tmp_path, "class A:\n" + text, f'class = "soft:A"\n{table}')
    with pytest.raises(ms.InputError) as wrong:
        ms.Scene(str(scene), libraries=True)
    assert str(wrong.value).startswith(f"{scene}:18:")
    assert line in str(wrong.value)
    assert "\n" not in str(wrong.value)


def test_what_is_not_declared_is_not_written(tmp_path: Path) -> None:
    text = "class A:\n    reads = ('position', 'ball.position')\n    def __call__(self, robot, time): LINE\n"
    for does, line in [
        ("robot.position = 0", "ValueError: 'position' is only read: name it in writes"),
        ("robot.signals['ball.position'] = 0", "ValueError: 'ball.position' is only read: name it in writes"),
        ("robot.joint_target = 0", "AttributeError: 'joint_target' is not among the properties that the class declares"),
    ]:
        found = report(scene_of(tmp_path, text.replace("LINE", does), 'class = "soft:A"\non = "r0"'))
        assert line in found["control"][0]["ended"]


def test_needs_allowance(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, "open('ran', 'w')\n", 'class = "soft:A"')
    done = run(scene, expect=2)
    assert f"{scene}:18:9: this file has control software loaded, 'soft:A'" in done.stderr
    assert not Path("ran").exists()
