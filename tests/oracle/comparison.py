"""What the oracle's comparisons share: our answers, and the worst of many differences."""
import json
import subprocess

import numpy as np


def run(*arguments):
    """The JSON that a program prints. Its complaint, if it has one, goes to standard error."""
    output = subprocess.run([str(argument) for argument in arguments], check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(output.stdout)


class Worst:
    """The largest difference of each kind of quantity, with the case in which it was found."""

    def __init__(self, tolerances):
        self.tolerances = tolerances
        self.found = {what: (0.0, "nothing") for what in tolerances}
        self.count = 0

    def note(self, what, case, error):
        """NaN is worse than any number."""
        error = np.inf if np.isnan(error) else error
        self.count += 1
        if error > self.found[what][0]:
            self.found[what] = (error, case)

    def add(self, what, case, ours, theirs):
        """Compares arrays relative to their largest component."""
        ours, theirs = np.ravel(ours), np.ravel(theirs)
        if ours.shape != theirs.shape:
            raise ValueError(f"{what}, {case}: {ours.size} numbers here, {theirs.size} there")
        self.note(what, case, np.abs(ours - theirs).max() / np.abs(theirs).max())

    def report(self):
        """Prints a line per quantity; exit code 0 if all agree."""
        failed = 0
        print(f"{self.count} comparisons; largest differences:")
        for what, (error, case) in self.found.items():
            good = error <= self.tolerances[what]
            failed += not good
            verdict = "ok" if good else "TOO LARGE"
            print(f"  {what:22} {error:.2e} (at most {self.tolerances[what]:.1e}) {verdict}: {case}")
        return 1 if failed or not self.count else 0
