#!/usr/bin/env python3
"""Compares where points are seen through lenses, and along which rays pixels look, with OpenCV.

Usage: lenses_against_opencv.py <dump_lens>
Exit: 0 all agree, 1 some differ, 77 OpenCV is not installed (test is skipped).

Our rays go through OpenCV's projection and must come back to their pixels: its own inverse is an iteration that stops
early. Its projectPoints knows no skew, so it projects to focal length 1 and the camera matrix comes after it; for fisheye
lenses it has a skew of its own (alpha). It shows points beyond the fold of a lens, too; ours does not see them, so they are
not compared.
"""
import pathlib
import sys
import tempfile

try:
    import cv2
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install opencv-python-headless")
    sys.exit(77)

from comparison import Worst, run

TOLERANCES = {"points to pixels [px]": 1e-9, "pixels to rays [px]": 1e-7}
LENSES = 25  # of each model
SEEN = 0.9  # at least this share of rays, or a lens is no test


def random_lens(random, model):
    """Picture, focal lengths, center and skew, and coefficients as calibrations give them."""
    width = random.integers(200, 2000)
    height = round(width * random.uniform(0.5, 0.9))
    focal = random.uniform(0.6, 1.2) * width
    picture = [width, height, focal, focal * random.uniform(0.98, 1.02),
               width * random.uniform(0.45, 0.55), height * random.uniform(0.45, 0.55),
               focal * random.uniform(-0.02, 0.02)]
    p = random.uniform(-2e-3, 2e-3, 2)
    if model == "plumb_bob":
        k = random.uniform([-0.25, 0.05, 0], [0.1, 0.1, 0.02])
        return picture, [k[0], k[1], *p, k[2]]
    if model == "rational_polynomial":
        k = random.uniform(0.98, 1.02, 6) * [0.93, 0.17, 0.003, 1.2, 0.36, 0.028]
        return picture, [k[0], k[1], *p, *k[2:]]
    return picture, list(random.uniform([-0.06, -0.02, -0.003, -0.001], [0.1, 0.02, 0.003, 0.0005]))


def seen_by_opencv(points, model, picture, coefficients):
    """Pixels of points [m] in the optical frame."""
    _, _, fx, fy, cx, cy, skew = picture
    points, none = np.reshape(points, (-1, 1, 3)), np.zeros((3, 1))
    if model == "equidistant":
        matrix = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])
        seen = cv2.fisheye.projectPoints(points, none, none, matrix, np.array(coefficients), alpha=skew / fx)[0]
        return seen.reshape(-1, 2)
    plane = cv2.projectPoints(points, none, none, np.eye(3), np.array(coefficients))[0].reshape(-1, 2)
    return plane @ np.array([[fx, 0], [skew, fy]]) + [cx, cy]


def compare(dump, model, case, random, folder, worst):
    picture, coefficients = random_lens(random, model)
    points = random.uniform([-0.5, -0.5, 0.7], [0.5, 0.5, 3], (200, 3))
    file = folder / "points.txt"
    np.savetxt(file, points, fmt="%.17g")
    answer = run(dump, file, model, *picture, *coefficients)
    known = [i for i, pixel in enumerate(answer["pixels"]) if pixel]
    looks = [entry for entry in answer["rays"] if entry["ray"]]
    if len(known) < SEEN * len(points) or len(looks) < SEEN * len(answer["rays"]):
        raise ValueError(f"{case}: this lens sees too little")
    theirs = seen_by_opencv(points[known], model, picture, coefficients)
    worst.note("points to pixels [px]", case, np.abs(theirs - [answer["pixels"][i] for i in known]).max())
    theirs = seen_by_opencv(np.array([entry["ray"] for entry in looks]), model, picture, coefficients)
    worst.note("pixels to rays [px]", case, np.abs(theirs - [entry["pixel"] for entry in looks]).max())


def main(dump):
    worst = Worst(TOLERANCES)
    random = np.random.default_rng(8)
    with tempfile.TemporaryDirectory() as folder:
        for model in ("plumb_bob", "rational_polynomial", "equidistant"):
            for i in range(LENSES):
                compare(dump, model, f"{model} {i}", random, pathlib.Path(folder), worst)
    return worst.report()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
