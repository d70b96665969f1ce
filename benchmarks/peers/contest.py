"""Entrants that do the same work by turns, what they took, and whether they did it."""
import resource
import statistics

from running import Failure

PATIENCE = 30  # [s] of processor time of a turn; who takes more has no other one


class Entrant:
    """One program with one setting; `command` makes its command line from (observe)."""

    def __init__(self, name, setting, command, ours=False):
        self.name, self.setting, self.command, self.ours = name, setting, command, ours
        self.times, self.engine, self.observed, self.finished = [], name, None, True

    def turn(self, run, key, observe):
        begin = processor_seconds()
        try:
            result = run(self.command(observe))
        except Failure as failure:
            self.times, self.finished = [], False
            print(f"  {self.label}: {failure}", flush=True)
            return
        self.engine = result.get("engine", self.name)
        self.times.append(self.keep(result) if key is None else result[key])
        self.observed = result.get("observed", self.observed)
        self.finished = processor_seconds() - begin < PATIENCE or self.ours

    def keep(self, result):
        """The time that counts, for what is not timed by one key; remembers the rest."""
        raise NotImplementedError

    @property
    def label(self):
        return f"{self.engine}, {self.setting}" if self.setting else self.engine

    @property
    def median(self):
        return statistics.median(self.times)

    def row(self, reference, scene, unit, **more):
        """For the JSON document."""
        return {"scene": scene, "engine": self.engine, "setting": self.setting, "ours": self.ours, "unit": unit,
                "times": self.times, "median": self.median, "times_as_long": ratios(self, reference)[0],
                "observed": self.observed, **more}


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def in_turns(entrants, run, key, rounds):
    """Those that finished. `key`: of the result, the time that counts; None: entrants know. What they did is looked at once."""
    for i in range(rounds):
        for entrant in entrants:
            if entrant.finished:
                entrant.turn(run, key, i == 0)
    return [entrant for entrant in entrants if entrant.times]


def spread(values):
    """Median, least, most."""
    return statistics.median(values), min(values), max(values)


def ratios(entrant, reference):
    """How many times as long as the reference, in the same rounds: median, least, most."""
    return spread([a / b for a, b in zip(entrant.times, reference.times, strict=False)])


def show_spread(values, digits=2):
    return "{:.{n}f} ({:.{n}f} to {:.{n}f})".format(*values, n=digits)


def print_table(title, heads, rows):
    print("\n".join([f"\n{title}", f"| {' | '.join(map(str, heads))} |", "|---" * len(heads) + "|",
                     *(f"| {' | '.join(map(str, row))} |" for row in rows)]), flush=True)
