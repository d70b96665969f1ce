"""Entrants that do the same work by turns, what they took, and whether they did it."""
import statistics

from running import Failure


class Entrant:
    """One program with one setting; `command` makes its command line from (observe)."""

    def __init__(self, name, setting, command, ours=False):
        self.name, self.setting, self.command, self.ours = name, setting, command, ours
        self.times, self.engine, self.observed, self.failure = [], name, None, None

    def turn(self, run, key, observe):
        if self.failure:
            return
        try:
            result = run(self.command(observe))
        except Failure as failure:
            self.failure = str(failure)
            print(f"  {self.label}: {self.failure}", flush=True)
            return
        self.times.append(result[key])
        self.engine = result.get("engine", self.name)
        self.observed = result.get("observed", self.observed)

    @property
    def label(self):
        return f"{self.engine}, {self.setting}" if self.setting else self.engine

    def to_json(self):
        row = {"engine": self.engine, "setting": self.setting, "times": self.times, "observed": self.observed}
        if self.times:
            row |= {"median": statistics.median(self.times), "minimum": min(self.times), "maximum": max(self.times)}
        return row | ({"failure": self.failure} if self.failure else {})


def in_turns(entrants, run, key, rounds):
    """`key`: of the result, the time that counts. What they did is looked at once."""
    for i in range(rounds):
        for entrant in entrants:
            entrant.turn(run, key, i == 0)
    return [entrant for entrant in entrants if entrant.times and not entrant.failure]


def ratios(entrant, reference):
    """How many times as long as the reference, in the same round: median, least, most."""
    values = [a / b for a, b in zip(entrant.times, reference.times, strict=True)]
    return statistics.median(values), min(values), max(values)


# What may differ between two that did the same work: how far an observation may be from the reference's, as a share of it and
# besides. Robots that fall do so in other ways in each engine.
ALIKE = {
    "walk": {"height_m": (0, 0.005), "distance_m": (0.1, 0.02), "contacts": (0.4, 0), "tracking_rad": (0.3, 0), "lying": (0, 0)},
    "squat": {"height_m": (0, 0.005), "distance_m": (0, 0.02), "contacts": (0.3, 0), "tracking_rad": (0.3, 0.005), "lying": (0, 0)},
    "heap": {"height_m": (0.3, 0.02), "contacts": (0.5, 5)},
    "slope": {"height_m": (0, 0.005), "distance_m": (0, 0.02), "contacts": (0.3, 0), "lying": (0, 0)},
}
DEEPEST = {"walk": 3, "squat": 3, "heap": 30, "slope": 3}  # [mm] that bodies may overlap
WIDEST = 1  # [mm] by which joints may come apart


def differences(kind, entrant, reference):
    """Names of what differs from the reference's work by more than it may."""
    seen, wanted = entrant.observed, reference.observed
    found = [key for key, (share, more) in ALIKE[kind].items() if not abs(seen[key] - wanted[key]) <= share * abs(wanted[key]) + more]
    found += ["depth"] if seen["depth_mm"] > DEEPEST[kind] else []
    found += ["gap"] if seen["gap_mm"] > WIDEST else []
    return [name.split("_")[0] for name in found]
