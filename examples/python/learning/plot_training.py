#!/usr/bin/env python3
"""Draws the log of a training: mean return of episodes and falls per minute, over steps of the environment (gnuplot).

    python3 examples/python/learning/plot_training.py benchmarks/python/walk_training.json docs/learning_walk.png
"""

import json
import subprocess
import sys

drawing = """set terminal pngcairo noenhanced size 900,420 font 'sans,11' background '#ffffff'
set output "{file}"
set xlabel "steps of the environment [millions]"
set ylabel "mean return of an episode"
set y2label "falls per minute"
set ytics nomirror
set y2tics
set y2range [0:*]
set grid
set key at graph 0.45, graph 0.25
set arrow from {change}, graph 0 to {change}, graph 1 nohead dashtype 2
set label "articulated_dynamics from here" at {change}, graph 0.5 right offset -1,0
plot "-" using 1:2 with lines linewidth 2 title "return", "-" using 1:2 axes x1y2 with lines title "falls per minute"
"""


def main():
    if len(sys.argv) != 3:
        sys.exit("plot_training: takes a log (JSON) and a picture to write (PNG)")
    with open(sys.argv[1]) as file:
        log = json.load(file)
    change = log["env_steps"]["simplified"] / 1e6
    rows = [((row["env_steps"] / 1e6) + (change if row["stage"] == "articulated" else 0), row["return"], row["falls_per_minute"])
            for row in log["curve"]]
    data = "".join("".join(f"{row[0]} {row[column]}\n" for row in rows) + "e\n" for column in (1, 2))
    subprocess.run(["gnuplot"], input=drawing.format(file=sys.argv[2], change=change) + data, text=True, check=True)


if __name__ == "__main__":
    main()
