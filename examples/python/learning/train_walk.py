#!/usr/bin/env python3
"""Trains kid21 to walk with a velocity that is asked for: at simplified_dynamics with 500 Hz first, then at
articulated_dynamics with 1 kHz. Writes the policy (ONNX, and NPZ to go on from) and a log (JSON).

    PYTHONPATH=build/release/python python3 examples/python/learning/train_walk.py --out out/learn

Needs gymnasium and onnx; runs on one thread beside those of the simulation (--threads).
"""

import argparse
import json
import os
import time
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy: its threads would take those of the simulation

import gymnasium
import murosimf.envs  # noqa: F401  registers the environments
import numpy as np
from onnx_file import write_onnx
from ppo import Learner, Policy, Settings

cheap = {"level": "simplified_dynamics", "rate": 500}
full = {"level": "articulated_dynamics", "rate": 1000}


def make(task, worlds, threads, settings):
    return gymnasium.make_vec(f"murosimf/{task}-v0", num_envs=worlds, vectorization_mode="vector_entry_point", threads=threads,
                              **settings)


def train(learner, stage, begin, seconds, most, log):
    """At most so many updates, until so many seconds of wall time since `begin`; a line of the log for each 10 updates."""
    ended, updates, steps = [], 0, 0
    while time.monotonic() - begin < seconds and updates < most:
        samples, more = learner.collect()
        learner.update(samples)
        ended += more
        updates += 1
        steps += samples[2].size
        if updates % 10 == 0:
            log.append(line(learner, stage, begin, steps, ended))
            print(json.dumps(log[-1]), flush=True)
            ended = []
    return steps


def line(learner, stage, begin, steps, ended):
    returns, lengths, falls = (np.array(each, float) for each in zip(*ended, strict=True)) if ended else [np.zeros(1)] * 3
    return {
        "stage": stage, "wall_s": round(time.monotonic() - begin, 1), "processor_s": round(time.process_time(), 1),
        "env_steps": steps, "episodes": len(ended), "return": round(float(returns.mean()), 2),
        "reward_per_step": round(float(returns.sum() / max(lengths.sum(), 1)), 4),
        "falls_per_minute": round(float(60 * falls.sum() / max(lengths.sum() / 50, 1)), 2),
        "deviation": round(float(np.exp(learner.policy.log_deviation).mean()), 3), "rate": learner.adam.rate,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="folder")
    parser.add_argument("--minutes", type=float, default=12, help="wall time, of which half at articulated_dynamics")
    parser.add_argument("--updates", type=int, default=10**9, help="of each stage at most")
    parser.add_argument("--worlds", type=int, default=128)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--start", type=Path, help="NPZ file of a policy to go on from")
    parser.add_argument("--stage", choices=("simplified", "articulated"), help="this one alone, all the time")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    settings, log, begin = Settings(), [], time.monotonic()
    policy, total = None, {}
    for stage, world, share in (("simplified", cheap, 0.5), ("articulated", full, 1.0)):
        if options.stage not in (None, stage):
            continue
        env = make("WalkVelocity", options.worlds, options.threads, world)
        if policy is None:
            policy = Policy(env.single_observation_space.shape[0], env.single_action_space.shape[0], settings, options.seed)
            if options.start:
                policy.load(options.start)
        learner = Learner(env, policy, settings, options.seed)
        seconds = 60 * options.minutes * (1.0 if options.stage else share)
        total[stage] = train(learner, stage, begin, seconds, options.updates, log)
        policy.save(options.out / f"walk_{stage}.npz")
        write_onnx(policy, options.out / "walk.onnx")
    summary = {"seed": options.seed, "worlds": options.worlds, "env_steps": total, "processor_s": round(time.process_time(), 1),
               "wall_s": round(time.monotonic() - begin, 1), "curve": log}
    (options.out / "log.json").write_text(json.dumps(summary, indent=0) + "\n")


if __name__ == "__main__":
    main()
