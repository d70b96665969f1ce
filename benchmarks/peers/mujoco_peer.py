#!/usr/bin/env python3
"""MuJoCo in a race: the same command line and the same line of JSON as the programs of other peers (peer.h).

    benchmarks/peers/mujoco_peer.py FOLDER --warm 1 --seconds 3 --setting implicitfast --observe

FOLDER has description.json, which murosimf_peer_describe wrote. Ten steps of a control cycle are one call, so that Python costs 2
to 3 % of a single robot, and nothing of many.
"""
import argparse
import json
import pathlib
import time

from mujoco_scene import Race, integrators, mujoco, np

ROOT = pathlib.Path(__file__).resolve().parents[2]
LYING = 0.5  # cosine of the angle by which a base leans that has fallen


def run(race, begin, end, after=None):
    steps = race.description["steps_per_cycle"]
    for cycle in range(begin, end):
        race.data.ctrl[:] = race.control(cycle)
        mujoco.mj_step(race.model, race.data, steps)
        if after:
            after(cycle)


class Observation:
    """As observation.h of the other peers."""

    def __init__(self, race):
        self.race, self.places, self.errors, self.contacts, self.depth = race, [], [], [], 0.0

    def add(self, cycle):
        race = self.race
        self.places.append(np.array([race.data.qpos[base:base + 3] for base in race.bases]))
        targets = race.targets[min(cycle, len(race.targets) - 1)]
        self.errors.append(race.data.qpos[race.positions] - targets)
        self.contacts.append(race.data.ncon)
        self.depth = max(self.depth, -min(race.data.contact.dist, default=0))

    def result(self, cycle):
        middle, last = len(self.places) // 2, len(self.places) - 1

        def distance(a, b):
            return float(np.hypot(*(self.places[b] - self.places[a])[:, :2].T).mean())

        late = cycle * (last - middle)
        upright = self.race.data.xmat[self.race.base_bodies, 8]
        return {"height_m": float(np.mean([place[:, 2] for place in self.places])), "distance_m": distance(0, last),
                "late_speed_mm_s": 1e3 * distance(middle, last) / late if late > 0 else 0,
                "tracking_rad": float(np.sqrt(np.mean(np.square(self.errors)))),
                "contacts": float(np.mean(self.contacts)), "depth_mm": 1e3 * float(self.depth), "gap_mm": 0,
                "lying": int(np.sum(upright < LYING))}


def measure(options):
    race = Race(options.robot, options.folder / "description.json", options.setting)
    cycle = race.description["step"] * race.description["steps_per_cycle"]
    warm = round(options.warm / cycle)
    end = warm + max(1, round(options.seconds / cycle))
    run(race, 0, warm)
    processor, wall = time.process_time(), time.perf_counter()
    run(race, warm, end)
    per_step = 1e6 / ((end - warm) * race.description["steps_per_cycle"])
    result = {"engine": f"MuJoCo {mujoco.__version__}", "setting": options.setting,
              "us_per_step": per_step * (time.process_time() - processor),
              "wall_us_per_step": per_step * (time.perf_counter() - wall)}
    if options.observe:
        race.start()
        run(race, 0, warm)
        observation = Observation(race)
        run(race, warm, end, observation.add)
        result["observed"] = observation.result(cycle)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--robot", type=pathlib.Path, default=ROOT / "models/kid21.xml")
    parser.add_argument("--setting", choices=integrators(), default=integrators()[0], help="the integrator")
    parser.add_argument("--warm", type=float, default=1)
    parser.add_argument("--seconds", type=float, default=3)
    parser.add_argument("--observe", action="store_true")
    options = parser.parse_args()
    if not (options.folder / "description.json").is_file():
        parser.error(f"{options.folder}/description.json is not there")
    if not 0 <= options.warm <= 1000 or not 0 < options.seconds <= 1000:
        parser.error("--warm must be from 0 to 1000, --seconds above 0 and up to 1000")
    print(json.dumps(measure(options)))


if __name__ == "__main__":
    main()
