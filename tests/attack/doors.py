"""A run with open doors, and whether attacks have left it as it was."""
import os
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

from canaries import Trace, Watch, temporary

TOKEN = "only-an-attack-knows-this"
LIMIT = 120  # [s] for whatever has to happen

# What a run may open after its start, besides its own folder and the program's: the system's libraries, devices of the
# process itself, random numbers, and folders that the program makes for a state that it is sent.
SYSTEM = re.compile(r"^(/usr/lib|/lib|/lib64|/etc/ld\.so\.|/proc/self/cmdline$|/proc/sys/vm/|/sys/|"
                    r"/dev/(u?random|null|shm|pts)|/usr/share/zoneinfo)")


class Attacker:
    """`rounds`: how much is left to chance; `traced`: by strace."""

    def __init__(self, program, world, book, rounds, traced):
        self.program, self.world, self.book, self.rounds, self.traced = program, world, book, rounds, traced


class Run:
    """murosimf run with these words, in the folder of a world. Ends with the block; what() was touched is then known."""

    def __init__(self, program, world, words, doors, traced):
        self._folder = temporary("attacked_")
        self._trace = Trace(self._folder.name) if traced else None
        self._watch = Watch([world.outside])
        self._world, self._data = world, data_folders(program)
        self.before = world.state()
        command = [*(self._trace.command if self._trace else []), program, "run", *words, "--no-cameras"]
        self.process = subprocess.Popen(command, cwd=world.run, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        env={**os.environ, "MUROSIMF_SUPERVISION_TOKEN": TOKEN,
                                             "TMPDIR": self._folder.name})
        self.said, self.output, self.ports = [], [], {}
        for stream, lines in ((self.process.stderr, self.said), (self.process.stdout, self.output)):
            threading.Thread(target=self._read, args=(stream, lines), daemon=True).start()
        self._wait_for(doors)

    @staticmethod
    def _read(stream, lines):
        for line in stream:
            lines.append(line.decode("utf-8", "replace"))

    def _wait_for(self, doors):
        """`doors`: name to the pattern of the line that tells its port."""
        end = time.monotonic() + LIMIT
        while len(self.ports) < len(doors):
            for line in list(self.said):
                for name, pattern in doors.items():
                    if found := re.search(pattern, line):
                        self.ports[name] = (int(found[1]), *found.groups()[1:])
            if time.monotonic() > end or self.process.poll() is not None:
                raise RuntimeError("the run does not begin: " + "".join(self.said))
            time.sleep(0.02)
        time.sleep(0.3)
        self._watch.seen()
        if self._trace:
            self._trace.begin()

    def alive(self):
        return self.process.poll() is None

    def end(self):
        """The exit code after Ctrl-C, or of who has ended already."""
        if self.alive():
            pid = self.process.pid
            if self._trace:  # strace would end, and leave the run alone
                children = Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="utf-8").split()
                pid = int(children[0]) if children else pid
            os.kill(pid, signal.SIGINT)
        return self.process.wait(timeout=LIMIT)

    def touched(self):
        """What should not have been, in words."""
        found = [f"touched: {name}" for name in self._watch.seen()]
        after = self._world.state()
        for file in sorted({*self.before, *after}):
            if self.before.get(file) != after.get(file):
                found.append(f"changed: {file}")
        if self._trace:
            found += self._traced()
        return sorted(set(found))

    def _traced(self):
        own = (str(self._world.run), *self._data)
        for call, paths, writes, done in self._trace.calls():
            if call.startswith("execve"):
                yield f"started: {paths[:1]}"
            for path in paths:
                path = os.path.join(self._world.run, path)  # noqa: PLW2901
                real, normal = os.path.realpath(path), os.path.normpath(path)
                if str(self._world.outside) in (real, normal) or any(
                        p.startswith(f"{self._world.outside}/") for p in (real, normal)):
                    yield f"{call}: {path}"
                if not done or SYSTEM.match(normal) or real.startswith(self._folder.name):
                    continue
                inside = any(p == folder or p.startswith(f"{folder}/") for p in (normal,) for folder in own)
                if not inside or writes:
                    yield f"{call}: {path}{' (writes)' if writes else ''}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.alive():
            self.end()
        self._watch.close()
        self._folder.cleanup()


def data_folders(program):
    """Where the program has its own files: beside it when it is installed, in the source tree otherwise."""
    here = Path(__file__).resolve().parent.parent.parent
    installed = Path(program).resolve().parent.parent / "share/murosimf"
    return [str(root / kind) for root in (here, installed)
            for kind in ("buses", "examples", "lenses", "models", "motions", "parts", "scenes", "servos")]
