#!/usr/bin/env python3
"""Reads a data set with COCO's own reader, and finds masks, boxes, keypoints and depths again by an independent projection.

Usage: dataset_against_coco.py <murosimf> <scene>
Exit: 0 all agree, 1 something differs, 77 pycocotools is not installed (test is skipped).

The scene has the field kid_size_2008. The same pictures must come out bit for bit for another number of threads, and after the
program was killed in between; folders that cannot be written to, or that are no data set, are refused in one line.
"""
import contextlib
import io
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
    from PIL import Image
    from pycocotools import mask as coco_mask
    from pycocotools.coco import COCO
except ImportError as missing:
    print(f"skipped: {missing}; pip install pycocotools pillow")
    sys.exit(77)

SIZE, FRAMES = (320, 240), 10
RANGES = """
[picture]
samples = 1
[light]
presets = ["hall", "day", "plain"]
other_colors = 0.5
[ball]
in_air = 0.2
[robots]
down = 0.4
recorded = 0.5
[people]
count = 3
things = 2
in_view = 1
[camera]
pan_deg = [-40, 40]
tilt_deg = [-10, 15]
roll_deg = [-5, 5]
[lens]
count = 4
plumb_bob = 1
equidistant = 1
fov_deg = [60, 100]
k1 = [-0.2, 0]
p = [-0.002, 0.002]
[sensor]
motion_blur = 0.3
white_balance = [-0.1, 0.1]
vignetting = [0, 0.4]
"""
failures = []


def check(good, message):
    if not good:
        failures.append(message)


# ---- an independent camera ----

def project(camera, points):
    """Pixels of points [m] in the world, and their depths."""
    p = (np.atleast_2d(points) - camera["position"]) @ np.array(camera["rotation"])
    x, y, z = p[:, 0] / p[:, 2], p[:, 1] / p[:, 2], p[:, 2]
    if camera["model"] == "plumb_bob":
        k1, k2, p1, p2, k3 = camera["distortion"]
        r = x * x + y * y
        s = 1 + r * (k1 + r * (k2 + r * k3))
        x, y = s * x + 2 * p1 * x * y + p2 * (r + 2 * x * x), s * y + p1 * (r + 2 * y * y) + 2 * p2 * x * y
    elif camera["model"] == "equidistant":
        tangent = np.hypot(x, y)
        t = np.arctan(tangent)
        k = camera["distortion"]
        d = t * (1 + sum(k[i] * t**(2 * i + 2) for i in range(4)))
        x, y = x * d / tangent, y * d / tangent
    K = np.array(camera["K"])
    return np.stack([K[0, 0] * x + K[0, 1] * y + K[0, 2], K[1, 1] * y + K[1, 2]], 1), z


def outline_of_ball(camera, center, radius):
    """Points of the sphere at which rays touch it."""
    way = np.array(center) - camera["position"]
    distance = np.linalg.norm(way)
    one = np.cross(way, [0.3, 0.5, 0.8])
    one /= np.linalg.norm(one)
    two = np.cross(way / distance, one)
    share = (radius / distance)**2
    angle = np.linspace(0, 2 * np.pi, 2000)[:, None]
    circle = radius * np.sqrt(1 - share) * (np.cos(angle) * one + np.sin(angle) * two)
    return np.array(center) - share * way + circle


def crossings():
    """Of the field kid_size_2008, from the numbers of the rules: middles of lines of 5 cm."""
    x, y, front, area = 2.975, 1.975, 2.425, 1.075
    return np.array([(s * x, t * y) for s in (-1, 1) for t in (-1, 1)] + [(0, t * y) for t in (-1, 1)] +
                    [(s * a, t * area) for s in (-1, 1) for t in (-1, 1) for a in (x, front)] +
                    [(0, -0.6), (0, 0), (0, 0.6), (-1.2, 0), (1.2, 0)])


# ---- the pictures ----

class Frame:
    def __init__(self, folder, image):
        def read(name):
            return np.array(Image.open(folder / name))

        self.image, self.camera = image, image["camera"]
        self.color, self.depth = read(image["file_name"]), read(image["depth"])
        self.instances, self.classes = read(image["instances"]), read(image["classes"])
        self.normals = read(image["normals"])
        self.name = image["file_name"]

    def mask(self, annotation):
        if annotation["instance"]:
            return self.instances == annotation["instance"]
        return np.isin(self.classes, (6, 7))


def check_masks(coco, frame, annotation):
    name, mask = f"{frame.name} {annotation['name']}", frame.mask(annotation)
    check((coco.annToMask(annotation) == mask).all(), f"{name}: mask")
    check(annotation["area"] == mask.sum(), f"{name}: area")
    check(list(coco_mask.toBbox(annotation["segmentation"])) == annotation["bbox"], f"{name}: visible box")
    if annotation["instance"]:
        check((frame.classes[mask] == annotation["category_id"]).all(), f"{name}: class")
    if not annotation["bbox_full"]:
        return
    x, y, w, h = annotation["bbox"]
    fx, fy, fw, fh = annotation["bbox_full"]
    inside = fx < x + 1 and fy < y + 1 and fx + fw > x + w - 1 and fy + fh > y + h - 1
    check(inside, f"{name}: the full box {annotation['bbox_full']} has the visible one {annotation['bbox']}")


