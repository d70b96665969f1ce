"""The scenes of a race, as our scene files: robots of the model kid21, the same friction everywhere, nobody senses."""
import contextlib
import math
import pathlib
import tempfile
import tomllib

from running import ROOT

WALK = [0.15, 0, 0]  # [m/s, m/s, rad/s]
FRICTION = 0.8
SLOPE_DEG = 3
MATERIALS = ["rubber", "plastic", "carpet"]
# kid21 bends its knees and stretches them again, once every two seconds
SQUAT = """columns = [["j_l_thigh", "j_r_thigh"], ["j_l_shin", "j_r_shin"], ["j_l_ankle", "j_r_ankle"]]
start = [-0.3, 0.6, -0.3]
"""
SQUAT_FRAME = "[[frames]]\nduration = 1.0\nvalues = [{0}, {1}, {0}]\n"


def materials():
    pairs = [(a, b) for i, a in enumerate(MATERIALS) for b in MATERIALS[i:]]
    return "".join(f'[[materials]]\npair = ["{a}", "{b}"]\nfriction = {FRICTION}\nrolling = 0\n' for a, b in pairs)


def head(controller, extra=""):
    return (f'duration = 1000\n{extra}[field]\ngoals = false\nfriction = {FRICTION}\n[defaults]\nmodel = "kid21"\n'
            f'level = "articulated_dynamics"\nsensors = false\ncontroller = "{controller}"\n')


def places(count):
    """[m] In rows of six, out of reach."""
    return [(round(-3.5 + 1.3 * (i % 6), 3), round(-2.6 + 1.3 * (i // 6), 3)) for i in range(count)]


def robots_at(places, keys=""):
    return "".join(f'[[robots]]\nname = "r{i}"\nposition = [{", ".join(map(str, place))}]\n{keys}'
                   for i, place in enumerate(places))


def write_walk(folder, robots):
    (folder / "scene.toml").write_text(head("walk") + f"command = {WALK}\n" + robots_at(places(robots)) + materials())


def write_squat(folder, robots):
    frames = "".join(SQUAT_FRAME.format(-bend, 2 * bend) for _ in range(10) for bend in (0.6, 0.3))
    (folder / "squat.toml").write_text(SQUAT + frames)
    motion = f"motion = '{folder / 'squat.toml'}'\n"
    (folder / "scene.toml").write_text(head("keyframes") + motion + robots_at(places(robots)) + materials())


def write_heap(folder, robots):
    """The first robots of scenes/heap.toml: they fall over one spot, each turned in its own way."""
    heap = tomllib.loads((ROOT / "scenes/heap.toml").read_text())
    start = "seed = 2\n[start]\n" + "".join(f"{key} = {value}\n" for key, value in heap["start"].items())
    text = head("none", start) + robots_at([robot["position"] for robot in heap["robots"][:robots]]) + materials()
    (folder / "scene.toml").write_text(text)


def write_slope(folder, _robots):
    """One robot stands in the middle of a slope, 1 mm above it."""
    angle, half, thick, foot = math.radians(SLOPE_DEG), 1.0, 0.1, 0.08  # [rad, m, m, m]
    bottom = 0.02
    center = bottom + half * math.sin(angle) + thick / 2 * math.cos(angle)
    top = center + thick / 2 / math.cos(angle) - foot * math.sin(angle) + 0.001  # below the lowest edge of the feet
    body = (f'bodies = [{{name = "slope", shape = "box", size = [{2 * half}, {2 * half}, {thick}], pitch_deg = {-SLOPE_DEG}, '
            f'position = [0, 0, {bottom}], static = true, material = "carpet"}}]\n')
    place = robots_at([(0, 0, round(top, 6))], f"pitch_deg = {-SLOPE_DEG}\n")
    (folder / "scene.toml").write_text(head("walk", body) + place + materials())


WRITERS = {"walk": write_walk, "squat": write_squat, "heap": write_heap, "slope": write_slope}


@contextlib.contextmanager
def written(kind, robots):
    """A folder with scene.toml, for as long as it is needed."""
    with tempfile.TemporaryDirectory(prefix="murosimf_race_") as name:
        folder = pathlib.Path(name)
        WRITERS[kind](folder, robots)
        yield folder
