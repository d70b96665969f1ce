#!/usr/bin/env python3
"""Steps of vector environments per second, with actions, observations, rewards and the worlds that begin again: control at 50 Hz,
so each is 20 steps of the simulation at 1 kHz, or 10 at 500 Hz.

    PYTHONPATH=build/release/python python benchmarks/python/env_steps.py

Needs gymnasium. Rates are by processor time and by wall time, each the best of 5 turns of all cases.
"""

import argparse
import time

import gymnasium
import murosimf.envs  # noqa: F401  registers the environments
import numpy as np

settings = {"simplified, 500 Hz": {"level": "simplified_dynamics", "rate": 500},
            "simplified, 1 kHz": {"level": "simplified_dynamics", "rate": 1000},
            "articulated, 1 kHz": {"level": "articulated_dynamics", "rate": 1000}}


def case(task, worlds, threads, setting):
    env = gymnasium.make_vec(f"murosimf/{task}-v0", num_envs=worlds, vectorization_mode="vector_entry_point", threads=threads,
                             **setting)
    env.reset(seed=1)
    random = np.random.default_rng(1)
    actions = random.uniform(-0.1, 0.1, (16, *env.action_space.shape)).astype(np.float32)

    def run(steps):
        """Environment steps per second of the processor and of the clock."""
        processor, wall = time.process_time(), time.perf_counter()
        for step in range(steps):
            env.step(actions[step % 16])
        return worlds * steps / np.array([time.process_time() - processor, time.perf_counter() - wall])

    return run


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--worlds", type=int, nargs="+", default=[64, 256, 1024])
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    cases = {(task, worlds, name): case(task, worlds, options.threads, setting) for worlds in options.worlds
             for task, names in (("WalkVelocity", settings), ("Kick", ["simplified, 1 kHz"])) for name in names
             for setting in [settings[name]]}
    best = dict.fromkeys(cases, np.zeros(2))
    for _ in range(5):
        for key, run in cases.items():
            best[key] = np.maximum(best[key], run(max(4096 // key[1], 4)))
    for (task, worlds, name), (processor, wall) in best.items():
        print(f"{task:13} {worlds:5} worlds  {name:19} {processor:8.0f} a second of the processor, {wall:8.0f} of the clock")


if __name__ == "__main__":
    main()