def check_ball(frame, annotation, radius):
    center, name = annotation["position"], f"{frame.name} ball"
    pixel, z = project(frame.camera, center)
    u, v, seen = annotation["keypoints"]
    if seen:
        check(np.abs(pixel[0] - [u, v]).max() < 0.01, f"{name}: center at {u}, {v}, not {pixel[0]}")
    edge = project(frame.camera, outline_of_ball(frame.camera, center, radius))[0] + 0.5
    x, y, w, h = annotation["bbox_full"]
    error = np.abs(np.r_[edge.min(0) - [x, y], edge.max(0) - [x + w, y + h]]).max()
    check(error < 0.3, f"{name}: full box is off by {error} px")
    if seen == 2:
        away = np.linalg.norm(np.array(center) - frame.camera["position"])
        depth = frame.depth[round(v), round(u)] / 1000
        check(abs(depth - z[0] * (1 - radius / away)) < 0.02, f"{name}: depth {depth}, center {z[0]}")
    whole = x > 1 and y > 1 and x + w < SIZE[0] - 1 and y + h < SIZE[1] - 1
    if whole and annotation["area"] > 0.95 * np.pi / 4 * w * h:
        check(np.abs(np.array(annotation["bbox"]) - annotation["bbox_full"]).max() < 1.6, f"{name}: boxes")


def check_ground(frame, annotation, names, known):
    """Returns how many crossings are seen."""
    points = np.reshape(annotation["keypoints"], (-1, 3))
    count = 0
    for name, (u, v, seen) in zip(names, points, strict=True):
        if not seen:
            continue
        place = np.array([*known[name], 0])
        pixel, z = project(frame.camera, place)
        check(np.abs(pixel[0] - [u, v]).max() < 0.01, f"{frame.name} {name}: at {u}, {v}, not {pixel[0]}")
        if seen == 2:
            count += 1
            depth = frame.depth[round(v), round(u)] / 1000
            # of flat ground at z, h below a lens of f pixels, the depths of neighboring rows differ by z^2/(f h)
            of_a_pixel = z[0]**2 / (frame.camera["K"][0][0] * frame.camera["position"][2])
            check(abs(depth - z[0]) < 0.02 + 1.2 * of_a_pixel, f"{frame.name} {name}: depth {depth}, not {z[0]}")
            around = frame.classes[max(0, round(v) - 1):round(v) + 2, max(0, round(u) - 1):round(u) + 2]
            if z[0] < 3:
                check((around == 7).any(), f"{frame.name} {name}: no line is there")
    ground = frame.classes == 6
    up = 127.5 * (np.array(frame.camera["rotation"])[2] + 1)
    inner = ground[1:-1, 1:-1] & ground[:-2, 1:-1] & ground[2:, 1:-1] & ground[1:-1, :-2] & ground[1:-1, 2:]
    near = inner & (frame.depth[1:-1, 1:-1] < 4000)
    if near.any():
        error = np.abs(frame.normals[1:-1, 1:-1][near] - up)
        check(np.median(error) < 1.5, f"{frame.name}: normals of the ground {np.median(error)}")
    return count


def check_robot(frame, annotation):
    points = np.reshape(annotation["keypoints"], (-1, 3))
    place, axes = np.array(annotation["position"]), np.array(annotation["rotation"])
    for index, point in ((0, place), (-1, place + 0.2 * axes[:, 0])):
        u, v, seen = points[index]
        if seen:
            pixel = project(frame.camera, point)[0][0]
            check(np.abs(pixel - [u, v]).max() < 0.01, f"{frame.name} {annotation['name']}: keypoint {index}")
    for u, v, seen in points[:-1]:
        if seen == 2:
            check(frame.instances[round(v), round(u)] == annotation["instance"], f"{frame.name}: joint of another one")


def check_yolo(folder, frame, annotations, categories):
    file = folder / frame.name.replace("images/", "labels/").replace(".png", ".txt")
    names = [c["name"] for c in categories if c["name"] != "ground"]
    rows = []
    for one in annotations:
        category = next(c["name"] for c in categories if c["id"] == one["category_id"])
        x, y, w, h = one["bbox"]
        if category != "ground" and "own" not in one:
            rows.append([names.index(category), (x + w / 2) / SIZE[0], (y + h / 2) / SIZE[1], w / SIZE[0], h / SIZE[1]])
    told = [[float(word) for word in line.split()] for line in file.read_text().splitlines()]
    check(np.shape(told) == np.shape(rows) and np.allclose(told, rows, atol=2e-6), f"{file}: differs from COCO")


