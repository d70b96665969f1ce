"""Files that nobody may touch, and who looks whether somebody does: inotify always, strace where it may trace."""
import ctypes
import hashlib
import os
import re
import select
import shutil
import struct
import subprocess
import tempfile
from pathlib import Path

SECRET = "CANARY_b51d7c"
IN_ALL = 0xFFF  # access, modify, attributes, close, open, move, create, delete

ROBOT = '[[robots]]\nname = "robot"\nmodel = "kid21"\nlevel = "simplified_dynamics"\n'
TETRAHEDRON = "solid s\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {corner}\n" for corner in face) + "endloop\nendfacet\n"
    for face in (("0 0 0", "0 1 0", "1 0 0"), ("0 0 0", "1 0 0", "0 0 1"), ("0 0 0", "0 0 1", "0 1 0"),
                 ("1 0 0", "0 1 0", "0 0 1"))) + "endsolid s\n"


def box_with_mesh(file, visual):
    use = 'contype="0" conaffinity="0" group="2" mass="0"' if visual else 'mass="0.1"'
    return (f'<mujoco><asset><mesh name="m" file="{file}"/></asset><worldbody><body name="box"><freejoint/>'
            f'<geom type="box" size="0.1 0.1 0.1" mass="1"/><geom type="mesh" mesh="m" {use}/></body></worldbody></mujoco>\n')


class World:
    """run/: what a run is started with, and scenes that name what is not theirs; outside/: what nobody may touch."""

    def __init__(self, folder):
        self.root = Path(folder).resolve()
        self.run, self.outside = self.root / "run", self.root / "outside"
        for each in (self.run / ".hidden", self.outside / "motions"):
            each.mkdir(parents=True)
        self._write_outside()
        self._write_run()

    def _write_outside(self):
        out = self.outside
        (out / "scene.toml").write_text(ROBOT, encoding="utf-8")
        (out / "secret.toml").write_text(f'password = "{SECRET}"\n', encoding="utf-8")
        (out / "broken.toml").write_text(f"x = [\n {SECRET} {SECRET}", encoding="utf-8")
        (out / "motions/secret.toml").write_text(f'columns = ["{SECRET}"]\n', encoding="utf-8")
        (out / "model.xml").write_text(f"<mujoco><{SECRET}/></mujoco>\n", encoding="utf-8")
        (out / "mesh.stl").write_text(TETRAHEDRON, encoding="utf-8")
        (out / "table.csv").write_text(f"time,{SECRET}\n0,1\n", encoding="utf-8")
        (out / "lens.yaml").write_text(f"{SECRET}: 1\n", encoding="utf-8")
        (out / "code.py").write_text(f'open("{out}/ran", "w")\n', encoding="utf-8")
        (out / "code.so").write_bytes(b"\x7fELF: that it is opened is too much already")
        os.mkfifo(out / "pipe.toml")

    def _write_run(self):
        def scene(name, more="", body=""):
            (self.run / name).write_text(ROBOT + more + body, encoding="utf-8")

        out = self.outside
        scene("first.toml", 'controller = "walk"\ncommand = [0.1, 0, 0]\n')
        (self.run / "team.toml").write_text('[[teams]]\nname = "blue"\n' + ROBOT + 'team = "blue"\ncontroller = "tcp"\n',
                                            encoding="utf-8")
        (self.run / ".hidden/scene.toml").write_text(ROBOT, encoding="utf-8")
        (self.run / ".key.toml").write_text(ROBOT, encoding="utf-8")
        (self.run / "own_secret.toml").write_text(f'password = "{SECRET}"\n', encoding="utf-8")
        (self.run / "own_broken.toml").write_text(f"x = [\n {SECRET} {SECRET}", encoding="utf-8")
        (self.run / "own_model.xml").write_text(f"<mujoco>\n<{SECRET}/></mujoco>\n", encoding="utf-8")
        shutil.copy(out / "code.so", self.run / "code.so")
        (self.run / "link.toml").symlink_to(out / "scene.toml")
        (self.run / "way_out").symlink_to(out)
        os.mkfifo(self.run / "pipe.toml")
        for name, library in (("library", f"{out}/code.so"), ("own_library", "./code.so"), ("up_library", "../outside/code.so")):
            scene(f"names_{name}.toml", f'controller = "library"\nlibrary = "{library}"\n')
        shutil.copy(out / "code.py", self.run / "code.py")
        for name, file in (("class", f"{out}/code.py"), ("own_class", "./code.py"), ("module", "code"),
                           ("up_class", "../outside/code.py")):
            scene(f"names_{name}.toml", f'controller = "python"\noptions = {{class = "{file}:X"}}\n')
        scene("names_table.toml", f'controller = "trajectory"\noptions = {{file = "{out}/table.csv"}}\n')
        scene("names_motion.toml", f'controller = "keyframes"\nmotion = "{out}/motions/secret.toml"\n')
        scene("names_bus.toml", f'controller = "serial"\noptions = {{bus = "{out}/table.csv"}}\n')
        scene("names_software.toml", 'controller = "tcp"\n')
        scene("names_part.toml", f'sensors.imu = {{part = "{out}/secret.toml"}}\n')
        scene("names_lens.toml", f'[robots.sensors.eye]\ntype = "camera"\nlens = "{out}/lens.yaml"\n')
        scene("names_model.toml", body=f'[[bodies]]\nname = "box"\nmodel = "{out}/model.xml"\n')
        scene("names_own_model.toml", body='[[bodies]]\nname = "box"\nmodel = "./own_model.xml"\n')
        for name, file in (("mesh", f"{out}/mesh.stl"), ("up_mesh", "../outside/mesh.stl"), ("linked_mesh", "way_out/mesh.stl")):
            for visual in (False, True):
                model = f"{name}_{'eye' if visual else 'touch'}"
                (self.run / f"{model}.xml").write_text(box_with_mesh(file, visual), encoding="utf-8")
                scene(f"names_{model}.toml", body=f'[[bodies]]\nname = "box"\nmodel = "./{model}.xml"\n')
        (self.run / "include.xml").write_text(f'<mujoco><include file="{out}/model.xml"/></mujoco>\n', encoding="utf-8")
        scene("names_include.toml", body='[[bodies]]\nname = "box"\nmodel = "./include.xml"\n')

    def scenes_that_name(self):
        return sorted(str(file) for file in self.run.glob("names_*.toml"))

    def state(self):
        """What stands where, to the byte."""
        found = {}
        for file in sorted(self.root.rglob("*")):
            status = file.lstat()
            content = hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() and not file.is_symlink() else ""
            found[str(file)] = (status.st_mode, status.st_mtime_ns if content else 0, content)
        return found


