"""What was tried, what came of it, and what must not have."""
from collections import Counter, defaultdict


class Book:
    def __init__(self):
        self.rows, self.errors = [], []

    def add(self, door, kind, tried, outcome):
        self.rows.append((door, kind, str(tried), outcome))

    def wrong(self, door, kind, tried, what):
        self.rows.append((door, kind, str(tried), "WRONG: " + what))
        self.errors.append(f"{door}, {kind}, {str(tried)[:120]!r}: {what}")

    def table(self, everything):
        """Each try, or how many of a kind ended how."""
        if everything:
            return "\n".join(f"{door:<17}{kind:<26}{outcome[:60]:<62}{tried[:100]!r}" for door, kind, tried, outcome in self.rows)
        counts = defaultdict(Counter)
        for door, kind, _, outcome in self.rows:
            counts[door, kind][outcome.split(":")[0]] += 1
        lines = [f"{'door':<17}{'tried':<26}{'times':>6}  outcome"]
        for (door, kind), outcomes in counts.items():
            told = ", ".join(f"{number} {outcome}" for outcome, number in outcomes.most_common())
            lines.append(f"{door:<17}{kind:<26}{sum(outcomes.values()):>6}  {told}")
        return "\n".join(lines)
