"""What is asked of a robot: to be read, to stand, to walk, to be converted."""

import json
import subprocess
import tempfile
from pathlib import Path

from zoo import oracles

LEVELS = ["kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"]
SECONDS = 10.0  # [s] of a trial
SPEED = 0.1  # [m/s] asked of a walk


def document(command, seconds=300):
    """(exit code, JSON of standard output or None, first error line) of a command that writes JSON to standard output."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=seconds)
    except subprocess.TimeoutExpired:
        return -1, None, f"not done after {seconds} s"
    lines = done.stderr.splitlines() or [""]
    error = next((line for line in lines if line.startswith("error") or "error:" in line), lines[-1])
    try:
        return done.returncode, json.loads(done.stdout), error
    except json.JSONDecodeError:
        return done.returncode, None, error


def same(ours, theirs):
    return abs(ours - theirs) <= 1e-6 * max(1.0, abs(theirs))


def read(program, kind, file):
    """{read, error, mass_kg, joints, soles, legs, findings, oracle, agrees}."""
    code, found, error = document([program, "check", str(file), "--json", "-"])
    result = {"read": code == 0 and found is not None, "error": "" if code == 0 else error}
    base = ""
    if found is not None:
        errors = [finding["what"] for finding in found["findings"] if finding["severity"] == "error"]
        result["error"] = errors[0] if errors else result["error"]
        base = found["tree"][0]["body"] if found.get("tree") else ""
        result |= {"mass_kg": found["total_mass_kg"], "joints": found["joints"], "findings": len(found["findings"]),
                   "soles": len(found["soles"]), "legs": len(found["legs"]),
                   "servos": sum("servo_law" in joint for joint in found["tree"])}
    result["oracle"] = oracles.of(kind, file, base)
    oracle = result["oracle"]
    if result["read"] and oracle and "mass_kg" in oracle:
        result["agrees"] = same(result["mass_kg"], oracle["mass_kg"]) and result["joints"] == oracle["joints"]
    return result


def is_humanoid(result):
    return result["read"] and result.get("legs") == 2 and result.get("soles") == 2


def motion(program, file, level, speed):
    """{ok, why, forward_m, sideways_m} of ten seconds at a commanded speed. A robot stands if it does not fall and stays within
    0.1 m; it walks if it does not fall, comes 0.5 to 1.3 m forward and stays within 0.5 m to the side."""
    command = [program, "run", "walk", "--no-cameras", "--duration", str(SECONDS), "--json", "-",
               "--set", f"walker.model={file}", "--set", f"walker.level={level}", "--set", f"walker.command=[{speed},0,0]",
               "--set", "walker.position=[0,0]"]
    code, report, error = document(command)
    if report is None or code != 0:
        return {"ok": False, "why": error}
    robot = report["entities"][0]
    forward, left = robot["position"][0], robot["position"][1]
    why = "freezes" if robot["frozen"] else "falls" if robot["falls"] else ""
    if not why and speed > 0.0 and not (0.5 <= forward <= 1.3 and abs(left) <= 0.5):
        why = "strays"
    if not why and speed == 0.0 and max(abs(forward), abs(left)) > 0.1:
        why = "strays"
    return {"ok": not why, "why": why, "forward_m": forward, "sideways_m": left}


def move(program, file):
    """{level: {stands, walks}} at all levels; empty for legs of too few hinges, which no gait here can move."""
    first = motion(program, file, LEVELS[0], 0.0)
    if "no leg that can be walked with" in first["why"]:
        return {}
    return {level: {"stands": motion(program, file, level, 0.0), "walks": motion(program, file, level, SPEED)}
            for level in LEVELS}


def convert(program, file, servos):
    """{mjcf, urdf}: "" if what is written runs in MuJoCo and is read by Pinocchio, else what is wrong."""
    result = {}
    with tempfile.TemporaryDirectory() as folder:
        for ending, judge in (("xml", oracles.runs_in_mujoco), ("urdf", oracles.reads_in_pinocchio)):
            out = Path(folder) / ending / f"robot.{ending}"
            out.parent.mkdir()
            done = subprocess.run([program, "convert", str(file), "--out", str(out)], capture_output=True, text=True, check=False)
            key = "mjcf" if ending == "xml" else "urdf"
            result[key] = (done.stderr.strip().splitlines() or ["?"])[-1] if done.returncode else judge(out, servos)
    return result
