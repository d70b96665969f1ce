"""Many worlds of one walking robot: ours in a pool of threads, MuJoCo's batch and rollout; one thread and all."""
import os
import pathlib
import tempfile

import scenes
from contest import Entrant, in_turns, ratios
from running import HERE, Failure, run
from steps import LEVELS, describe


def entrants(machine, folder, threads, worlds, warm, seconds):
    ends = ["--worlds", worlds, "--threads", threads, "--warm", warm, "--seconds", seconds]

    def command(start, setting):
        return lambda _observe: [*start, folder, "--setting", setting, *ends]

    own = [machine.own("murosimf_peer_worlds")]
    found = [Entrant("MuRoSimF", level, command(own, level), ours=True) for level in LEVELS]
    for module in ("batch", "rollout"):
        if machine.has_module(f"mujoco.{module}"):
            found.append(Entrant("MuJoCo", module, command([machine.python, HERE / "mujoco_worlds.py"], module)))
        else:
            machine.miss(f"mujoco.{module}: this version of MuJoCo does not have it, or there is none")
    return found


def race(machine, options, folder, threads):
    worlds, warm, seconds = (4, 0.1, 0.1) if options.quick else (100, 0.5, options.length)
    describe(machine, folder, warm + seconds)
    key = "us_per_step" if threads == 1 else "wall_us_per_step"
    finished = in_turns(entrants(machine, folder, threads, worlds, warm, seconds), run, key, options.rounds)
    if not finished:
        raise Failure("no program finished")
    print(f"\n{worlds} worlds of a walking robot, {threads} threads, us of {'processor' if threads == 1 else 'wall'} time per step of "
          "one world\n| engine | us | times | world steps per second | distance m |\n|---|---|---|---|---|")
    rows = []
    for entrant in finished:
        middle, least, most = ratios(entrant, finished[0])
        row = entrant.to_json()
        print(f"| {entrant.label} | {row['median']:.2f} | {middle:.2f} ({least:.2f} to {most:.2f}) | {1e6 / row['median']:,.0f} "
              f"| {entrant.observed['distance_m']:.3f} |", flush=True)
        rows.append(row | {"scene": f"{worlds} worlds", "threads": threads, "unit": "us", "ours": entrant.ours, "times_as_long": middle})
    return rows


def part(machine, options):
    rows = []
    with tempfile.TemporaryDirectory(prefix="murosimf_race_") as name:
        folder = pathlib.Path(name)
        scenes.write_walk(folder, 1)
        for threads in sorted({1, os.cpu_count() or 1}):
            rows += race(machine, options, folder, threads)
    return rows
