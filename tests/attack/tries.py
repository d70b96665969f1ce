"""What attackers say: names of files, settings, garbage."""
import random
import struct


def names_of_files(world):
    """(what it is, a name that is not to be opened, the same of a file that is not there or None)."""
    out, run = world.outside, world.run
    yield "absolute", f"{out}/scene.toml", f"{out}/nosuch.toml"
    yield "absolute, no ending", f"{out}/scene", f"{out}/nosuch"
    yield "above", "../outside/scene.toml", "../outside/nosuch.toml"
    yield "above, absolute", f"{run}/../outside/scene.toml", f"{run}/../outside/nosuch.toml"
    yield "doubled", f"{run}//..//outside/./scene.toml", f"{run}//..//outside/./nosuch.toml"
    yield "secret", f"{out}/secret.toml", f"{out}/nosecret.toml"
    yield "broken", f"{out}/broken.toml", f"{out}/nobroken.toml"
    yield "link", f"{run}/link.toml", None
    yield "linked folder", f"{run}/way_out/scene.toml", f"{run}/way_out/nosuch.toml"
    yield "back through link", f"{run}/way_out/../outside/scene.toml", None
    yield "pipe", f"{out}/pipe.toml", f"{out}/nopipe.toml"
    yield "own pipe", f"{run}/pipe.toml", None
    yield "proc root", f"/proc/self/root{out}/scene.toml", f"/proc/self/root{out}/nosuch.toml"
    yield "proc folder", "/proc/self/cwd/../outside/scene.toml", "/proc/self/cwd/../outside/nosuch.toml"
    for name in ("/proc/self/environ", "/proc/self/cmdline", "/proc/self/mem", "/proc/self/fd/0", "/dev/zero", "/dev/stdin",
                 "/dev/tcp/127.0.0.1/80", "/etc/passwd", "/etc/shadow", "/", ".", "..", "~/.ssh/id_rsa", "$HOME/x.toml",
                 "file:///etc/passwd", "http://127.0.0.1/x.toml", "\\\\host\\share", "--help", "-", "*", "?", "\x7f", "\u202e",
                 f"{run}/.hidden/scene.toml", f"{run}/.key.toml", f"{run}", f"{run}/", f"{run}/first.toml/", "CMakeLists.txt",
                 f"{run}/first.toml\0.toml", f"{out}/scene.toml\0/../../run/first.toml", "first.toml\n", "a" * 300, "a/" * 3000,
                 "../" * 500 + "etc/passwd"):
        yield "special", name, None
    yield "empty", "", None


def settings(world):
    """Overrides that name files, load software, or bring tables in."""
    out = world.outside
    for path in ("robot.library", "*.library", "rob?t.library", "defaults.library", "robots.library", "robot.options.library"):
        for value in (f"{out}/code.so", "./code.so", f'"{out}/code.so"', f"'{out}/code.so'"):
            yield f"{path}={value}"
    for key, value in (("controller", "library"), ("controller", "tcp"), ("controller", "serial"), ("model", f"{out}/model.xml"),
                       ("controller", "python"), ("options.class", f"{out}/code.py:X"), ("options.class", "code:X"),
                       ("model", "../outside/model.xml"), ("model", "way_out/model.xml"), ("model", "/dev/zero"),
                       ("motion", f"{out}/motions/secret.toml"), ("motion", "../outside/motions/secret"),
                       ("options.file", f"{out}/table.csv"), ("options.bus", f"{out}/table.csv"), ("reload", "true"),
                       ("options.python", f"{out}/code.py"), ("sensors.imu.part", f"{out}/secret.toml"),
                       ("sensors.eye.lens", f"{out}/lens.yaml"), ("sensors.eye.calibration", f"{out}/lens.yaml"),
                       ("sensors.eye", f'{{type = "camera", lens = "{out}/lens.yaml"}}'), ("name", "../../outside/x"),
                       ("options", f'{{file = "{out}/table.csv"}}'), ("link", "{delay = 1}"), ("servo_law", f"{out}/secret.toml"),
                       ("level", f"{out}/secret.toml"), ("team", "../x"), ("no_contact", '[["a", "b"]]')):
        for who in ("robot", "*", "defaults"):
            yield f"{who}.{key}={value}"
    yield f'robots=[{{name = "r", model = "kid21", controller = "library", library = "{out}/code.so"}}]'
    yield f'defaults={{controller = "library", library = "{out}/code.so"}}'
    yield f'bodies=[{{name = "b", model = "{out}/model.xml"}}]'
    yield f'seed=1\n[[robots]]\nname = "r"\nlibrary = "{out}/code.so"'
    yield f"light.name={out}/secret.toml"
    yield "league.answer_port=53"
    yield f"name={out}/x"
    yield "plugins=['x.so']"
    yield "views.a.eye=['x']"
    yield "=x"
    yield "x"
    yield "." * 1000 + "=1"
    yield "seed=" + "[" * 1500
    yield "robot.level=" + "x" * 60000
    yield "\0robot.library=x"


def changes(world):
    """The same while it runs."""
    yield from settings(world)
    yield from (f"save={world.outside}/x.state", f"record={world.outside}/x.mcap", f"robot.picture={world.outside}/x.png",
                "robot.torso.mass=nan", "robot.nothing.at_all=1", "ball.radius=1e300", "light.file=/etc/passwd")


def garbage(seed, count, largest=3000):
    """Bytes: chance, and lengths that are lies."""
    numbers = random.Random(seed)
    for kind in range(count):
        data = numbers.randbytes(numbers.randint(0, largest))
        if kind % 4 == 1:
            data = struct.pack(">I", len(data)) + data
        elif kind % 4 == 2:
            data = struct.pack(">I", numbers.choice((0, 1, 65537, 0x7FFFFFFF, 0xFFFFFFFF))) + data
        elif kind % 4 == 3:
            data = struct.pack(">I", 200) + data[:100]
        yield data


def mutated(data, seed, count):
    """Some bytes are others, or are missing."""
    numbers = random.Random(seed)
    for _ in range(count):
        changed = bytearray(data)
        for _ in range(numbers.randint(1, 8)):
            if changed:
                changed[numbers.randrange(len(changed))] = numbers.randrange(256)
        if numbers.random() < 0.3:
            del changed[numbers.randrange(len(changed) + 1):]
        yield bytes(changed)
