"""Classes in Python as control software: in scene files, in the program and in the package."""

import copy
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from murosimf._program import program

import murosimf as ms

WAVE = """
import numpy as np

class Wave:
    rate = 50.0
    reads = ("joint_position", "joint_velocity", "imu.accelerometer", "position")
    writes = ("joint_target",)

    def __init__(self, height=0.5, joint="j_l_upper_arm", times=1):
        self.height, self.joint, self.times = height, joint, times

    def start(self, robot, time):
        self.calls = 0
        robot.joint_target[self.joint] = 0.1

    def __call__(self, robot, time):
        self.calls += 1
        for _ in range(self.times):
            robot.joint_target[self.joint] = self.height * np.sin(6 * time + self.calls) + 0.01 * robot.joint_velocity[0]

    def save(self):
        return bytes([self.calls % 256])

    def load(self, saved):
        self.calls = saved[0]
"""


def scene_of(folder: Path, text: str, cls: str, options: str = "", robots: int = 1, more: str = "") -> Path:
    """A scene file with a class of the module `soft` beside it, for its first robot; others are there, too."""
    (folder / "soft.py").write_text(text)
    scene = 'name = "Loop"\nduration = 0.5\n'
    for i in range(robots):
        scene += f'[[robots]]\nname = "r{i}"\nmodel = "kid21"\nlevel = "simplified_dynamics"\nposition = [0.0, {i}.0]\n'
        scene += f'controller = "python"\noptions = {{class = "soft:{cls}"{options}}}\n' + more
    (folder / "loop.toml").write_text(scene)
    return folder / "loop.toml"


