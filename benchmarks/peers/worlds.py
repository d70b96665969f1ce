"""Many worlds of one walking robot: ours in a pool of threads, MuJoCo's batch and rollout; one thread and all."""
import os

from contest import Entrant, in_turns, print_table, ratios, show_spread
from running import HERE, run
from steps import LEVELS, describe

import scenes


def entrants(machine, folder, ends):
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
    ends = ["--worlds", worlds, "--threads", threads, "--warm", warm, "--seconds", seconds]
    kind = "processor" if threads == 1 else "wall"
    key = "us_per_step" if threads == 1 else "wall_us_per_step"
    finished = in_turns(entrants(machine, folder, ends), run, key, options.rounds)
    print_table(f"{worlds} worlds of a walking robot, {threads} threads, us of {kind} time per step of one world",
                ["engine", "us", "times", "steps of worlds per second", "distance m"],
                [[entrant.label, f"{entrant.median:.2f}", show_spread(ratios(entrant, finished[0])),
                  f"{1e6 / entrant.median:,.0f}", f"{entrant.observed['distance_m']:.3f}"] for entrant in finished])
    return [entrant.row(finished[0], f"{worlds} worlds", "us", threads=threads) for entrant in finished]


def part(machine, options):
    with scenes.written("walk", 1) as folder:
        return [row for threads in sorted({1, os.cpu_count() or 1}) for row in race(machine, options, folder, threads)]
