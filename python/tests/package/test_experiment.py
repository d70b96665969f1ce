"""Experiments in shards: the same table for any number of shards, on any scheduler, whatever was killed."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from murosimf.cluster import on_dask, on_ray, slurm_script

import murosimf as ms

RUNS = {"scene": "walk", "results": ["walker.distance", "walker.falls", "walker.x"], "seeds": "1..25",
        "grid": {"walker.command.0": [0.1, 0.2]}, "duration": 5.0, "set": {"walker.level": "simplified_dynamics"}}


@pytest.fixture(scope="module")
def expected() -> dict:
    """The table of one sweep in one process."""
    return ms.sweep(**RUNS, threads=2)


@pytest.fixture
def experiment(tmp_path: Path) -> ms.Experiment:
    return ms.Experiment.plan(tmp_path / "walks.json", **RUNS)


def noted(experiment: ms.Experiment) -> Counter[str]:
    """How often each run was done, from the files of finished runs: a line for each, behind two lines of head."""
    folder = experiment.manifest.with_suffix(".runs")
    return Counter(line.split()[0] for file in folder.glob("*.txt") for line in file.read_text().splitlines()[2:])


def wait_for_runs(experiment: ms.Experiment, least: int) -> None:
    deadline = time.monotonic() + 60
    while sum(noted(experiment).values()) < least:
        assert time.monotonic() < deadline
        time.sleep(0.005)


def assert_whole(experiment: ms.Experiment, expected: dict) -> None:
    assert experiment.table() == expected
    assert noted(experiment) == Counter({str(run): 1 for run in range(50)})  # nothing lost, nothing twice


def test_the_manifest_lists_all_runs(experiment: ms.Experiment) -> None:
    assert len(experiment) == experiment.missing == 50
    assert experiment.runs[26] == {"seed": 2, "set": ["walker.command.0=0.2"]}
    document = json.loads(experiment.manifest.read_text())
    assert "/program/models/kid21.xml" in document["experiment"]["files"]
    with pytest.raises(ms.StateError, match="50 of 50 runs"):
        experiment.table()
    assert ms.Experiment.plan(experiment.manifest, **RUNS).runs == experiment.runs
    with pytest.raises(ms.InputError, match="not the manifest of this experiment"):
        ms.Experiment.plan(experiment.manifest, **{**RUNS, "duration": 1.0})


@pytest.mark.parametrize("shards", [1, 2, 7])
def test_any_number_of_shards(experiment: ms.Experiment, expected: dict, shards: int) -> None:
    for shard in reversed(experiment.shards(shards)):
        experiment.run(shard)
    assert_whole(experiment, expected)


def test_kills(experiment: ms.Experiment, expected: dict) -> None:
    """Workers that claim shards are killed again and again; each time others go on."""
    command = [sys.executable, "-m", "murosimf", "sweep", str(experiment.manifest), "--shard", "any/7", "--threads", "1"]
    for least in (3, 12, 30):
        workers = [subprocess.Popen(command, stdout=subprocess.DEVNULL) for _ in range(2)]
        wait_for_runs(experiment, least)
        for worker in workers:
            worker.kill()  # -9
            assert worker.wait() == -signal.SIGKILL
    assert 0 < experiment.missing < 50
    experiment.run("any/7")
    assert_whole(experiment, expected)


def test_refuses_what_does_not_belong_together(tmp_path: Path) -> None:
    scene = tmp_path / "mine.toml"
    scene.write_text('[[robots]]\nname = "walker"\nmodel = "kid21"\n')
    experiment = ms.Experiment.plan(tmp_path / "a.json", scene, results=["walker.z"], seeds=range(4), duration=0.1)
    experiment.run("1/2")
    scene.write_text(scene.read_text() + "position = [0, 0, 0.4]\n")
    with pytest.raises(ms.InputError, match=r"mine\.toml' has changed"):
        experiment.run("2/2")
    other = ms.Experiment.plan(tmp_path / "b.json", scene, results=["walker.z"], seeds=range(4), duration=0.1)
    (tmp_path / "a.runs").rename(tmp_path / "b.runs")
    with pytest.raises(ms.InputError, match=r"1_of_2\.txt: it is of another sweep"):
        other.run("2/2")
    with pytest.raises(ms.InputError, match=r"1_of_2\.txt: it is of another sweep"):
        other.table()
    text = experiment.manifest.read_text()
    experiment.manifest.write_text(text.replace('"seed": 3', '"seed": 4'))
    with pytest.raises(ms.InputError, match="was changed"):
        ms.Experiment(experiment.manifest)


def test_slurm(experiment: ms.Experiment, expected: dict, tmp_path: Path) -> None:
    """The script as Slurm runs it, once for each number of the array; one job is killed and requeued."""
    script = tmp_path / "walks.sh"
    script.write_text(slurm_script(experiment, shards=4, options=["--time=0:10:00"]))
    head = script.read_text().splitlines()
    assert head[:2] == ["#!/bin/sh", "#SBATCH --array=1-4"]
    assert "#SBATCH --time=0:10:00" in head

    def job(number: int) -> subprocess.Popen[bytes]:
        return subprocess.Popen(["sh", script], env={**os.environ, "SLURM_ARRAY_TASK_ID": str(number)},
                                stdout=subprocess.DEVNULL)

    killed = job(2)
    wait_for_runs(experiment, 2)
    killed.kill()  # `exec` has made it the program
    killed.wait()
    for number in (1, 2, 3, 4):
        assert job(number).wait() == 0
    assert_whole(experiment, expected)


def kill_with_children(process: int) -> None:
    """As the kernel does when a machine has no memory left."""
    psutil = pytest.importorskip("psutil")
    worker = psutil.Process(process)
    for each in [worker, *worker.children(recursive=True)]:
        each.kill()


@pytest.mark.parametrize("with_program", [True, False])
def test_dask(experiment: ms.Experiment, expected: dict, with_program: bool) -> None:
    """A worker is killed in the middle: with the program that it runs, and without, which goes on then."""
    distributed = pytest.importorskip("distributed", reason="no Dask here: pip install distributed")
    with (distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster,
          distributed.Client(cluster) as client):
        victim = next(iter(client.run(os.getpid).values()))
        tables = []
        thread = threading.Thread(target=lambda: tables.append(on_dask(experiment, client, shards=5)))
        thread.start()
        wait_for_runs(experiment, 5)
        assert experiment.missing > 0
        kill_with_children(victim) if with_program else os.kill(victim, signal.SIGKILL)
        thread.join(60)
    assert tables == [expected]
    assert_whole(experiment, expected)


def test_ray(experiment: ms.Experiment, expected: dict, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "0")  # it asks nobody on the network
    ray = pytest.importorskip("ray", reason="no Ray here (240 MB unpacked): pip install ray")
    ray.init(num_cpus=2, include_dashboard=False, logging_level="error", log_to_driver=False, _node_ip_address="127.0.0.1")
    try:
        tables = []
        thread = threading.Thread(target=lambda: tables.append(on_ray(experiment, shards=5)))
        thread.start()
        wait_for_runs(experiment, 5)
        assert experiment.missing > 0
        kill_with_children(worker_of(experiment))
        thread.join(120)
    finally:
        ray.shutdown()
    assert tables == [expected]
    assert_whole(experiment, expected)


def worker_of(experiment: ms.Experiment) -> int:
    """The parent of a program that works on this experiment."""
    psutil = pytest.importorskip("psutil")
    for process in psutil.process_iter(["cmdline", "ppid"]):
        if str(experiment.manifest) in (process.info["cmdline"] or []):
            return process.info["ppid"]
    raise AssertionError("nobody works on the experiment")


def test_tables_of_columns(tmp_path: Path) -> None:
    table = {"axes": ["a.level", "a.mass"], "results": ["x [m]", "falls"],
             "runs": [{"values": ["full", "1"], "seed": 2**63, "results": [0.1, 0]},
                      {"values": ["rough", "2.5"], "seed": 2, "results": ["NaN", 1]}]}
    got = ms.columns(table)
    assert list(got) == ["a.level", "a.mass", "seed", "x [m]", "falls"]
    assert list(got["a.level"]) == ["full", "rough"]
    assert list(got["a.mass"]) == [1, 2.5]
    assert list(got["seed"]) == [2**63, 2]
    assert np.isnan(got["x [m]"][1])

    parquet = pytest.importorskip("pyarrow.parquet", reason="no pyarrow here: pip install pyarrow")
    ms.write_parquet(tmp_path / "runs.parquet", table)
    read = parquet.read_table(tmp_path / "runs.parquet").to_pydict()
    assert list(read) == list(got)
    assert read["seed"] == [2**63, 2]
    assert read["a.level"] == ["full", "rough"]
    assert read["x [m]"][0] == 0.1
    records = np.array([(0.1, 2.0), (0.2, 3.0)], dtype=[("time", float), ("walker.z", float)])
    ms.write_parquet(tmp_path / "z.parquet", records)
    assert parquet.read_table(tmp_path / "z.parquet").to_pydict() == {"time": [0.1, 0.2], "walker.z": [2.0, 3.0]}
