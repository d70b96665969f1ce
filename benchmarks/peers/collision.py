"""Finding contacts among 22 robots: FCL, and ours by the probe of `murosimf bench collision`, on the same poses in every step."""
import statistics

from contest import Entrant, in_turns, print_table, show_spread, spread
from running import run
from steps import describe

import scenes

SCENES = {"walk": (1, 2), "heap": (3, 2)}  # [s] before the time counts, and while it does
COUNTS = ["touching", "ours_touching", "on_ground", "ours_on_ground"]  # pairs of bodies; bodies
HEADS = ["library", "us", "ours", "times", "pairs that touch", "as ours finds", "bodies on the ground", "as ours finds"]


class Collision(Entrant):
    """FCL with one setting; each run measures ours, too."""

    def __init__(self, setting, command):
        super().__init__("FCL", setting, lambda _observe: command)
        self.ours_times = []

    def keep(self, result):
        self.ours_times.append(result["ours_pairs_us"] + result["ours_ground_us"])
        self.observed = {key: result[key] for key in COUNTS}
        return result["pairs_us"] + result["ground_us"]

    def ratios(self):
        return spread([a / b for a, b in zip(self.times, self.ours_times, strict=True)])

    def cells(self):
        return [self.label, f"{self.median:.1f}", f"{statistics.median(self.ours_times):.1f}", show_spread(self.ratios(), 1),
                *(f"{self.observed[key]:.1f}" for key in COUNTS)]


def race(program, machine, options, kind):
    warm, seconds = (0.1, 0.1) if options.quick else SCENES[kind]
    with scenes.written(kind, 22) as folder:
        describe(machine, folder, 0.01)
        racers = [Collision(setting, [program, folder, "--setting", setting, "--warm", warm, "--seconds", seconds])
                  for setting in ("tree per robot", "one tree")]
        finished = in_turns(racers, run, None, options.rounds)
    print_table(f"contacts of 22 robots, {kind}; medians of steps in us", HEADS, [racer.cells() for racer in finished])
    return [racer.row(racer, f"contacts, {kind} of 22", "us", ours_times=racer.ours_times) | {"times_as_long": racer.ratios()[0]}
            for racer in finished]


def part(machine, options):
    program = machine.program("murosimf_peer_fcl")
    if not program:
        machine.miss(f"FCL: {machine.build}/murosimf_peer_fcl (Debian and Ubuntu: libfcl-dev; target murosimf_peers)")
        return []
    return [row for kind in SCENES for row in race(program, machine, options, kind)]
