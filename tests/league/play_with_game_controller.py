#!/usr/bin/env python3
"""Plays the GameController for the program from outside: sends packets by UDP while it runs, and reads its answers.

    tests/league/play_with_game_controller.py --program build/release/murosimf

Prints what was wrong and exits with 1 if the robots did not answer, the report does not tell what was sent, or the run cannot be
repeated from its record.
"""
import argparse
import json
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "data/league"))
import write_game_logs as wire  # noqa: E402


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def packets():
    """Blue 1 is penalized in the second half of them, and blue leads then."""
    for i in range(40):
        late = i >= 20
        blue = wire.team(1, 0, 3 if late else 0, [wire.robot(30, 20) if late else wire.robot()])
        yield wire.packet(i, 3, (blue, wire.team(2, 1, 0)), kick_off=255)


def play(program, scene, record):
    """The report, and the answers as a set of (team, player, message)."""
    port, answers = free_port(), set()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as back:
        back.bind(("127.0.0.1", 0))
        back.settimeout(0.001)
        command = [program, "run", scene, "--speed", "1", "--duration", "5", "--json", "-", "--no-cameras", "--game-controller",
                   str(port), "--set", f"league.answer_port={back.getsockname()[1]}", "--game-log", record]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as run:
            for packet in packets():
                out.sendto(packet, ("127.0.0.1", port))
                time.sleep(0.1)
                try:
                    while True:
                        data = back.recv(100)
                        if len(data) == 8 and data[:5] == b"RGrt\x02":
                            answers.add(tuple(data[5:]))
                except TimeoutError:
                    pass
            report = json.loads(run.communicate(timeout=60)[0])
        return report, answers


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--program", required=True)
    options.add_argument("--scene", default="three_on_three")
    given = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        record = str(pathlib.Path(folder) / "mine.gamelog")
        report, answers = play(given.program, given.scene, record)
        again = json.loads(subprocess.run(
            [given.program, "run", given.scene, "--duration", "5", "--json", "-", "--no-cameras", "--threads", "2",
             "--game-repeat", record], stdout=subprocess.PIPE, check=True, text=True).stdout)
    errors = []
    if answers != {(team, player, 2) for team in (1, 2) for player in (1, 2, 3)}:
        errors.append(f"answers: {sorted(answers)}")
    events = [event["text"] for event in report["events"] if event["text"].startswith("game")]
    expected = ["game: the referee is there", "game: playing", "game: blue 3, red 0",
                "game: blue1: penalty, ball manipulation"]
    if events != expected:
        errors.append(f"events: {events}")
    if again["state_hash"] != report["state_hash"]:
        errors.append(f"repeated: {again['state_hash']} is not {report['state_hash']}")
    print("\n".join(errors) or "the robots have answered, and the run can be repeated")
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