class Watch:
    """Whatever happens in folders, also that a file is opened: inotify."""

    def __init__(self, folders):
        self._libc = ctypes.CDLL(None, use_errno=True)
        self._number = self._libc.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        if self._number < 0:
            raise OSError(ctypes.get_errno(), "inotify")
        self._names = {}
        for folder in folders:
            for path in (folder, *(f for f in Path(folder).rglob("*") if f.is_dir())):
                watch = self._libc.inotify_add_watch(self._number, os.fsencode(path), IN_ALL)
                self._names[watch] = str(path)

    def seen(self):
        """Files that were touched since it was asked before, each once."""
        touched = []
        while select.select([self._number], [], [], 0)[0]:
            data, at = os.read(self._number, 1 << 16), 0
            while at < len(data):
                watch, mask, _, size = struct.unpack_from("iIII", data, at)
                name = data[at + 16:at + 16 + size].rstrip(b"\0").decode()
                at += 16 + size
                if mask & 0x40000000 and not name:  # the folder itself was listed
                    continue
                touched.append(f"{self._names.get(watch, '?')}/{name}")
        return sorted(set(touched))

    def close(self):
        os.close(self._number)


class Trace:
    """What a process opens, renames and removes, everywhere: strace. `command` starts the process."""

    CALLS = "open,openat,openat2,creat,rename,renameat,renameat2,unlink,unlinkat,mkdir,mkdirat,symlink,symlinkat,link,linkat," \
            "execve,execveat"
    LINE = re.compile(r'(\w+)\((.*?)(?:\)\s+= (-?\d+)| <unfinished \.\.\.>$)')
    PATH = re.compile(r'(?:\d+<([^>]*)>, )?"((?:[^"\\]|\\.)*)"')  # of a folder's descriptor, if it is relative to one

    def __init__(self, folder):
        self.file = Path(folder) / "trace"
        self.command = ["strace", "-f", "-qq", "-y", "-s", "400", "-e", f"trace={self.CALLS}", "-e", "signal=none", "-o",
                        str(self.file)]
        self._read = 0

    @staticmethod
    def works():
        if not shutil.which("strace"):
            return False
        tried = subprocess.run(["strace", "-f", "-o", "/dev/null", "true"], check=False, capture_output=True, timeout=60)
        return tried.returncode == 0

    def begin(self):
        """What was done so far is that of the start."""
        self._read = self.file.stat().st_size

    def calls(self):
        """(call, paths, whether it writes, whether it was done) since begin()."""
        with open(self.file, encoding="utf-8", errors="replace") as lines:
            lines.seek(self._read)
            for line in lines:
                found = self.LINE.search(line)
                if found:
                    call, words, result = found[1], found[2], int(found[3] or 0)  # unfinished: as if it was done
                    writes = not call.startswith("open") or re.search(r"O_WRONLY|O_RDWR|O_CREAT", words) is not None
                    paths = [os.path.join(folder, name) for folder, name in self.PATH.findall(words)]
                    yield call, paths, writes, result >= 0


def temporary(prefix):
    return tempfile.TemporaryDirectory(prefix=prefix)
