#!/usr/bin/env python3
"""A client that flushes its output before every packet, as pypot and others do, loses none of them on a simulated serial line.

Usage: flushed_writes.py <murosimf>
Exit: 0 all is as on a real port, 1 something is lost, 77 there are no pseudo terminals (test is skipped).

A real port at 1 Mbit/s has sent a packet of N bytes after N * 10 us, and what is flushed then is nothing. Here the kernel is
given PAUSE besides, which a busy machine needs. Both protocols, in real time and as fast as possible; a round in which
something is lost is tried again. How much is lost of what is flushed at once depends on the machine and is printed only.
"""
import os
import select
import subprocess
import sys
import tempfile
import termios
import time
import tty
from pathlib import Path

PACKETS = 100
PAUSE = 3e-3  # [s]


def crc16(data):
    crc = 0
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1 ^ (0x8005 if crc & 0x8000 else 0)) & 0xFFFF
    return crc


def packet(protocol, number, instruction, parameters):
    if protocol == 1:
        body = bytes([number, len(parameters) + 2, instruction, *parameters])
        return b"\xff\xff" + body + bytes([~sum(body) & 0xFF])
    body = b"\xff\xff\xfd\0" + bytes([number]) + (len(parameters) + 3).to_bytes(2, "little") + bytes([instruction, *parameters])
    return body + crc16(body).to_bytes(2, "little")


class Client:
    def __init__(self, link, pause):
        self.file = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(self.file, termios.TCSANOW)
        self.pause = pause

    def send(self, data):
        termios.tcflush(self.file, termios.TCOFLUSH)
        os.write(self.file, data)
        if self.pause:
            time.sleep(10e-6 * len(data) + PAUSE)
        termios.tcflush(self.file, termios.TCOFLUSH)

    def answer(self, size):
        data, end = b"", time.monotonic() + 0.5
        while len(data) < size and time.monotonic() < end:
            if select.select([self.file], [], [], 0.1)[0]:
                data += os.read(self.file, 256)
        return data


def lost_of(link, protocol, pause):
    """Sync writes whose goal a read behind them does not show."""
    client, lost = Client(link, pause), 0
    for i in range(PACKETS):
        goal = 1900 + i
        if protocol == 1:
            client.send(packet(1, 254, 0x83, [30, 2, 1, goal & 0xFF, goal >> 8]))
            client.send(packet(1, 1, 0x02, [30, 2]))
            data = client.answer(8)[5:7]
        else:
            client.send(packet(2, 254, 0x83, [116, 0, 4, 0, 1, goal & 0xFF, goal >> 8, 0, 0]))
            client.send(packet(2, 1, 0x02, [116, 0, 4, 0]))
            data = client.answer(15)[9:11]
        lost += int.from_bytes(data, "little") != goal
    os.close(client.file)
    return lost


def play(program, folder, protocol, speed, pause):
    link = Path(folder) / "walker"
    command = [program, "run", "walk", "--duration", "100000", "--serial", folder, "--no-cameras", "--set",
               "walker.controller=serial", "--set", f"walker.options.protocol={protocol}", *speed]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        while not link.exists():
            if process.poll() is not None:
                sys.exit(f"the simulation has ended with {process.returncode}")
            time.sleep(0.01)
        return lost_of(link, protocol, pause)
    finally:
        process.terminate()
        process.wait()


def main():
    if not os.path.exists("/dev/ptmx"):
        print("skipped: there are no pseudo terminals here")
        return 77
    failed = False
    for protocol in (1, 2):
        for speed in (["--speed", "1"], []):
            name = f"protocol {protocol}, {'real time' if speed else 'as fast as possible'}"
            for _ in range(5):
                with tempfile.TemporaryDirectory() as folder:
                    lost = play(sys.argv[1], folder, protocol, speed, True)
                if lost == 0:
                    break
            print(f"{name}: {lost} of {PACKETS} lost")
            failed = failed or lost > 0
    with tempfile.TemporaryDirectory() as folder:
        lost = play(sys.argv[1], folder, 1, ["--speed", "1"], False)
    print(f"flushed at once, before a real port has sent them: {lost} of {PACKETS} lost")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
