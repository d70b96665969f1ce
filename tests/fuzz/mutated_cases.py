"""mutated_cases.py - calls of the program with errors in a file or in the options (for mutations.py).

A case is a list of arguments and the files that it needs, in a folder of its own that is the working directory.
"""

import pathlib
import re
import subprocess

from mutated_text import NUMBERS, TEXTS, mutated, mutated_bytes

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHORT = ["--duration", "0.01", "--no-cameras"]
LEVELS = ["kinematic_walking", "simplified_dynamics", "full_dynamics", "articulated_dynamics"]
ONE_ROBOT = """duration = 1
[ball]
position = [2, 0]
[[robots]]
name = "r1"
model = "MODEL"
level = "LEVEL"
controller = "none"
"""
MESH_ROBOT = """<mujoco><asset><mesh name="m" file="MESH"/></asset><worldbody><body name="b" pos="0 0 1"><freejoint/>
<geom type="mesh" mesh="m" mass="1"/></body></worldbody></mujoco>
"""
MESH_URDF = """<robot name="r"><link name="b"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><mesh filename="MESH"/></geometry></collision></link></robot>
"""
CSV = "time [s],a.x [m],a.y [m],b\n" + "".join(f"{0.1 * i:.1f},{i},{-i},{i * i}\n" for i in range(12))


def texts(pattern):
    return [file.read_text() for file in sorted(ROOT.glob(pattern))]


