#!/usr/bin/env python3
"""What a small detector of balls loses without each kind of what varies in its training pictures (docs/dataset.md).

    murosimf render match --dataset test --frames 500 --seed 2 --threads 2
    benchmarks/python/randomisation_table.py FOLDER test --most 300 --least 24 --json docs/dataset_randomisation.json

Draws, in FOLDER, a data set with all ranges of datasets/soccer.toml, one without each kind, and one without any of them, all of
one seed: places, postures and views are the same in all of them. find_ball_twice.py is trained on each, and looks for the balls
of `test`, whose pictures vary in everything. What is there already, in FOLDER and in the file of --json, is not made again.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import time
import tomllib

import find_ball_twice
import numpy as np
from find_ball import Pictures, average_precision

ROOT = pathlib.Path(__file__).parents[2]
# What is left out of a file of ranges does not vary.
KINDS = {
    "light": {"light": ["presets", "brightness", "elevation_deg", "warmth", "shadows"],
              "sensor": ["exposure", "white_balance", "vignetting"]},
    "colors": {"light": ["other_colors", "wall_distance", "wall_height"], "field": None,
               "ball": ["colors", "any_color", "panels"], "robots": ["team_colors"]},
    "lens": {"lens": None},
    "noise": {"sensor": ["shot_noise", "read_noise"], "picture": ["format", "jpeg_quality"]},
    "blur": {"sensor": ["blur", "motion_blur", "exposure_time", "turning"]},
    "distractors": {"people": None},
}
SETS = {"everything": [], **{f"no {kind}": [kind] for kind in KINDS}, "nothing": list(KINDS)}


def ranges_without(ranges, kinds):
    left = {section: dict(keys) for section, keys in ranges.items()}
    for kind in kinds:
        for section, keys in KINDS[kind].items():
            for key in keys or list(ranges[section]):
                left[section].pop(key, None)
    return {section: keys for section, keys in left.items() if keys}


def as_toml(ranges):
    lines = []
    for section, keys in ranges.items():
        lines += [f"[{section}]", *(f"{key} = {json.dumps(value)}" for key, value in keys.items()), ""]
    return "\n".join(lines)


def draw(folder, name, kinds, options):
    """The data set of that name."""
    place = folder / name.replace(" ", "_")
    ranges = tomllib.loads((ROOT / "datasets/soccer.toml").read_text())
    file = folder / f"{place.name}.toml"
    file.write_text(as_toml(ranges_without(ranges, kinds)))
    if not (place / "annotations.json").exists():
        subprocess.run([options.program, "render", options.scene, "--dataset", place, "--randomise", file, "--frames",
                        str(options.frames), "--seed", "1", "--threads", "2"], check=True, stdout=subprocess.DEVNULL)
    return place


def table(rows):
    """Means over seeds of training, and how far they are apart."""
    lines = ["| trained with | average precision | of trainings | share found | less by |", "|---|---|---|---|---|"]
    means = {}
    for name in dict.fromkeys(row["trained_with"] for row in rows):
        all_of = [row for row in rows if row["trained_with"] == name]
        precisions = [row["average_precision"] for row in all_of]
        means[name] = np.mean(precisions)
        less = "" if name == "everything" or "everything" not in means else f"{means['everything'] - means[name]:.3f}"
        lines.append(f"| {name} | {means[name]:.3f} | {', '.join(format(one, '.3f') for one in precisions)} | "
                     f"{np.mean([row['recall'] for row in all_of]):.2f} | {less} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="for data sets that are drawn")
    parser.add_argument("test", type=pathlib.Path, help="data set in which balls are looked for")
    parser.add_argument("--program", default=str(ROOT / "build/release/murosimf"))
    parser.add_argument("--scene", default="match")
    parser.add_argument("--frames", type=int, default=1000, help="pictures of each data set")
    parser.add_argument("--only", nargs="*", choices=SETS, help="these data sets")
    parser.add_argument("--draw", action="store_true", help="only draws")
    parser.add_argument("--json", type=pathlib.Path)
    find_ball_twice.add_options(parser)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    rows = json.loads(options.json.read_text())["rows"] if options.json and options.json.exists() else []
    for name in options.only or SETS:
        if any(row["trained_with"] == name and row["seed"] == options.seed for row in rows):
            continue
        place = draw(options.folder, name, SETS[name], options)
        if options.draw:
            continue
        begin = time.monotonic()
        detector = find_ball_twice.trained(place, options)
        taken = time.monotonic() - begin
        precision, recall, balls = average_precision(detector.find, Pictures(options.test, options.least))
        rows.append({"trained_with": name, "average_precision": round(precision, 4), "recall": round(recall, 4),
                     "balls": balls, "pictures": options.most or options.frames, "seed": options.seed,
                     "trained_s": round(taken)})
        print(json.dumps(rows[-1]), flush=True)
        if options.json:
            options.json.write_text(json.dumps({"command": " ".join(map(str, sys.argv)), "rows": rows}, indent=1) + "\n")
    if rows:
        print(table(rows))


if __name__ == "__main__":
    np.seterr(over="ignore")
    main()
