"""Whole games: the scenes that come with the program, on one thread and on all; ours alone."""
import os

from contest import print_table, show_spread, spread
from running import ROOT, Failure, run

SECONDS = 5  # simulated, of each


def measure(machine, options, scene, counts):
    """Row of a scene: times real time by number of threads, by wall time without what the start takes."""
    factors, states, entities = {threads: [] for threads in counts}, set(), 0
    seconds = 0.5 if options.quick else SECONDS * options.length
    for _ in range(options.rounds):
        for threads in counts:
            command = [machine.own("murosimf"), "run", scene, "--duration", seconds, "--threads", threads, "--json", "-"]
            report = run(command, cwd=ROOT)
            factors[threads].append(report["real_time_factor"])
            states.add(report["state_hash"])
            entities = len(report["entities"])
    return {"scene": scene, "unit": "times real time", "entities": entities, "same_state": len(states) == 1, "factors": factors}


def part(machine, options):
    counts = sorted({1, os.cpu_count() or 1})
    names = sorted(file.stem for file in (ROOT / "scenes").glob("*.toml"))
    rows = []
    for scene in names[:2] if options.quick else names:
        try:
            rows.append(measure(machine, options, scene, counts))
        except Failure as failure:
            print(f"  {scene}: {failure}", flush=True)
    print_table("scenes, cameras and sensors as they say; times real time by wall time",
                ["scene", "entities", *(f"{threads} threads" for threads in counts), "same state"],
                [[row["scene"], row["entities"], *(show_spread(spread(factors), 1) for factors in row["factors"].values()),
                  "yes" if row["same_state"] else "NO"] for row in rows])
    return rows
