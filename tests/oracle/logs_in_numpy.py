#!/usr/bin/env python3
"""Reads the logs of a run with NumPy: as a table (CSV) and as an array (NPY) they have to have the same names and doubles.

Usage: logs_in_numpy.py <murosimf>
Exit: 0 all agree, 1 something differs, 77 a package is not installed (test is skipped).
"""
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install numpy")
    sys.exit(77)

from errors import check, end

# Sensors of several rates, so that cells are empty; properties; many names; hardly a row.
RUNS = [("nudge", 1, ["robot.imu", "robot.torso.position", "robot.*.joint_velocity"]),
        ("three_on_three", 0.3, ["*.imu", "ball.ball.position", "*.camera*", "*.*.joint_position"]),
        ("walk", 0.002, ["walker.imu"])]


def run(program, *words):
    """Must succeed."""
    subprocess.run([program, *map(str, words)], check=True, stdout=subprocess.PIPE)


def as_table(file):
    """Header, and rows of doubles with NaN for empty cells."""
    header, *rows = csv.reader(file.read_text(encoding="utf-8").splitlines())
    return header, np.array([[float(cell or "nan") for cell in row] for row in rows]).reshape(len(rows), len(header))


def same(one, other):
    """Whether all bits are, but of what is NaN."""
    nothing = np.isnan(one)
    return np.array_equal(nothing, np.isnan(other)) and np.array_equal(
        np.where(nothing, 0, one).view(np.uint64), np.where(nothing, 0, other).view(np.uint64))


def compare(name, table, array):
    """Of two files; the numbers in them."""
    header, rows = as_table(table)
    fields = np.load(array, allow_pickle=True)  # as max_header_size, which older ones do not know: more than 10 kB of names
    check(list(fields.dtype.names) == header, f"{name}: {fields.dtype.names} are not {header}")
    check(all(fields.dtype[i] == np.dtype("<f8") for i in range(len(header))), f"{name}: {fields.dtype}")
    check(fields.shape == (len(rows),), f"{name}: {fields.shape}, not {len(rows)} rows")
    if list(fields.dtype.names) == header and len(fields) == len(rows):
        for i, field in enumerate(header):
            check(same(rows[:, i], fields[field].copy()), f"{name}: {field} differs")
    return rows


def main(program):
    """The comparisons."""
    numbers, empty = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        table, array, other = Path(folder, "log.csv"), Path(folder, "log.npy"), Path(folder, "export.npy")
        for scene, duration, patterns in RUNS:
            logs = [word for pattern in patterns for word in ("--log", pattern)]
            for out in (table, array):
                run(program, "run", scene, "--duration", duration, *logs, "--out", out)
            rows = compare(scene, table, array)
            numbers += rows.size
            empty += int(np.isnan(rows).sum())
        recording = Path(folder, "run.mcap")
        logs = ["--log", "robot.imu", "--out", array]
        run(program, "run", "nudge", "--duration", 1, *logs, "--record", recording, "--record-what", "sensors")
        run(program, "export", recording, "robot.imu", "--npy", other)
        check(array.read_bytes() == other.read_bytes(), "'export --npy' of a recording makes another file than the log")
    check(numbers > 10000 and empty > 100, f"only {numbers} numbers were compared, {empty} of them NaN")
    end(f"{numbers} numbers, {empty} of them NaN: ")


if __name__ == "__main__":
    main(sys.argv[1])
