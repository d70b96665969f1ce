"""Pictures of six and 22 robots, 640 x 480 pixels, by our renderer and by MuJoCo's: what robots' cameras cost."""
import os

from contest import Entrant, in_turns, print_table, ratios, show_spread
from running import HERE, run
from steps import describe

import scenes

ALIKE = 0.1  # of the share of pixels that show a robot


def share(racer):
    return racer.observed["robots_share"]


def same(racer, reference):
    return abs(share(racer) - share(reference)) <= ALIKE * share(reference)


def race(machine, options, robots):
    with scenes.written("walk", robots) as folder:
        describe(machine, folder, 0.01)
        ends = [folder, "--seconds", 0.2 if options.quick else 3 * options.length]
        own = [machine.own("murosimf_peer_pictures"), *ends]
        racers = [Entrant("MuRoSimF", "", lambda _observe: own, ours=True)]
        if machine.python:
            theirs = [machine.python, HERE / "mujoco_pictures.py", *ends]
            racers.append(Entrant("MuJoCo", "", lambda _observe: theirs))
        finished = in_turns(racers, run, "ms_per_picture", options.rounds)
    if not finished or finished[0] is not racers[0]:
        return []  # no graphics driver: the program has said so
    reference = finished[0]
    print_table(f"pictures of {robots} robots by {reference.observed['by']}, ms of processor time each",
                ["renderer", "ms", "times", "pixels with robots", "same picture"],
                [[racer.label, f"{racer.median:.2f}", show_spread(ratios(racer, reference)), f"{100 * share(racer):.2f} %",
                  "yes" if same(racer, reference) else "no"] for racer in finished])
    return [racer.row(reference, f"pictures of {robots}", "ms", same=same(racer, reference)) for racer in finished]


def part(machine, options):
    # drawing by the processor then stays in the thread that asks for it; inherited by what is started
    os.environ.setdefault("LP_NUM_THREADS", "0")
    return [row for robots in ([6] if options.quick else [6, 22]) for row in race(machine, options, robots)]
