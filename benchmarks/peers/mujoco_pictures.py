#!/usr/bin/env python3
"""What a picture of a race's scene costs MuJoCo's renderer: 640 x 480 pixels, from the side, no shadows and reflections.

    benchmarks/peers/mujoco_pictures.py FOLDER --seconds 5

Prints the same line of JSON as murosimf_peer_pictures.
"""
import argparse
import json
import math
import os
import pathlib
import time

os.environ.setdefault("MUJOCO_GL", "egl")  # before MuJoCo is loaded

from mujoco_peer import ROOT  # noqa: E402
from mujoco_scene import Race, integrators, mujoco, np  # noqa: E402

WIDTH, HEIGHT = 640, 480
EYE, DOWN, HALF_WIDTH = [-0.25, -6.0, 1.2], 0.25, 0.9  # [m], [rad], tangent: those of pictures.cpp


def camera():
    view, distance = mujoco.MjvCamera(), 1.0
    view.type = mujoco.mjtCamera.mjCAMERA_FREE
    view.azimuth, view.elevation, view.distance = 90, -math.degrees(DOWN), distance
    view.lookat[:] = [EYE[0], EYE[1] + distance * math.cos(DOWN), EYE[2] - distance * math.sin(DOWN)]
    return view


def share_of_robots(renderer, model):
    renderer.enable_segmentation_rendering()
    shown = renderer.render()
    renderer.disable_segmentation_rendering()
    geoms = shown[:, :, 0][shown[:, :, 1] == mujoco.mjtObj.mjOBJ_GEOM]
    return float(np.count_nonzero(model.geom_bodyid[geoms] > 0) / (WIDTH * HEIGHT))


def measure(options):
    race = Race(options.robot, options.folder / "description.json", integrators()[0])
    race.model.vis.global_.fovy = 2 * math.degrees(math.atan(0.75 * HALF_WIDTH))
    race.model.vis.quality.offsamples = 0  # as ours: one sample to a pixel
    race.model.vis.global_.offwidth, race.model.vis.global_.offheight = WIDTH, HEIGHT
    with mujoco.Renderer(race.model, HEIGHT, WIDTH) as renderer:
        view = camera()
        renderer.update_scene(race.data, view)
        for flag in (mujoco.mjtRndFlag.mjRND_SHADOW, mujoco.mjtRndFlag.mjRND_REFLECTION):
            renderer.scene.flags[flag] = 0
        share = share_of_robots(renderer, race.model)
        picture = np.empty((HEIGHT, WIDTH, 3), np.uint8)
        pictures, begin = 0, time.process_time()
        while time.process_time() - begin < options.seconds:
            renderer.update_scene(race.data, view)
            renderer.render(out=picture)
            pictures += 1
        took = time.process_time() - begin
    return {"engine": f"MuJoCo {mujoco.__version__}", "ms_per_picture": 1e3 * took / pictures,
            "observed": {"robots_share": share}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--robot", type=pathlib.Path, default=ROOT / "models/kid21.xml")
    parser.add_argument("--seconds", type=float, default=5)
    print(json.dumps(measure(parser.parse_args())))


if __name__ == "__main__":
    main()
