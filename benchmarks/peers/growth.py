"""How the cost of a step grows: with robots, in four arrangements, and with the joints of one robot; ours alone.

    benchmarks/peers/race.py growth
    benchmarks/peers/growth.py --program OLD --program NEW     two programs by turns, which must come to the same states

Arrangements of kid21: "apart" in rows of twenty, 1 m apart, all the same way, without cameras; "groups" of four that push each
other all the time; "rays" as apart, each with a laser (1081 rays) and a sonar, ten samples per second; "eyes" with a detector
instead, which looks at all others, so what it is asked for grows with the square of the robots. Joints: a box on the ground
with arms of five hinges each. The time of a step is the processor time of a run less that of a run of 0 s, divided by the number
of steps: the least of the rounds, of either kind. Exponents are those of a power law through all sizes.
"""
import argparse
import json
import math
import pathlib
import resource
import subprocess
import tempfile

from contest import print_table
from running import ROOT, fail

ROBOTS = [1, 2, 5, 10, 20, 50, 100, 200]
JOINTS = [5, 10, 20, 30, 50, 100]
STEPS = 1000  # per second
CASES = [  # arrangement, level, simulated seconds of 100 robots
    ("apart", "kinematic_walking", 0.5),
    ("apart", "simplified_dynamics", 0.5),
    ("apart", "full_dynamics", 0.3),
    ("apart", "articulated_dynamics", 0.3),
    ("groups", "kinematic_walking", 0.5),
    ("groups", "simplified_dynamics", 0.5),
    ("rays", "kinematic_walking", 0.2),
    ("eyes", "kinematic_walking", 0.2),
]
RAYS = """  [robots.sensors.laser]
  type = "laser"
  frame = "head"
  rate = 10
  [robots.sensors.sonar]
  type = "sonar"
  frame = "torso"
  rate = 10
"""
EYES = """  [robots.sensors.detector]
  type = "detector"
  frame = "head"
  rate = 10
"""
SENSORS = {"rays": RAYS, "eyes": EYES}
HINGES_OF_ARM = 5


