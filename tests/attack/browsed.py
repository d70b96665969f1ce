"""Attacks on --web: pages from elsewhere, names that lead here, orders that name files, garbage."""
import http.client
import json
import os
import socket
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "web"))
import tries  # noqa: E402
from canaries import SECRET  # noqa: E402
from client import Client, Refused  # noqa: E402
from doors import Attacker, Run  # noqa: E402

DOOR = "web"
PORT = {"web": r"ws://127\.0\.0\.1:(\d+)/\?token=(\w+)"}
CLOSED = (ConnectionError, Refused, TimeoutError, OSError)


class Attack(Attacker):
    def run(self):
        words = ["first.toml", "--web", "0", "--paused", "--supervise", "0"]
        with Run(self.program, self.world, words, PORT, self.traced) as run:
            self.port, self.token = run.ports["web"]
            self._requests()
            self._entry()
            self._orders()
            self._foxglove()
            self._garbage()
            self._half_open(run)
            client = Client(self.port)
            if not client.state(lambda state: True)["paused"]:
                self.book.wrong(DOOR, "the run", "", "goes on")
            client.close()
            code = run.end()
            if code not in (0, 130):
                self.book.wrong(DOOR, "the run", "", f"ends with {code}: {''.join(run.said)[-500:]}")
            for what in run.touched():
                self.book.wrong(DOOR, "files", "", what)

    def _get(self, path, method="GET"):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20 if method == "GET" else 2)
        try:
            connection.putrequest(method, path, skip_accept_encoding=True)
            connection.endheaders()
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read()
        finally:
            connection.close()

    def _requests(self):
        out = self.world.outside
        for path in (f"/{out}/secret.toml", f"/../../../../..{out}/secret.toml", "/..%2f..%2f..%2fetc/passwd",
                     "/%2e%2e/%2e%2e/etc/passwd", f"/%00{out}/secret.toml", "//etc/passwd", "/.git/config", "/first.toml",
                     "/?file=/etc/passwd", "/x" * 1000,
                     "/?" + "a=b&" * 500, "/%", "/%zz"):
            try:
                status, _, body = self._get(path)
            except (*CLOSED, http.client.HTTPException, ValueError):
                self.book.add(DOOR, "path", path, "closed")
                continue
            page = path.split("?", maxsplit=1)[0] == "/"
            if SECRET.encode() in body or (status == 200) != page or b"root:" in body:
                self.book.wrong(DOOR, "path", path, f"{status}, {body[:80]!r}")
            else:
                self.book.add(DOOR, "path", path, "the page" if page else f"refused: {status}")
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PROPFIND", "X" * 500):
            try:
                status = self._get("/", method)[0]
            except (*CLOSED, http.client.HTTPException):
                status = 0
            if status == 200:
                self.book.wrong(DOOR, "method", method, "200")
            else:
                self.book.add(DOOR, "method", method, "refused" if status else "closed")
        headers = {name.lower(): value for name, value in self._get("/")[1].items()}
        for name, value in (("content-security-policy", "frame-ancestors 'none'"), ("x-frame-options", "DENY"),
                            ("x-content-type-options", "nosniff")):
            if value in headers.get(name, ""):
                self.book.add(DOOR, "headers of the page", name, "there")
            else:
                self.book.wrong(DOOR, "headers of the page", name, f"is {headers.get(name)!r}")

    def _entry(self):
        own = f"127.0.0.1:{self.port}"
        for host, origin in ((own, "https://evil.example"), (own, "null"), (own, f"http://{own}.evil.example"),
                             (own, "http://127.0.0.1"), (own, "http://localhost:3000"), (own, f"http://localhost:{self.port}"),
                             (own, "chrome-extension://abc"),
                             (f"evil.example:{self.port}", f"http://evil.example:{self.port}"), ("evil.example", ""), ("", ""),
                             (f"127.0.0.1.evil.example:{self.port}", ""), ("0.0.0.0", ""), (f"localhost.:{self.port}", "")):
            headers = [f"Origin: {origin}"] if origin else []
            for path in ("/", "/?token=", f"/?token={self.token[:-1]}", f"/?token={self.token}x", f"/?Token={self.token}",
                         "/?token=%00"):
                for protocol in ("murosimf.v1", "foxglove.sdk.v1"):
                    self._enter(host, path, protocol, headers, origin)
        for protocol in ("", "nosuch", "http"):
            try:
                client = Client(self.port, protocol=protocol)
                client.receive()
                client.close()
                self.book.wrong(DOOR, "protocol", protocol, "was let in")
            except CLOSED:
                self.book.add(DOOR, "protocol", protocol, "refused")

    def _enter(self, host, path, protocol, headers, origin):
        tried = f"Host {host}, Origin {origin}, {path}"
        try:
            connection = socket.create_connection(("127.0.0.1", self.port), timeout=20)
            with connection:
                lines = [f"GET {path} HTTP/1.1", f"Host: {host}", "Upgrade: websocket", "Connection: Upgrade",
                         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==", "Sec-WebSocket-Version: 13",
                         f"Sec-WebSocket-Protocol: {protocol}", *headers]
                connection.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
                answer = connection.recv(100)
        except CLOSED:
            answer = b""
        if b" 101 " in answer or b" 200 " in answer:
            self.book.wrong(DOOR, "pages from elsewhere", tried, "was let in")
        else:
            self.book.add(DOOR, "pages from elsewhere", tried, "refused" if answer else "closed")

    def _orders(self):
        client, number = Client(self.port), 0
        client.state()
        for change in tries.changes(self.world):
            number += 1
            client.order(do="change", id=number, text=change)
            self._expect_error(client.answer(number), "change", change)
        out = str(self.world.outside / "secret.toml")
        for order in ({"do": "watch", "paths": [out, "../../x"]}, {"do": "names", "entity": out},
                      {"do": "camera", "camera": out}):
            number += 1
            client.order(id=number, **order)
            self._expect_error(client.answer(number), "order with a file", order)
        client.close()
        for order in ({"do": "load_scene", "scene": out}, {"do": "save", "file": out}, {"do": "record", "file": out}, {"do": out},
                      {"do": ["pause"]}, {}, [], {"do": "watch", "paths": [{}]}, {"do": "step", "steps": "x"}, {"do": None}):
            client = Client(self.port)
            client.send(json.dumps(order))
            try:
                client.wait_for(lambda m: isinstance(m, dict) and m.get("is") == "answer", seconds=10)
                self.book.wrong(DOOR, "order of none", order, "was answered")
            except CLOSED:
                self.book.add(DOOR, "order of none", order, "closed")
            client.close()

    def _expect_error(self, answer, kind, tried):
        error = answer.get("error")
        if not error:
            self.book.wrong(DOOR, kind, tried, f"was done: {answer}")
        elif SECRET in error:
            self.book.wrong(DOOR, kind, tried, f"quotes a file: {error}")
        else:
            self.book.add(DOOR, kind, tried, f"refused: {error}")

    def _foxglove(self):
        out = str(self.world.outside / "secret.toml")
        orders = [{"op": "fetchAsset", "uri": f"file://{out}", "requestId": 1},
                  {"op": "fetchAsset", "uri": f"package://x/../..{out}", "requestId": 2},
                  {"op": "getParameters", "parameterNames": [out, "/etc/passwd"], "id": "x"},
                  {"op": "advertise", "channels": [{"id": 1, "topic": out, "encoding": "json", "schemaName": ""}]},
                  {"op": "subscribeConnectionGraph"}, {"op": out}]
        orders += [{"op": "setParameters", "parameters": [{"name": change.partition("=")[0], "value": change.partition("=")[2]}]}
                   for change in tries.changes(self.world)]
        client = Client(self.port, protocol="foxglove.sdk.v1")
        for order in orders:
            client.send(json.dumps(order))
            time.sleep(0.002)
        client.send(json.dumps({"op": "getParameters", "parameterNames": [], "id": "last"}))
        said = []

        def last(message):
            said.append(message)
            return isinstance(message, dict) and message.get("id") == "last"
        client.wait_for(last)
        client.close()
        if any(SECRET in str(message) for message in said):
            self.book.wrong(DOOR, "Foxglove's requests", "", "quotes a file")
        for order in orders:
            self.book.add(DOOR, "Foxglove's requests", order, "refused or ignored")

    def _garbage(self):
        for data in (*tries.garbage(11, 8 * self.rounds), b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 3000,
                     b"GET " + b"/" * 100000, b"\0" * 70000):
            with socket.create_connection(("127.0.0.1", self.port), timeout=0.2) as one:
                try:
                    one.sendall(data)
                    one.recv(100)
                except OSError:
                    pass
            self.book.add(DOOR, "garbage", data[:40], "closed")
        for kind in range(4 * self.rounds):
            client = Client(self.port, protocol=("murosimf.v1", "foxglove.sdk.v1")[kind % 2])
            client.socket.settimeout(0.3)
            try:
                if kind % 4 < 2:
                    client.send(os.urandom(200), opcode=(1, 2, 9, 3)[kind // 2 % 4])
                    client.wait_for(lambda m: False, seconds=0.2)
                else:
                    client.socket.sendall(b"\x82\xff" + (1 << 62).to_bytes(8, "big") + os.urandom(4000))
                    client.wait_for(lambda m: False, seconds=0.2)
            except CLOSED:
                pass
            client.close()
            self.book.add(DOOR, "broken frames", kind, "closed or ignored")

    def _half_open(self, run):
        silent = []
        for _ in range(400):
            try:
                silent.append(socket.create_connection(("127.0.0.1", self.port), timeout=1))
                silent[-1].sendall(b"GET / HTT")
            except OSError:
                break
        files = len(os.listdir(f"/proc/{run.process.pid}/fd")) if not self.traced else 0
        for one in silent:
            one.close()
        begin = time.monotonic()
        while time.monotonic() < begin + 60:
            try:
                Client(self.port).close()
                break
            except CLOSED:
                time.sleep(0.1)
        if files > 500:
            self.book.wrong(DOOR, "half-open connections", len(silent), f"{files} files are open")
        else:
            self.book.add(DOOR, "half-open connections", len(silent), "served afterwards")
