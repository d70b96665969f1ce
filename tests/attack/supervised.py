"""Attacks on --supervise: by those who do not know the token, and by those who do."""
import contextlib
import socket
import struct
import time

import tries
from canaries import SECRET
from doors import TOKEN, Attacker, Run
from murosimf_client import RequestRefused, SimulatorError, Supervisor, supervision
from murosimf_client.connection import Connection

DOOR = "supervise"
PORT = {"supervise": r"supervision on 127\.0\.0\.1:(\d+)"}


class Attack(Attacker):
    def run(self):
        words = ["first.toml", "--supervise", "0", "--paused"]
        with Run(self.program, self.world, words, PORT, self.traced) as run:
            self.port = run.ports["supervise"][0]
            self._strangers()
            with Supervisor(self.port, TOKEN) as supervisor:
                supervisor.advance(0.2)
                self.before = self._look(supervisor)
                self._scenes(supervisor)
                self._changes(supervisor)
                self._other_requests(supervisor)
                self._states(supervisor)
                self._allowed(supervisor)
                supervisor.finish()
            code = run.process.wait(timeout=120)
            if code != 0:
                self.book.wrong(DOOR, "the run", "", f"ends with {code}: {''.join(run.said)[-500:]}")
            for what in run.touched():
                self.book.wrong(DOOR, "files", "", what)

    @staticmethod
    def _look(supervisor):
        status = supervisor.status()
        return status.time, status.branch, supervisor.read("robot.torso.*").values, supervisor.entities()

    def _refused(self, supervisor, kind, tried, ask):
        """What is told; an error if it was done, changes the run, or tells what stands in files."""
        try:
            ask()
        except RequestRefused as refusal:
            text = str(refusal)
            wrong = "quotes a file" if SECRET in text else "has more than one line" if "\n" in text else ""
            if self._look(supervisor) != self.before:
                wrong = "the run is another one"
            if wrong:
                self.book.wrong(DOOR, kind, tried, f"{wrong}: {text}")
            else:
                self.book.add(DOOR, kind, tried, "refused: " + text)
            return text
        self.book.wrong(DOOR, kind, tried, "was done")
        return ""

    def _scenes(self, supervisor):
        for what, name, other in tries.names_of_files(self.world):
            told = self._refused(supervisor, "name of a scene", name, lambda name=name: supervisor.load_scene(name))
            if other is None:
                continue
            same = self._refused(supervisor, "name of no scene", other, lambda other=other: supervisor.load_scene(other))
            if told.replace(name, other) != same:
                self.book.wrong(DOOR, "name of a scene", name, f"tells whether the file is there ({what}): {told} / {same}")
        for name in ("own_secret.toml", "own_broken.toml"):
            self._refused(supervisor, "file that is no scene", name, lambda name=name: supervisor.load_scene(name))
            self._refused(supervisor, "file that is no scene", name,
                          lambda name=name: supervisor.load_scene(name, ["robit.level=kinematic_walking"]))
        for name in self.world.scenes_that_name():
            self._refused(supervisor, "scene that names others", name, lambda name=name: supervisor.load_scene(name))
        for setting in tries.settings(self.world):
            self._refused(supervisor, "override", setting,
                          lambda setting=setting: supervisor.load_scene("first.toml", [setting]))
        self._refused(supervisor, "override", "controller, library", lambda: supervisor.load_scene(
            "nudge", ["robot.controller=library", f"robot.library={self.world.outside}/code.so"]))

    def _changes(self, supervisor):
        for change in tries.changes(self.world):
            self._refused(supervisor, "change", change, lambda change=change: supervisor.change(change))

    def _other_requests(self, supervisor):
        for pattern in ("/etc/passwd", "../*", "*." * 5000, "[" * 3000, "", "\0", "robot.\n"):
            try:
                supervisor.read(pattern)
                self.book.add(DOOR, "pattern of numbers", pattern, "nothing found")
            except RequestRefused as refusal:
                self.book.add(DOOR, "pattern of numbers", pattern, f"refused: {refusal}")
        self._refused(supervisor, "recording", "on", lambda: supervisor.record(True))
        for seconds in (-1.0, 9e9):
            self._refused(supervisor, "time", seconds, lambda seconds=seconds: supervisor.seek(seconds))

    def _states(self, supervisor):
        state = supervisor.save()
        for content in (b"", b"\0" * 100, b"\x89MCAP0\r\n", str(self.world.outside / "secret.toml").encode()):
            self._refused(supervisor, "state", content, lambda content=content: supervisor.load(content))
        for content in tries.mutated(state, 7, 4 * self.rounds):
            try:
                supervisor.load(content)
                self.book.add(DOOR, "damaged state", len(content), "taken")
            except RequestRefused as refusal:
                self.book.add(DOOR, "damaged state", len(content), f"refused: {refusal}")
        supervisor.load(state)

    def _allowed(self, supervisor):
        """What supervisors may is still done."""
        for name, settings in (("nudge", ["robot.level=simplified_dynamics"]), ("first.toml", ["robot.command=[0, 0, 0]"]),
                               (str(self.world.run / "first.toml"), ["robot.model=kid21", "robot.torso.mass=3"])):
            supervisor.load_scene(name, settings, seed=2)
            supervisor.advance(0.05)
            self.book.add(DOOR, "what is allowed", name, "done")

    def _strangers(self):
        for token in ("", "x", TOKEN[:-1], TOKEN + "x", TOKEN.upper(), TOKEN + "\0", "\0" + TOKEN, "a" * 60000):
            try:
                Supervisor(self.port, token, patience=5).close()
                self.book.wrong(DOOR, "wrong token", token, "was let in")
            except SimulatorError as refusal:
                self.book.add(DOOR, "wrong token", token, f"refused: {refusal}")
        for request in (supervision.plain(supervision.FINISH), supervision.change(["robot.level=full_dynamics"]),
                        supervision.load_scene("nudge", [], None, True)):
            connection = Connection("127.0.0.1", self.port, 5, 1 << 20)
            connection.send(request)
            self._dropped("request before the token", request, connection.receive)
            connection.close()
        for data in tries.garbage(3, 8 * self.rounds):
            with socket.create_connection(("127.0.0.1", self.port)) as one:
                one.settimeout(10)
                one.sendall(data)
                one.shutdown(socket.SHUT_WR)
                self._dropped("garbage", data[:40], lambda one=one: one.recv(100))
        silent = [socket.create_connection(("127.0.0.1", self.port)) for _ in range(150)]
        for one in silent[:75]:
            one.sendall(struct.pack(">I", 60000) + b"x")
        begin = time.monotonic()
        with Supervisor(self.port, TOKEN, patience=20) as supervisor:
            supervisor.status()
        self.book.add(DOOR, "half-open connections", len(silent), f"served beside them after {time.monotonic() - begin:.1f} s")
        for one in silent:
            one.close()

    def _dropped(self, kind, tried, receive):
        try:
            answer = receive()
            self.book.add(DOOR, kind, tried, "refused" if answer else "closed")
        except (OSError, SimulatorError) as error:
            with contextlib.suppress(ValueError):
                self.book.add(DOOR, kind, tried, "no answer" if isinstance(error, TimeoutError) else "closed")