def place(arrangement, i):
    """Position [m] and heading [deg] of robot i."""
    if arrangement != "groups":
        return i % 20, i // 20, 0
    group, corner = divmod(i, 4)
    angle = math.radians(45 + 90 * corner)
    x = 2 * (group % 8) + 0.25 * math.cos(angle)
    y = 2 * (group // 8) + 0.25 * math.sin(angle)
    return round(x, 4), round(y, 4), 45 + 90 * corner - 180


def crowd(arrangement, level, robots):
    text = "duration = 1\n[ball]\nposition = [-5, -5]\n"
    for i in range(robots):
        x, y, heading = place(arrangement, i)
        text += (f'[[robots]]\nname = "r{i}"\nmodel = "kid21"\nlevel = "{level}"\ncontroller = "walk"\n'
                 f'command = [0.1, 0, 0]\nposition = [{x}, {y}]\nheading_deg = {heading}\n')
        text += "[robots.sensors]\ncamera = false\n"
        text += SENSORS.get(arrangement, "")
    return text


def arm(first, count, number):
    """One link within the other, each on a hinge; every second one turns about another axis."""
    if count == 0:
        return ""
    axis = "0 1 0" if first % 2 else "1 0 0"
    rest = arm(first + 1, count - 1, number)
    offset = "0 0 0.1" if first else f"{0.08 * (number % 5) - 0.16:.3g} {0.08 * (number // 5) - 0.16:.3g} 0.1"
    return (f'<body pos="{offset}"><joint name="arm{number}_{first}" axis="{axis}" armature="0.01" damping="0.9"/>'
            f'<geom type="capsule" size="0.02 0.03" pos="0 0 0.05" mass="0.1"/>{rest}</body>')


def robot_with(joints):
    """MJCF of a heavy box with arms that have so many hinges in all."""
    whole, left = divmod(joints, HINGES_OF_ARM)
    arms = [HINGES_OF_ARM] * whole + ([left] if left else [])
    names = [f"arm{number}_{i}" for number, count in enumerate(arms) for i in range(count)]
    actuators = "".join(f'<position joint="{name}" kp="30" forcerange="-6 6"/>' for name in names)
    bodies = "".join(arm(0, count, number) for number, count in enumerate(arms))
    return ('<mujoco model="arms"><worldbody><body name="box" pos="0 0 0.1"><freejoint/>'
            f'<geom type="box" size="0.3 0.3 0.1" mass="20"/>{bodies}</body></worldbody>'
            f'<actuator>{actuators}</actuator></mujoco>\n')


def arms_scene(folder, joints):
    (folder / "arms.xml").write_text(robot_with(joints))
    return (f"duration = 1\n[field]\ngoals = false\n[[robots]]\nname = \"arms\"\nmodel = '{folder / 'arms.xml'}'\n"
            'level = "articulated_dynamics"\ncontroller = "none"\n')


def processor_seconds(program, file, duration):
    """Of a run, and the state that it comes to."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "run", file, "--duration", str(duration), "--no-cameras", "--threads", "1", "--json", "-"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        fail(f"growth: {done.stderr.strip()}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, json.loads(done.stdout)["state_hash"]


def measure(programs, text, duration, rounds, folder):
    """Start-up [s] and step [us] of each program; programs take turns, and must come to the same state."""
    file = folder / "scene.toml"
    file.write_text(text)
    startup, whole, states = [math.inf] * len(programs), [math.inf] * len(programs), set()
    for _ in range(rounds):
        for k, program in enumerate(programs):
            startup[k] = min(startup[k], processor_seconds(program, file, 0)[0])
            took, state = processor_seconds(program, file, duration)
            whole[k] = min(whole[k], took)
            states.add(state)
    if len(states) > 1:
        fail("growth: the programs come to different states")
    return [(start, 1e6 * (total - start) / (STEPS * duration)) for start, total in zip(startup, whole, strict=True)]


def exponent(points):
    """Of the power law through (size, time), by least squares of their logarithms; NaN if some time is lost in noise."""
    if any(time <= 0 for _, time in points):
        return math.nan
    x, y = ([math.log(value) for value in values] for values in zip(*points, strict=True))
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y, strict=True)) / sum((a - mean_x) ** 2 for a in x)


def row_of(program, what, sizes, found, k):
    points = [(size, each[k][1]) for size, each in zip(sizes, found, strict=True)]
    return {"program": str(program), "what": what, "sizes": sizes, "us": [round(us, 2) for _, us in points],
            "startup_s": [round(each[k][0], 4) for each in found], "exponent": round(exponent(points), 3)}


def show(title, sizes, rows):
    print_table(f"{title}, us of processor time per step of 1 ms", ["", *sizes, "exponent", "start-up s of the largest"],
                [[row["what"], *(f"{us:.1f}" for us in row["us"]), f"{row['exponent']:.2f}", f"{row['startup_s'][-1]:.2f}"]
                 for row in rows])


def robots_rows(programs, case, rounds, folder, sizes):
    arrangement, level, duration = case
    # few robots run longer, so that there is something to be measured
    found = [measure(programs, crowd(arrangement, level, robots), duration * max(1, 100 / robots), rounds, folder)
             for robots in sizes]
    return [row_of(program, f"{arrangement}, {level}", sizes, found, k) for k, program in enumerate(programs)]


def joints_rows(programs, rounds, folder, sizes, duration):
    found = [measure(programs, arms_scene(folder, joints), duration, rounds, folder) for joints in sizes]
    return [row_of(program, "articulated_dynamics", sizes, found, k) for k, program in enumerate(programs)]


def grow(programs, rounds, quick=False, only=None):
    robots, joints = (ROBOTS[2:4], JOINTS[:2]) if quick else (ROBOTS, JOINTS)
    cases = [case for case in (CASES[:1] if quick else CASES) if only in (None, case[0])]
    with tempfile.TemporaryDirectory(prefix="murosimf_growth_") as name:
        folder = pathlib.Path(name)
        rows = [row for case in cases for row in robots_rows(programs, case, rounds, folder, robots)]
        show("robots", robots, rows)
        if only:
            return rows
        arms = joints_rows(programs, rounds, folder, joints, 0.5 if quick else 10)
        show("joints of one robot", joints, arms)
    return rows + arms


def part(machine, options):
    return grow([machine.own("murosimf")], options.rounds, options.quick)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--program", action="append", help="again: several in turns, which must come to the same states")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--only", choices=sorted({case[0] for case in CASES}), help="one arrangement")
    parser.add_argument("--out", type=pathlib.Path, help="JSON file to write")
    options = parser.parse_args()
    if not 1 <= options.rounds <= 1000:
        parser.error("--rounds must be 1 to 1000")
    rows = grow(options.program or [ROOT / "build/release/murosimf"], options.rounds, only=options.only)
    if options.out:
        options.out.write_text(json.dumps({"schema": "murosimf/growth/1", "rows": rows}, indent=1) + "\n")


if __name__ == "__main__":
    main()
