"""Robot files of others: wheels of PyPI, unpacked into a folder, and which of their files are robots."""

import subprocess
import sys
import xml.etree.ElementTree as xml
import zipfile

# Versions are pinned, so that figures mean the same robots wherever they are counted.
WHEELS = {
    "example-robot-data": "6.0.0",
    "dm_control": "1.0.50",
    "gymnasium": "1.4.0",
    "gymnasium-robotics": "1.4.2",
    "icub-models": "3.2.0",
    "jvrc-description": "1.1.1",
    "fourier-robot-descriptions": "0.2.7",
    "gb-robot-models": "0.1.0",
}


def fetch(folder, names):
    """Downloads and unpacks what `folder` does not have yet. Raises RuntimeError with pip's last line."""
    for name in names:
        target = folder / name
        if target.is_dir():
            continue
        wheels = folder / "wheels" / name
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary", ":all:",
                   "--dest", str(wheels), f"{name}=={WHEELS[name]}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{name} {WHEELS[name]} is not to be had: {(done.stderr.strip().splitlines() or ['?'])[-1]}")
        (wheel,) = wheels.glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(target.with_suffix(".part"))
        target.with_suffix(".part").rename(target)


def root_element(file):
    """Name of the first element and the names of all, or an empty pair for what is no XML."""
    try:
        root = xml.parse(file).getroot()
    except xml.ParseError:
        return "", set()
    return root.tag, {element.tag for element in root.iter()}


def files(folder, name):
    """(format, file) of all robots in a wheel, sorted. Files of MuJoCo that bodies of others include, or that are scenes without
    a joint, are not robots; a file that includes others may have its joints there."""
    found = []
    for file in sorted((folder / name).rglob("*")):
        if file.suffix not in (".urdf", ".xml", ".sdf"):
            continue
        tag, elements = root_element(file)
        if tag == "robot" and "link" in elements:
            found.append(("urdf", file))
        elif tag == "sdf" and "link" in elements:
            found.append(("sdf", file))
        elif tag == "mujoco" and elements & {"joint", "freejoint", "include", "attach"}:
            found.append(("mjcf", file))
    return found
