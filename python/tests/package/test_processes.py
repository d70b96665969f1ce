"""Threads, signals and forks."""

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable

import numpy as np
import pytest

import murosimf as ms


def test_another_thread_is_refused_while_a_scene_runs() -> None:
    scene, goes_on = ms.Scene("three_on_three"), 0
    thread = threading.Thread(target=scene.run, args=(20.0,))
    thread.start()
    refusals = 0
    while thread.is_alive():
        goes_on += 1
        try:
            scene.step()
        except ms.StateError as error:
            assert "in use in another thread" in str(error)
            refusals += 1
        time.sleep(0.001)
    thread.join()
    assert refusals > 0
    assert goes_on > 5  # the lock of the interpreter was free


def rounds_during(call: Callable[[], object]) -> int:
    """How often this thread gets the lock while another one makes a call."""
    thread, loops = threading.Thread(target=call), 0
    thread.start()
    while thread.is_alive():
        loops += 1
        time.sleep(0)
    thread.join()
    return loops


def test_the_lock_of_the_interpreter_is_free_in_all_long_calls() -> None:
    # one call of C++ each, in which a thread that holds the lock would let no other one do a single round
    kinematics = ms.Scene.of_robot("kid21").robot.kinematics
    q = np.zeros((30_000, 21))
    batch = ms.Batch("walk", 64, set={"walker.controller": "none"})
    calls: dict[str, Callable[[], object]] = {
        "fk": lambda: kinematics.fk(q, "head"),
        "center_of_mass": lambda: kinematics.center_of_mass(q),
        "jacobian": lambda: kinematics.jacobian(q, "head"),
        "mass_matrix": lambda: kinematics.mass_matrix(q[:5000]),
        "rnea": lambda: kinematics.rnea(q, q, q),
        "open": lambda: ms.Scene("eleven_a_side"),
        "batch.reset": lambda: batch.reset(),
        "batch.step": lambda: batch.step(20),
    }
    for name, call in calls.items():
        # on a busy machine this thread may sleep through a call
        assert any(rounds_during(call) > 20 for _ in range(20)), name


def test_two_scenes_run_in_two_threads() -> None:
    scenes = [ms.Scene("walk", seed=seed) for seed in (1, 1)]
    threads = [threading.Thread(target=scene.run, args=(2.0,)) for scene in scenes]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert scenes[0].state_hash == scenes[1].state_hash


@pytest.mark.parametrize("call", ["ms.Scene('three_on_three').run(1e6)", "ms.Scene('three_on_three').step(10**9)",
                                  "ms.Batch('walk', 8, threads=2).step(10**9)"])
def test_ctrl_c(call: str) -> None:
    code = (f"import murosimf as ms\nprint('runs', flush=True)\ntry:\n    {call}\n"
            "except KeyboardInterrupt:\n    print('interrupted')\n")
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        assert process.stdout.readline() == "runs\n"
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=20)
        assert output == "interrupted\n"
        assert process.returncode == 0


def child_of(made: object) -> str:
    """What a forked child says when it steps that."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            made.step()  # type: ignore[attr-defined]
            text = "stepped"
        except ms.StateError as error:
            text = str(error)
        os.write(writer, text.encode())
        del made
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as pipe:
        text = pipe.read()
    assert os.waitpid(child, 0)[1] == 0
    return text


def test_forked_children() -> None:
    assert child_of(ms.Scene("walk")) == "stepped"
    assert "threads, which are not here" in child_of(ms.Scene("walk", threads=2))
    assert "threads, which are not here" in child_of(ms.Batch("walk", 2, threads=2))


def hash_after(seed: int) -> int:
    scene = ms.Scene("walk", seed=seed, threads=2)
    scene.run(0.2)
    return scene.state_hash


def test_pools_of_processes() -> None:
    parent = ms.Scene("walk", threads=2)  # has threads while others are forked
    parent.step()
    with multiprocessing.get_context("fork").Pool(2) as pool:
        hashes = pool.map(hash_after, [4, 4, 4, 4])
    assert set(hashes) == {hash_after(4)}


def test_import_brings_no_gymnasium() -> None:
    code = "import murosimf, sys; print('gymnasium' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "False\n"
