#!/usr/bin/env python3
"""Compares mass, center, inertia and place of meshes with those that MuJoCo finds for the same files.

Makes random convex, concave and open meshes as STL and OBJ files and in the MJCF file itself, scaled, mirrored, moved
and turned, with every kind of mesh inertia, two to a body.

Usage: meshes_against_mujoco.py <dump_masses>
Exit: 0 all agree, 1 some differ, 77 MuJoCo is not installed (test is skipped).
"""
import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import mujoco
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; pip install mujoco")
    sys.exit(77)

ROBOTS = 60
TOLERANCE = 1e-12  # [1] of mass, and of the size; both sides compute in double
# [1] of mass times size squared; MuJoCo finds principal axes to about 1e-8, as a sum in extended precision shows
INERTIA_TOLERANCE = 1e-7
PLACE_TOLERANCE = 1e-6  # [1] of the size; MuJoCo keeps vertices in single precision

# an L from above, and its cap in triangles
OUTLINE = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)]
CAP = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]


def concave(random):
    """A prism on a bent L."""
    n = len(OUTLINE)
    height = random.uniform(0.2, 2)
    bend = random.uniform(-0.2, 0.2, (n, 2))
    vertices = [(*(np.array(p) + b), z) for z in (0, height) for p, b in zip(OUTLINE, bend, strict=True)]
    faces = [(a, c, b) for a, b, c in CAP] + [(a + n, b + n, c + n) for a, b, c in CAP]
    for i in range(n):
        j = (i + 1) % n
        faces += [(i, j, j + n), (i, j + n, i + n)]
    return np.array(vertices), np.array(faces)


def convex(random):
    """An octahedron with moved corners: one to each side of the axes."""
    vertices = np.array([sign * np.eye(3)[axis] for axis in range(3) for sign in (1, -1)])
    vertices = vertices * random.uniform(0.5, 1.5, (6, 1)) + random.uniform(-0.05, 0.05, (6, 3))
    faces = []
    for x in (0, 1):
        for y in (2, 3):
            for z in (4, 5):
                faces.append((x, y, z) if (x + y + z) % 2 == 0 else (x, z, y))
    return vertices, np.array(faces)


def make_mesh(random):
    """Vertices and faces, in single precision so that an STL file holds the same numbers; and whether they close."""
    vertices, faces = concave(random) if random.random() < 0.6 else convex(random)
    closed = random.random() < 0.8
    vertices = (0.1 * vertices + random.uniform(-0.3, 0.3, 3)).astype(np.float32).astype(float)
    return vertices, faces if closed else faces[:-1], closed


def numbers(values):
    return " ".join(f"{value:.17g}" for value in np.ravel(values))


def write_obj(path, vertices, faces):
    lines = [f"v {numbers(v)}" for v in vertices] + ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def write_stl(path, vertices, faces):
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *vertices[f].ravel(), 0) for f in faces)
    path.write_bytes(b"solid, but binary".ljust(80) + struct.pack("<I", len(faces)) + triangles)


def mesh_element(random, folder, name):
    vertices, faces, closed = make_mesh(random)
    kind = random.choice(["legacy", "convex", "shell"] + (["exact"] if closed else []))
    scale = random.uniform(0.5, 2, 3) * random.choice([1, -1], 3)
    place = f'scale="{numbers(scale)}" refpos="{numbers(random.uniform(-1, 1, 3))}" '
    place += f'refquat="{numbers(random.normal(size=4))}" inertia="{kind}"'
    form = random.choice(["obj", "stl", "inline"])
    if form == "inline":
        return f'<mesh name="{name}" vertex="{numbers(vertices)}" face="{numbers(faces)}" {place}/>'
    (write_obj if form == "obj" else write_stl)(folder / f"{name}.{form}", vertices, faces)
    return f'<mesh file="{name}.{form}" {place}/>'


def geom_element(random, name):
    weight = f'mass="{random.uniform(0.1, 2)}"' if random.random() < 0.5 else f'density="{random.uniform(100, 2000)}"'
    place = f'pos="{numbers(random.uniform(-1, 1, 3))}" quat="{numbers(random.normal(size=4))}"'
    return f'<geom type="mesh" mesh="{name}" {weight} {place}/>'


def write_robot(random, folder, number):
    names = [f"r{number}_{i}" for i in range(random.integers(1, 3))]
    meshes = "\n".join(mesh_element(random, folder / "meshes", name) for name in names)
    geoms = "\n".join(geom_element(random, name) for name in names)
    path = folder / f"r{number}.xml"
    path.write_text(f'<mujoco><compiler meshdir="meshes"/><asset>\n{meshes}\n</asset>\n'
                    f'<worldbody><body name="b"><freejoint/>\n{geoms}\n</body></worldbody></mujoco>\n')
    return path


def matrix(quaternion):
    flat = np.zeros(9)
    mujoco.mju_quat2Mat(flat, quaternion)
    return flat.reshape(3, 3)


def box_of_geom(model, geom):
    mesh = model.geom_dataid[geom]
    first = model.mesh_vertadr[mesh]
    vertices = model.mesh_vert[first:first + model.mesh_vertnum[mesh]].astype(float)
    placed = vertices @ matrix(model.geom_quat[geom]).T + model.geom_pos[geom]
    return np.array([placed.min(axis=0), placed.max(axis=0)])


def errors(path, ours):
    """(what, difference over tolerance) of every quantity of one robot."""
    model = mujoco.MjModel.from_xml_path(str(path))
    boxes = np.array([box_of_geom(model, geom) for geom in range(model.ngeom)])
    size = np.abs(boxes).max()
    mass = model.body_mass[1]
    yield f"mass of {path.name}", abs(mass - ours["mass"]) / mass / TOLERANCE
    yield f"center of {path.name}", np.abs(model.body_ipos[1] - ours["center"]).max() / size / TOLERANCE
    axes = matrix(model.body_iquat[1])
    inertia = axes @ np.diag(model.body_inertia[1]) @ axes.T
    xx, yy, zz, xy, xz, yz = ours["inertia"]
    difference = np.abs(inertia - [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).max()
    yield f"inertia of {path.name}", difference / (mass * size * size) / INERTIA_TOLERANCE
    yield f"place of {path.name}", np.abs(boxes - ours["boxes"]).max() / size / PLACE_TOLERANCE


def main():
    random = np.random.default_rng(1)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "meshes").mkdir()
        paths = [write_robot(random, folder, i) for i in range(ROBOTS)]
        output = subprocess.run([sys.argv[1], *map(str, paths)], check=True, capture_output=True, text=True).stdout
        found = [error for path, ours in zip(paths, json.loads(output), strict=True) for error in errors(path, ours)]
    what, worst = max(found, key=lambda entry: entry[1])
    print(f"{len(found)} quantities of {ROBOTS} robots, largest difference {worst:.3g} of the tolerance ({what})")
    # written so that NaN fails
    return 0 if all(error <= 1 for _, error in found) else 1


if __name__ == "__main__":
    sys.exit(main())
