"""Thousands of worlds of one walking robot: our Batch, scenes one after the other, MuJoCo's batch; processor time, one thread."""
from contest import Entrant, in_turns, print_table, ratios, show_spread
from running import HERE, run
from steps import describe

import scenes

LEVELS = ["articulated_dynamics", "simplified_dynamics"]
MOST = 1024  # worlds of which a turn does not take MuJoCo minutes; its time for a step does not depend on their number


def entrants(machine, folder, worlds, ends):
    def command(start, setting):
        return lambda _observe: [*start, folder, "--setting", setting, *ends]

    batch, whole_scenes = machine.own("murosimf_peer_batch"), machine.own("murosimf_peer_worlds")
    found = [Entrant("MuRoSimF", f"Batch, {level}", command([batch], level), ours=True) for level in LEVELS]
    found += [Entrant("MuRoSimF", f"scenes, {level}", command([whole_scenes], level), ours=True) for level in LEVELS]
    if machine.has_module("mujoco.batch"):
        if worlds > MOST:
            return found
        found.append(Entrant("MuJoCo", "batch", command([machine.python, HERE / "mujoco_worlds.py"], "batch")))
    else:
        machine.miss("mujoco.batch: this version of MuJoCo does not have it, or there is none")
    return found


def race(machine, options, folder, worlds):
    warm, seconds = (0.02, 0.02) if options.quick else (0.1, max(0.05, 64 / worlds) * options.length)
    describe(machine, folder, warm + seconds)
    ends = ["--worlds", worlds, "--threads", 1, "--warm", warm, "--seconds", seconds]
    finished = in_turns(entrants(machine, folder, worlds, ends), run, "us_per_step", options.rounds)
    print_table(f"{worlds} worlds of a walking robot, us of processor time per step of one world; `times`: as long as the first",
                ["engine", "us", "times", "million steps per second", "KiB per world", "distance m"],
                [[entrant.label, f"{entrant.median:.2f}", show_spread(ratios(entrant, finished[0])), f"{1 / entrant.median:.3f}",
                  "{:.1f}".format(entrant.observed["kib_per_world"]) if "kib_per_world" in entrant.observed else "",
                  f"{entrant.observed['distance_m']:.3f}"] for entrant in finished])
    return [entrant.row(finished[0], f"{worlds} worlds in a batch", "us", worlds=worlds) for entrant in finished]


def part(machine, options):
    with scenes.written("walk", 1) as folder:
        return [row for worlds in ([16] if options.quick else [64, 256, 1024, 4096])
                for row in race(machine, options, folder, worlds)]