def run(*arguments: object, expect: int = 0) -> "subprocess.CompletedProcess[str]":
    done = subprocess.run([program(), "run", *map(str, arguments)], capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == expect, done.stderr + done.stdout
    return done


def report(*arguments: object) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(run(*arguments, "--json", "-").stdout)
    return found


def test_is_the_same_in_the_program_and_in_the_package_with_any_threads(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, WAVE, "Wave", ", height = 0.3, times = 2", robots=2)
    of_program = {report(scene, "--libraries", "--threads", threads)["state_hash"] for threads in (1, 2)}
    loaded = [ms.Scene(str(scene), libraries=True, threads=threads) for threads in (1, 2)]
    for one in loaded:
        one.run(0.5)
    assert {f"{one.state_hash:016x}" for one in loaded} == of_program
    assert len(of_program) == 1
    target = loaded[0]["r0"].joint_target["j_l_upper_arm"]
    assert 0 < abs(target) <= 0.31
    control = report(scene, "--libraries")["control"]
    assert [one["robot"] for one in control] == ["r0", "r1"]
    assert control[0]["software"] == f"Wave of {tmp_path}/soft.py"
    assert control[0]["calls"] == 25
    assert control[0]["rate_hz"] == 50


def test_equals_a_built_in_controller_bit_for_bit(tmp_path: Path) -> None:
    rows = [(0, 0, 0), (0.1, 0.25, -0.3), (0.3, 0.5, 0.1), (0.45, -0.2, 0.0)]
    table = "time [s],j_l_upper_arm [rad],j_r_upper_arm [rad]\n" + "".join(f"{t},{a},{b}\n" for t, a, b in rows)
    (tmp_path / "gait.csv").write_text(table)
    text = f"""
ROWS = {rows!r}
SAME = 1e-9

def at(column, time):
    last = [i for i, row in enumerate(ROWS) if row[0] <= time + SAME][-1]
    since = time - ROWS[last][0]
    if last + 1 == len(ROWS) or since <= SAME:
        return ROWS[last][column]
    share = since / (ROWS[last + 1][0] - ROWS[last][0])
    return ROWS[last][column] + share * (ROWS[last + 1][column] - ROWS[last][column])

class Player:
    rate = 100.0
    writes = ("motion_time", "joint_target")

    def start(self, robot, time):
        robot.motion_time = 0.0
        self.write(robot)

    def __call__(self, robot, time):
        robot.motion_time = min(float(robot.motion_time[0]) + 0.01, ROWS[-1][0])
        self.write(robot)

    def write(self, robot):
        robot.joint_target = 0.0
        for column, joint in ((1, "j_l_upper_arm"), (2, "j_r_upper_arm")):
            robot.joint_target[joint] = at(column, float(robot.motion_time[0]))
"""
    scene = scene_of(tmp_path, text, "Player")
    built_in = tmp_path / "built_in.toml"
    own = scene.read_text()
    built_in.write_text(
        own.replace('controller = "python"', 'controller = "trajectory"\ncontrol_rate = 100').replace(
            'class = "soft:Player"', 'file = "gait.csv"'
        )
    )
    for level in ("articulated_dynamics", "simplified_dynamics", "kinematic_walking"):
        by_class = ms.Scene(str(scene), libraries=True, set={"r0.level": level})
        by_built_in = ms.Scene(str(built_in), set={"r0.level": level})
        for one in (by_class, by_built_in):
            one.run(0.4)
        for name in ("joint_position", "joint_velocity", "joint_torque", "joint_target", "position"):
            np.testing.assert_array_equal(getattr(by_class["r0"], name), getattr(by_built_in["r0"], name))
        assert abs(by_class["r0"].joint_target["j_l_upper_arm"]) > 0.02
        if level == "articulated_dynamics":  # elsewhere software of all kinds has a column more: torques that there are not
            assert by_class.state_hash == by_built_in.state_hash


def test_an_exception_freezes_its_robot_and_no_other(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    text = WAVE.replace(
        "        self.calls += 1",
        "        self.calls += 1\n        if robot.name == 'r0' and self.calls > 10:\n            self.fail()",
    )
    text += "\n    def fail(self):\n        raise ValueError('out of ideas')\n"
    scene = scene_of(tmp_path, text, "Wave", robots=2)
    found = report(scene, "--libraries")
    first, second = found["control"]
    line = text.split("\n").index("        raise ValueError('out of ideas')") + 1
    why = f"class 'soft:Wave' of r0: its step raised {tmp_path}/soft.py:{line}: ValueError: out of ideas"
    assert first["ended"] == f"at 0.200 s: {why}"
    assert first["calls"] == 11
    said = [one["text"] for one in first["said"]]
    assert said[0] == "Traceback (most recent call last):"
    assert any("in fail" in one for one in said)
    assert said[-1] == "ValueError: out of ideas"
    assert second["ended"] == ""
    assert second["calls"] == 25
    assert any(why in one for one in found["warnings"])
    frozen, whole = ms.Scene(str(scene), libraries=True), ms.Scene(str(scene), libraries=True)
    frozen.run(0.5)
    assert capfd.readouterr().err.endswith("ValueError: out of ideas\n")
    whole.run(0.19)
    np.testing.assert_array_equal(frozen["r0"].joint_target, whole["r0"].joint_target)
    assert frozen["r0"].level == "simplified_dynamics"


def test_prints_into_the_report(tmp_path: Path) -> None:
    text = "print('imported')\nclass A:\n    def __init__(self): print('made')\n"
    text += "    def __call__(self, robot, time):\n        if time == 0.1: print('half', 'way', end=''); print(' there')\n"
    found = report(scene_of(tmp_path, text, "A"), "--libraries")
    said = [(one["time_s"], one["text"]) for one in found["control"][0]["said"]]
    assert said == [(0, "imported"), (0, "made"), (0.1, "half way there")]


BEGIN = "class A:\n    def __call__(self, robot, time): pass\n"
CANNOT = "module 'soft' cannot be imported: DIR/soft.py"
FAILS = "class A:\n    def __init__(self):\n        self.x = 1 / 0\n"


@pytest.mark.parametrize(
    ("text", "cls", "options", "line"),
    [
        (BEGIN, "B", "", "soft.py:1: no class 'B' in it"),
        (BEGIN, "A", ", speed = 1", "soft.py:1: A has no options, so 'speed' is none"),
        ("import nosuch\n" + BEGIN, "A", "", f"{CANNOT}:1: ModuleNotFoundError: No module named 'nosuch'"),
        ("\n\n1 +\n", "A", "", f"{CANNOT}:3: SyntaxError: invalid syntax"),
        ("import sys\nsys.exit(3)\n", "A", "", f"{CANNOT}:2: SystemExit: 3"),
        (BEGIN + "    reads = 'joint_positon'\n", "A", "", "soft.py:1: reads 'joint_positon': unknown property"),
        (BEGIN + "    reads = 'joint_positon'\n", "A", "", "; did you mean 'joint_position'?"),
        (BEGIN + "    writes = ('walk.velocty',)\n", "A", "", "soft.py:1: writes 'walk.velocty': unknown command"),
        (BEGIN + "    writes = ('walk.velocty',)\n", "A", "", "; did you mean 'walk.velocity'?"),
        (BEGIN + "    reads = ('r0.nothing',)\n", "A", "", "soft.py:1: reads 'r0.nothing': unknown property 'nothing'"),
        (BEGIN + "    phase = 'motion'\n", "A", "", "soft.py:1: 'motion' is no phase of a class"),
        (FAILS, "A", "", "soft.py:3: ZeroDivisionError: division by zero"),
    ],
)
def test_mistakes_are_said_in_one_line_with_their_place(tmp_path: Path, text: str, cls: str, options: str, line: str) -> None:
    scene = scene_of(tmp_path, text, cls, options)
    with pytest.raises(ms.InputError) as wrong:
        ms.Scene(str(scene), libraries=True)
    said = str(wrong.value)
    assert line.replace("DIR", str(tmp_path)) in said
    assert said.startswith(f"{scene}:3:1: ")
    assert "\n" not in said


def each(lines: list[str]) -> str:
    """A class that does one thing at 0.1 s, for each robot another one."""
    does = "".join(f"        if time == 0.1 and robot.name == 'r{i}':\n            {line}\n" for i, line in enumerate(lines))
    return f"class A:\n    def __call__(self, robot, time):\n{does}"


def test_wrong_numbers_and_names_end_it(tmp_path: Path) -> None:
    wrong = [
        ("robot.joint_target['j_l_shin'] = float('nan')", "soft.py:1: 'joint_target' of j_l_shin was set to nan"),
        ("robot.joint_target['j_l_chin'] = 0", "KeyError: \"there is no 'j_l_chin' in it; did you mean 'j_l_shin'?\""),
        ("robot.joint_position[0] = 1", "soft.py:8: ValueError: 'joint_position' is only read: name it in writes"),
        ("robot.joint_torque", "AttributeError: 'joint_torque' is not among the properties that the class declares"),
        ("robot.joint_target[:] = [1, 2]", "soft.py:12: ValueError: could not broadcast"),
    ]
    text = each([line for line, _ in wrong])
    control = report(scene_of(tmp_path, text, "A", robots=len(wrong)), "--libraries")["control"]
    for robot, (_, message) in zip(control, wrong, strict=True):
        assert message in robot["ended"]
    starts = BEGIN + "    def start(self, robot, time):\n        robot.joint_target[:] = [1, 2]\n"
    refused = run(scene_of(tmp_path, starts, "A"), "--libraries", expect=2).stderr
    assert f"class 'soft:A' of r0: its start raised {tmp_path}/soft.py:4: ValueError: could not broadcast" in refused
    assert refused.count("\n") == 1


def test_needs_allowance_unless_the_command_line_names_it(tmp_path: Path) -> None:
    scene = scene_of(tmp_path, "open('ran', 'w')\n" + BEGIN, "A")
    done = run(scene, expect=2)
    assert f"{scene}:9:20: this file has control software loaded, 'soft:A'" in done.stderr
    assert "--libraries" in done.stderr
    with pytest.raises(ms.InputError, match="--libraries"):
        ms.Scene(str(scene))
    # an option of the command line does not make the file's class one of the command line
    text = scene.read_text().replace('"soft:A"}', '"soft:A", x = 1}')
    scene.write_text(text)
    assert "--libraries" in run(scene, "--set", "r0.options.x=2", expect=2).stderr
    assert not Path("ran").exists()
    (tmp_path / "mine.py").write_text(WAVE)
    named = ["--set", "walker.controller=python", "--set", f"walker.options.class={tmp_path}/mine.py:Wave"]
    assert report("walk", "--duration", "0.1", *named)["control"][0]["calls"] == 5


def test_reads_sensors_and_other_entities_and_commands_the_walk(tmp_path: Path) -> None:
    text = """
class Chase:
    rate = 50.0
    reads = ("imu.gyroscope", "ball.position", "position")
    writes = ("walk.velocity",)
    def __call__(self, robot, time):
        assert robot.signals["imu.gyroscope"].shape == (3,)
        assert robot.signals["ball.position"].shape == (1, 3)
        assert robot.position.shape == (len(robot.objects), 3)
        robot.commands["walk.velocity"] = (0.2, 0, 0)
        if time == 0.9:
            print(robot.signals["ball.position"][0, 0])
"""
    scene = scene_of(tmp_path, text, "Chase", more="")
    scene.write_text(scene.read_text() + "[ball]\nposition = [1.5, 0.0]\n")
    loaded = ms.Scene(str(scene), libraries=True, set={"r0.level": "kinematic_walking"})
    loaded.run(3.0)
    assert loaded["r0"].position[0] > 0.2
    assert report(scene, "--libraries", "--duration", "1")["control"][0]["said"][0]["text"] == "1.5"


def test_forces_of_its_own_in_the_phase_of_contacts(tmp_path: Path) -> None:
    text = """
class Wind:
    phase, rate = "contact", 1000.0
    writes = ("applied_force",)
    def __call__(self, robot, time):
        robot.applied_force[0, 0] = (5.0, 0, 0)
"""
    scene = ms.Scene(str(scene_of(tmp_path, text, "Wind")), libraries=True)
    scene.run(0.2)
    base = scene["r0"].objects.names[0]
    assert scene["r0"][base]["applied_force"][0] == 5


def test_goes_back_in_time_and_begins_again(tmp_path: Path) -> None:
    for text in (WAVE, WAVE.split("    def save")[0]):
        scene = ms.Scene(str(scene_of(tmp_path, text, "Wave")), libraries=True)
        first = scene.state_hash
        scene.run(0.2)
        saved = scene.save()
        scene.run(0.2)
        end = scene.state_hash
        scene.reset()
        assert scene.state_hash == first
        scene.run(0.4)
        assert scene.state_hash == end
        if "def save" in text:
            scene.load(saved)
            scene.run(0.2)
            assert scene.state_hash == end


def test_batches_have_classes_too(tmp_path: Path) -> None:
    (tmp_path / "soft.py").write_text(WAVE)
    named = {
        "walker.controller": "python",
        "walker.options.class": f"{tmp_path}/soft.py:Wave",
        "walker.level": "simplified_dynamics",
    }
    batch = ms.Batch("walk", 3, threads=2, set=named, seed=4)
    batch.step(200)
    for i in range(3):
        alone = ms.Scene("walk", set=named, seed=4 + i)
        alone.run(0.2)
        assert batch[i].state_hash == alone.state_hash


def test_knows_the_seed_of_the_run(tmp_path: Path) -> None:
    text = "class A:\n    def start(self, robot, time): robot.joint_target[0] = 0.001 * robot.seed\n"
    scene = ms.Scene(str(scene_of(tmp_path, text + BEGIN.split("\n")[1] + "\n", "A")), libraries=True, seed=3)
    assert scene["r0"].joint_target[0] == 0.003
    scene.reset(seed=7)
    assert scene["r0"].joint_target[0] == 0.007


def test_a_call_without_end_is_ended(tmp_path: Path) -> None:
    text = "import time as clock\nclass A:\n    def __call__(self, robot, time):\n        while time > 0.1:\n            pass\n"
    scene = scene_of(tmp_path, text, "A", more="call_budget = 0.01\n")
    begin = time.monotonic()
    control = report(scene, "--libraries", "--threads", 2)["control"]
    assert time.monotonic() - begin < 20
    assert "its step did not come back within 1 s" in control[0]["ended"]
    assert "soft.py:" in control[0]["ended"]


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_ends_a_call_without_end(tmp_path: Path, threads: int) -> None:
    text = f"class A:\n    def __call__(self, robot, time):\n        open('{tmp_path}/in', 'w').close()\n"
    text += "        while True: pass\n"
    scene = scene_of(tmp_path, text, "A", robots=2)
    arguments = [program(), "run", str(scene), "--libraries", "--json", "-", "--threads", str(threads)]
    with subprocess.Popen(arguments, stdout=subprocess.PIPE, text=True) as running:
        deadline = time.monotonic() + 30
        while not (tmp_path / "in").exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        running.send_signal(signal.SIGINT)
        output = running.communicate(timeout=5)[0]  # the limit of a call is 10 s
    assert running.returncode == 130
    assert json.loads(output)["stopped"]["by"] == "SIGINT"


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_in_the_package_ends_a_call_without_end(tmp_path: Path, threads: int) -> None:
    text = "class A:\n    def __call__(self, robot, time):\n        if robot.name == 'r1':\n"
    text += f"            open('{tmp_path}/in', 'w').close()\n            while True: pass\n"
    scene = scene_of(tmp_path, text, "A", robots=2)
    script = f"import murosimf as ms\ns = ms.Scene('{scene}', libraries=True, threads={threads})\n"
    script += "try:\n    s.run(1.0)\nexcept KeyboardInterrupt:\n    print('interrupted at', s.time)\n"
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as running:
        deadline = time.monotonic() + 30
        while not (tmp_path / "in").exists() and time.monotonic() < deadline:
            time.sleep(0.01)
        running.send_signal(signal.SIGINT)
        output = running.communicate(timeout=5)[0]  # the limit of a call is 10 s
    assert output.startswith("interrupted at 0.0")


def test_ctrl_c_in_the_package_is_a_keyboard_interrupt(tmp_path: Path) -> None:
    text = "import _thread\nclass A:\n    def __call__(self, robot, time):\n        if time == 0.2 and not hasattr(A, 'was'):\n"
    text += "            A.was = True\n            _thread.interrupt_main()\n            while True: pass\n"
    scene = ms.Scene(str(scene_of(tmp_path, text, "A")), libraries=True)
    with pytest.raises(KeyboardInterrupt):
        scene.run(0.4)
    scene.run(0.4)  # goes on
    assert scene.time >= 0.4


def test_mischief_is_noticed_or_harmless(tmp_path: Path) -> None:
    mischief = [
        ("import sys; sys.exit(3)", "SystemExit: 3"),
        ("raise KeyboardInterrupt", "KeyboardInterrupt"),
        ("f = lambda: f(); f()", "RecursionError"),
        ("import threading; threading.Thread(target=print, args=('x',)).start()", ""),
        ("import threading, time as c; threading.Thread(target=c.sleep, args=(60,), daemon=True).start()", ""),
        ("import os; os.fork() or os._exit(0)", ""),
        ("import os; os.fork()", ""),
        ("import subprocess; subprocess.run(['true'], check=True)", ""),
    ]
    scene = scene_of(tmp_path, each([line for line, _ in mischief]), "A", robots=len(mischief))
    control = report(scene, "--libraries", "--threads", 2)["control"]
    for robot, (_, ended) in zip(control, mischief, strict=True):
        assert ended in robot["ended"]
        assert bool(ended) == bool(robot["ended"])
        assert robot["calls"] == (11 if ended else 50)


def test_an_end_of_the_process_in_it_ends_the_run_with_its_reports(tmp_path: Path) -> None:
    for line, what in [("os._exit(7)", "called _exit(7)"), ("os.kill(os.getpid(), 11)", "crashed (SIGSEGV)")]:
        text = f"import os\nclass A:\n    def __call__(self, robot, time):\n        if time == 0.1: {line}\n"
        done = run(scene_of(tmp_path, text, "A", robots=2), "--libraries", "--json", "-", "--threads", 2, expect=3)
        assert f"class 'soft:A' of r0: its step {what}" in done.stderr + done.stdout
        assert json.loads(done.stdout)["stopped"]["by"] == "a crash"


def test_scenes_in_several_threads_do_not_wait_for_each_other(tmp_path: Path) -> None:
    path = scene_of(tmp_path, WAVE, "Wave", robots=2)
    hashes = []

    def play(threads: int) -> None:
        scene = ms.Scene(str(path), libraries=True, threads=threads)
        for seed in range(3):
            scene.reset(seed=seed)
            scene.run(0.05)
            other = copy.copy(scene)
            for one in (scene, other):
                one.run(0.05)
            assert other.state_hash == scene.state_hash
        hashes.append(scene.state_hash)

    players = [threading.Thread(target=play, args=(threads,), daemon=True) for threads in (1, 2, 2, 1)]
    for player in players:
        player.start()
    for player in players:
        player.join(timeout=30)
    assert len(hashes) == 4
    assert len(set(hashes)) == 1


def test_forked_children_go_on(tmp_path: Path) -> None:
    scene = ms.Scene(str(scene_of(tmp_path, WAVE, "Wave")), libraries=True)
    scene.run(0.1)
    child = os.fork()
    if child == 0:
        try:
            scene.run(0.1)
            os._exit(17 if scene.time >= 0.2 else 1)
        finally:
            os._exit(1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 17
    scene.run(0.1)


def test_a_changed_module_is_loaded_anew(tmp_path: Path) -> None:
    path = scene_of(tmp_path, WAVE, "Wave")
    first = ms.Scene(str(path), libraries=True)
    (tmp_path / "soft.py").write_text(WAVE.replace("rate = 50.0", "rate = 50.0 + 0.0").replace("0.1\n", "0.2\n"))
    second = ms.Scene(str(path), libraries=True)
    assert first["r0"].joint_target["j_l_upper_arm"] == 0.1
    assert second["r0"].joint_target["j_l_upper_arm"] == 0.2


def test_arrays_outlive_their_scene(tmp_path: Path) -> None:
    counts = "        self.calls += 1\n"
    text = "KEPT = []\n" + WAVE.replace(counts, counts + "        KEPT.append(robot.joint_target)\n")
    scene = ms.Scene(str(scene_of(tmp_path, text, "Wave")), libraries=True)
    scene.run(0.1)
    import soft  # type: ignore[import-not-found]

    kept = soft.KEPT[-1]
    before = kept.copy()
    del scene
    kept[0] = 3
    np.testing.assert_array_equal(kept[1:], before[1:])


def test_examples_play(root: Path) -> None:
    scenes = sorted((root / "examples/python/controllers").glob("*.toml"))
    assert scenes
    for scene in scenes:
        control = report(scene, "--libraries", "--duration", 1)["control"][0]
        assert control["ended"] == ""
        assert control["calls"] > 0
        loaded = ms.Scene(str(scene), libraries=True)
        loaded.run(1.0)
        assert not loaded.robot.fallen


def test_a_new_one_is_made_and_plays(tmp_path: Path, root: Path) -> None:
    shutil.copytree(root / "scripts/templates", tmp_path / "scripts/templates")
    shutil.copy(root / "scripts/new", tmp_path / "scripts/new")
    subprocess.run([sys.executable, tmp_path / "scripts/new", "python-controller", "nod_twice"], check=True, capture_output=True)
    control = report(tmp_path / "examples/python/controllers/nod_twice.toml", "--libraries", "--duration", 0.2)["control"][0]
    assert (control["ended"], control["calls"]) == ("", 20)