def check_dataset(folder):
    with contextlib.redirect_stdout(io.StringIO()):
        coco = COCO(str(folder / "annotations.json"))
    categories = coco.loadCats(coco.getCatIds())
    ground = next(c for c in categories if c["name"] == "ground")["keypoints"]
    places = crossings()
    check(len(ground) == len(places), f"{len(ground)} crossings, not {len(places)}")
    check(sum(n[0] == "L" for n in ground) == 8 and sum(n[0] == "T" for n in ground) == 6, f"kinds of {ground}")
    by_place = sorted(map(tuple, places), key=lambda p: (round(p[0], 2), p[1]))
    kinds = {k: [p for p in by_place if kind_of(p) == k] for k in "LTX"}
    known = {name: kinds[name[0]][int(name[1:]) - 1] for name in ground}
    seen = {"ball": 0, "robot": 0, "person": 0, "goal": 0, "crossings": 0}
    for image in coco.loadImgs(coco.getImgIds()):
        frame, annotations = Frame(folder, image), coco.loadAnns(coco.getAnnIds(image["id"]))
        check(frame.color.shape == (SIZE[1], SIZE[0], 3), f"{frame.name}: size")
        check(frame.color.std() > 5, f"{frame.name}: nothing is there")
        for one in annotations:
            check_masks(coco, frame, one)
            category = coco.loadCats(one["category_id"])[0]["name"]
            seen[category] = seen.get(category, 0) + 1
            if category == "ball":
                check_ball(frame, one, 0.065)
            elif category == "robot":
                check_robot(frame, one)
            elif category == "ground":
                seen["crossings"] += check_ground(frame, one, ground, known)
        check_yolo(folder, frame, annotations, categories)
    check(min(seen.values()) > 0, f"not everything was seen: {seen}")
    print(f"{len(coco.imgs)} pictures, {len(coco.anns)} annotations: {seen}")


def kind_of(place):
    x, y = np.abs(place)
    if y == 1.075:
        return "L" if x < 2.9 else "T"
    return {1.975: "L" if x > 2 else "T"}.get(y, "X")


# ---- how they are made ----

def command(program, scene, folder, ranges, threads=1):
    return [program, "render", scene, "--dataset", str(folder), "--frames", str(FRAMES), "--seed", "5", "--normals", "--size",
            f"{SIZE[0]}x{SIZE[1]}", "--randomise", str(ranges), "--threads", str(threads)]


def contents(folder):
    return {str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}


def kill_in_between(call, folder):
    process = subprocess.Popen(call, stdout=subprocess.DEVNULL)
    while process.poll() is None and len(list(folder.glob("frames/*.json"))) < 3:
        time.sleep(0.002)
    process.send_signal(signal.SIGKILL)
    process.wait()
    return len(list(folder.glob("frames/*.json")))


def check_refused(call, words):
    done = subprocess.run(call, capture_output=True, text=True)
    check(done.returncode == 2 and done.stderr.count("\n") == 1 and words in done.stderr, f"{call[-1]}: {done.stderr}")


def main():
    program, scene = sys.argv[1:]
    with tempfile.TemporaryDirectory() as temp:
        root = pathlib.Path(temp)
        ranges = root / "ranges.toml"
        ranges.write_text(RANGES)
        first, second = root / "first", root / "second"
        subprocess.run(command(program, scene, first, ranges), check=True, stdout=subprocess.DEVNULL)
        check_dataset(first)
        montage = pathlib.Path(__file__).parents[2] / "scripts/dataset_montage"
        subprocess.run([sys.executable, montage, first, root / "montage.jpg", "--pictures", "4", "--masks"], check=True)
        check(Image.open(root / "montage.jpg").size == (1280, 240), "the montage")
        before = kill_in_between(command(program, scene, second, ranges, 2), second)
        subprocess.run(command(program, scene, second, ranges, 2), check=True, stdout=subprocess.DEVNULL)
        one, two = contents(first), contents(second)
        check(set(two) == set(one), "other files after a kill")
        differ = [name for name in one if two.get(name) != one[name]]
        check(not differ, f"after a kill at {before} pictures with other threads other bytes: {differ}")
        check_refused([*command(program, scene, first, ranges), "--set", "ball.radius=0.07"], "'set' was []")
        check_refused(command(program, scene, ranges / "x", ranges), "Not a directory")
        (root / "full").mkdir()
        (root / "full" / "holiday.jpg").write_text("")
        check_refused(command(program, scene, root / "full", ranges), "not empty")
        limited = ["bash", "-c", 'ulimit -f 8; exec "$@"', "-", *command(program, scene, root / "third", ranges)]
        check_refused(limited, "cannot write")
        manifest = json.loads((first / "manifest.json").read_text())
        check(manifest["seed"] == 5 and manifest["ranges"] == RANGES, "the manifest")
    print("\n".join(failures[:20]) or "all agree")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
