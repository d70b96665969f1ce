#!/usr/bin/env python3
"""Many worlds of one scene in MuJoCo, by its own means: `batch` (mujoco.batch), `rollout` (mujoco.rollout).

    benchmarks/peers/mujoco_worlds.py FOLDER --setting batch --worlds 100 --threads 2 --seconds 1

Prints the same line of JSON as murosimf_peer_worlds. Targets change every ten steps for all worlds at once: batch is called for
each of these cycles, rollout once for all of them.
"""
import argparse
import copy
import json
import pathlib
import time

from mujoco_peer import ROOT
from mujoco_scene import Race, integrators, mujoco, np


def state_of(race):
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    state = np.empty(mujoco.mj_stateSize(race.model, kind))
    mujoco.mj_getState(race.model, race.data, state, kind)
    return state


def by_batch(race, options, cycles):
    from mujoco import batch
    worlds = batch.Batch(race.model, nsim=options.worlds, nthread=options.threads)
    worlds.qpos = race.data.qpos
    ctrl = worlds.bind("ctrl")
    steps = race.description["steps_per_cycle"]

    def run(begin, end):
        for cycle in range(begin, end):
            ctrl[:] = race.control(cycle)
            worlds.step(nstep=steps)
    run(0, cycles[0])
    took = timed(lambda: run(cycles[0], sum(cycles)))
    return took, np.array(worlds.qpos)


def by_rollout(race, options, cycles):
    from mujoco import rollout
    steps = race.description["steps_per_cycle"]
    controls = np.repeat([race.control(cycle) for cycle in range(sum(cycles))], steps, axis=0)
    middle = cycles[0] * steps
    states = np.tile(state_of(race), (options.worlds, 1))
    datas = [copy.copy(race.data) for _ in range(options.threads)]
    with rollout.Rollout(nthread=options.threads if options.threads > 1 else 0) as worlds:
        def run(states, controls):
            every = np.broadcast_to(controls, (options.worlds, *controls.shape))
            return worlds.rollout(race.model, datas, states, np.ascontiguousarray(every))[0][:, -1]
        if middle:
            states = run(states, controls[:middle])
        result = []
        took = timed(lambda: result.append(run(states, controls[middle:])))
    return took, result[0][:, 1:1 + race.model.nq]  # after the time


def timed(work):
    processor, wall = time.process_time(), time.perf_counter()
    work()
    return time.process_time() - processor, time.perf_counter() - wall


WAYS = {"batch": by_batch, "rollout": by_rollout}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--robot", type=pathlib.Path, default=ROOT / "models/kid21.xml")
    parser.add_argument("--setting", choices=WAYS, default="batch")
    parser.add_argument("--integrator", choices=integrators(), default=integrators()[0])
    parser.add_argument("--worlds", type=int, default=100)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--warm", type=float, default=1)
    parser.add_argument("--seconds", type=float, default=1)
    options = parser.parse_args()
    race = Race(options.robot, options.folder / "description.json", options.integrator)
    cycle = race.description["step"] * race.description["steps_per_cycle"]
    cycles = [round(options.warm / cycle), max(1, round(options.seconds / cycle))]
    base, start = race.bases[0], race.description["robots"][0]["position"]
    (processor, wall), qpos = WAYS[options.setting](race, options, cycles)
    distances = np.hypot(qpos[:, base] - start[0], qpos[:, base + 1] - start[1])
    per_step = 1e6 / (cycles[1] * race.description["steps_per_cycle"] * options.worlds)
    print(json.dumps({"engine": f"MuJoCo {mujoco.__version__}", "setting": options.setting, "wall_us_per_step": per_step * wall,
                      "us_per_step": per_step * processor, "observed": {"distance_m": float(distances.mean())}}))


if __name__ == "__main__":
    main()