class Cases:
    """Makes any number of cases; the same random numbers make the same case."""

    def __init__(self, program):
        self.scenes = texts("scenes/*.toml")
        self.everything = (ROOT / "tests/fuzz/seeds/everything.toml").read_text()
        self.scene_names = sorted(file.stem for file in ROOT.glob("scenes/*.toml"))
        self.robots = texts("models/*.xml") + texts("tests/fuzz/seeds/*.mjcf")
        self.urdfs = texts("tests/fuzz/seeds/*.urdf")
        self.protos = texts("tests/fuzz/seeds/*.proto")
        self.sdfs = texts("tests/fuzz/seeds/*.sdf")
        self.tables = texts("models/*.toml")
        self.motions = texts("motions/*.toml")
        self.parts = texts("parts/*.toml")
        self.servos = texts("servos/*.toml")
        self.lenses = texts("lenses/*.yaml")
        self.logs = texts("tests/fuzz/seeds/*.json")
        self.meshes = {file.name: file.read_bytes() for pattern in ("stl", "obj", "dae")
                       for file in sorted(ROOT.glob(f"tests/fuzz/seeds/*.{pattern}"))}
        properties = subprocess.run([program, "list", "properties"], capture_output=True, text=True, check=True).stdout
        self.properties = re.findall(r"^([a-z_]+)", properties, re.MULTILINE)
        self.kinds = [(self.scene, 24), (self.mjcf, 14), (self.urdf, 8), (self.proto, 6), (self.sdf, 3),
                      (self.table, 9), (self.motion, 6), (self.part, 6), (self.servo, 4), (self.lens, 4),
                      (self.log, 4), (self.mesh, 5), (self.numbers, 3), (self.options, 24)]

    def make(self, rng):
        kinds, weights = zip(*self.kinds, strict=True)
        return rng.choices(kinds, weights)[0](rng)

    def scene(self, rng):
        text = self.everything if rng.random() < 0.5 else rng.choice(self.scenes)
        return ["run", "scene.toml", *SHORT, *rng.choice([[], [], ["--threads", "2"], ["--lenient"]])], {
            "scene.toml": mutated(rng, text)}

    def robot(self, rng, name, files):
        """What can be done with a robot file."""
        files["scene.toml"] = ONE_ROBOT.replace("MODEL", name).replace("LEVEL", rng.choice(LEVELS))
        lenient = rng.choice([[], [], ["--lenient"]])
        command = rng.choice([["check", name, *lenient], ["check", name, *lenient, "--json", "-"],
                              ["run", "scene.toml", *SHORT, *lenient], ["run", "scene.toml", *SHORT],
                              ["convert", name, "--out", "out.xml", *lenient],
                              ["check", name, "--roles", "roles.toml"]])
        return command, files

    def mjcf(self, rng):
        return self.robot(rng, "robot.xml", {"robot.xml": mutated(rng, rng.choice(self.robots))})

    def urdf(self, rng):
        return self.robot(rng, "robot.urdf", {"robot.urdf": mutated(rng, rng.choice(self.urdfs))})

    def proto(self, rng):
        return self.robot(rng, "robot.proto", {"robot.proto": mutated(rng, rng.choice(self.protos))})

    def sdf(self, rng):
        return self.robot(rng, "robot.sdf", {"robot.sdf": mutated(rng, rng.choice(self.sdfs))})

    def table(self, rng):
        which = rng.choice(["kid21", "quadruped", "spark_nao0", "car"])
        return self.robot(rng, "robot.xml", {"robot.xml": (ROOT / f"models/{which}.xml").read_text(),
                                             "robot.toml": mutated(rng, (ROOT / f"models/{which}.toml").read_text())})

    def motion(self, rng):
        scene = (ROOT / "scenes/get_up.toml").read_text()
        scene = re.sub(r'motion = "[^"]*"', 'motion = "motion.toml"', scene)
        files = {"scene.toml": scene, "motion.toml": mutated(rng, rng.choice(self.motions))}
        return ["run", "scene.toml", *SHORT], files

    def part(self, rng):
        part = rng.choice(self.parts)
        kind = re.search(r'^type = "(\w+)"', part, re.MULTILINE)
        scene = ONE_ROBOT.replace("MODEL", "kid21").replace("LEVEL", rng.choice(LEVELS))
        scene += f'[robots.sensors.mine]\ntype = "{kind.group(1) if kind else "imu"}"\n'
        scene += 'part = "part.toml"\nframe = "torso"\n'
        files = {"scene.toml": scene, "part.toml": part}
        which = rng.choice(["scene.toml", "part.toml", "part.toml"])
        files[which] = mutated(rng, files[which])
        return ["run", "scene.toml", *SHORT], files

    def servo(self, rng):
        return ["replay-servo", "log.json", "--servo", "servo.toml"], {
            "log.json": rng.choice(self.logs), "servo.toml": mutated(rng, rng.choice(self.servos))}

    def lens(self, rng):
        models = ["perspective", "plumb_bob", "rational_polynomial", "equidistant", "ray_polynomial", "x"]
        command = rng.choice([["lens", "lens.yaml"],
                              ["lens", "lens.yaml", "--as", rng.choice(models), "--out", "out.yaml"]])
        return command, {"lens.yaml": mutated(rng, rng.choice(self.lenses))}

    def log(self, rng):
        # a recording that a fit takes would be fitted, which takes minutes
        return ["replay-servo", "log.json", "--servo", rng.choice(["xl330", "xl330_m4", "mx64"])], {
            "log.json": mutated(rng, rng.choice(self.logs))}

    def mesh(self, rng):
        name, data = rng.choice(sorted(self.meshes.items()))
        robot = rng.choice(["robot.xml", "robot.urdf"])
        text = (MESH_ROBOT if robot == "robot.xml" else MESH_URDF).replace("MESH", name)
        if b"\0" in data or rng.random() < 0.2:
            data = mutated_bytes(rng, data)
        else:
            data = mutated(rng, data.decode("latin1")).encode("latin1", "replace")
        return self.robot(rng, robot, {robot: text, name: data})

    def numbers(self, rng):
        patterns = rng.choice([[], ["a"], ["*"], ["a.x", "zz"]])
        return ["plot", "run.csv", "--out", "run.png", *patterns], {"run.csv": mutated(rng, CSV)}

    # -- options

    def value(self, rng):
        return rng.choice([rng.choice(NUMBERS), rng.choice(TEXTS), rng.choice(LEVELS), "[1,2,3]", "[0,0,nan]",
                           "[" * 200, '"x"', "{a=1}", "{}", "[]", "a." * 2000,
                           rng.choice(["implicit_stick", "paper", "kelvin_voigt", "grass", "euler"])])

    def path(self, rng):
        entity = rng.choice(["walker", "robot", "r1", "blue1", "blue.*", "blue.1", "red*", "ball", "field", "*",
                             "nobody", "", "defaults", "start", "view", "light", rng.choice(TEXTS)])
        key = rng.choice(["level", "contact", "position", "command", "model", "sensors", "rate", "duration", "seed",
                          "gravity", "surface", "mass", "radius", "size", "heading_deg", "servo_law", "integrator",
                          "volume", "self_collision", "motion"])
        inner = rng.choice(["torso", "l_foot", "base", "field", "ball", "head", "*", "imu", "camera", "encoders", ""])
        last = rng.choice(self.properties)
        return rng.choice([key, f"{entity}.{key}", f"{entity}.{last}", f"{entity}.{inner}.{last}",
                           f"{entity}.{inner}.*", f"{entity}.*.*", f"{entity}.sensors.{inner}.rate",
                           f"{entity}.sensors.{inner}.accelerometer.noise", f"{entity}.{inner}",
                           "a." * rng.choice([2, 50, 5000]) + last, f"{entity}.{inner}.{last}.x"])

    def setting(self, rng):
        return rng.choice([f"{self.path(rng)}={self.value(rng)}", f"{self.path(rng)}={self.value(rng)}", self.path(rng),
                           "=", ""])

    def some_options(self, rng):
        time = rng.choice(["0", "0.005", "0.01", "-1", "nan", "1e300", "x", "", "1e9", "1e-12"])
        return rng.choice([
            ["--set", self.setting(rng)], ["--set", self.setting(rng)], ["--set", self.setting(rng)],
            ["--at", f"{time}:{self.setting(rng)}"], ["--at", self.setting(rng)],
            ["--log", self.path(rng), "--out", "l.csv"], ["--log", self.path(rng), "--out", "l.csv"],
            ["--log", "*", "--out", "l.csv", "--log-rate", rng.choice(NUMBERS)], ["--log", "walker"],
            ["--seed", rng.choice(NUMBERS)], ["--threads", rng.choice(["1", "2", "7", "0", "-1", "257", "x", "1e9"])],
            ["--speed", rng.choice(["max", "1", "1000", "0", "-1", "nan", "inf", "x", "1e300"])],
            ["--json", rng.choice(["-", "report.json", "/nowhere/x.json", ".", ""])],
            ["--pictures", "pictures", "--picture-every", rng.choice(["1", "0", "nan", "-1", "1e300", "1e-300"])],
            ["--duration", rng.choice(["0", "0.002", "-1", "nan", "inf", "1e300", "1e10", "x", ""])],
            [rng.choice(TEXTS)], ["--" + rng.choice(["levl", "help", "version", "sed", "thread", "x"])]])

    def options(self, rng):
        scene = rng.choice(self.scene_names + ["walk"] * 8)
        command = rng.choice([["run", scene], ["run", scene], ["run", scene], ["run", scene],
                              ["compare", scene, "--entity", "walker"], ["check", "kid21"], ["list"],
                              ["lens", "wolfgang_amy"], [rng.choice(TEXTS)], []])
        if command[:1] == ["run"]:
            command += SHORT
        if command[:1] == ["compare"]:
            command += ["--duration", "0.01", "--repeat", "1"]
        for _ in range(rng.choice([1, 1, 1, 2, 3])):
            command += self.some_options(rng)
        # the system does not take such arguments
        return [argument.replace("\0", "") for argument in command], {}
