"""Experiments on clusters: Slurm arrays, Dask and Ray run the shards of a manifest. All machines need the package, and the folder
of the manifest under the same name. A worker may die at any moment: its shard is tried again elsewhere, and goes on with the runs
that are missing."""

from __future__ import annotations

import shlex
import sys
from collections.abc import Iterable
from typing import Any

from ._optional import optional
from .experiment import Experiment, run_shard

tries = 5  # of a shard whose worker dies


def slurm_script(experiment: Experiment, *, shards: int, threads: int = 1, options: Iterable[str] = ()) -> str:
    """For `sbatch`: an array of `shards` jobs. `options`: for Slurm, like "--time=1:00:00". After it, experiment.table()."""
    lines = [f"--array=1-{shards}", f"--cpus-per-task={threads}", "--requeue", *options]
    command = [sys.executable, "-m", "murosimf", "sweep", str(experiment.manifest), "--threads", str(threads), "--shard"]
    head = "".join(f"#SBATCH {line}\n" for line in lines)
    return f'#!/bin/sh\n{head}exec {shlex.join(command)} "$SLURM_ARRAY_TASK_ID/{shards}"\n'


def on_dask(experiment: Experiment, client: Any, *, shards: int, threads: int = 1) -> dict[str, Any]:
    """Runs all shards on the workers of a distributed.Client, and returns the table. Raises what a shard raised."""
    tasks = client.map(run_shard, [str(experiment.manifest)] * shards, experiment.shards(shards), [threads] * shards,
                       pure=False, retries=tries)
    client.gather(tasks)
    return experiment.table()


def on_ray(experiment: Experiment, *, shards: int, threads: int = 1) -> dict[str, Any]:
    """Runs all shards on the Ray cluster of this process (ray.init()), and returns the table. Raises StateError without the
    package ray, and what a shard raised."""
    ray = optional("ray", "ray")
    task = ray.remote(num_cpus=threads, max_retries=tries)(run_shard)
    ray.get([task.remote(str(experiment.manifest), shard, threads) for shard in experiment.shards(shards)])
    return experiment.table()
