#!/usr/bin/env python3
"""Writes the game logs of this folder: packets of a GameController of the Humanoid League, put together by struct alone.

    tests/data/league/write_game_logs.py [folder]

game.gamelog: twelve seconds of a game, two packets per second, teams 21 and 4;
player 2 of team 4 has a penalty from 5.2 s to 10.2 s.
fields.gamelog: one packet, in which every field has another value.
soccer.gamelog: the same of the Humanoid Soccer League's GameController, versions 18, 19 and 20, and a game of
version 20: ready, set, playing, stopped, playing. The test league.logs compares all with what this prints.
"""
import pathlib
import struct
import sys

PLAYERS = 11


def robot(penalty=0, seconds=0, warnings=0, yellow=0, red=0, goalkeeper=0):
    return struct.pack("<6B", penalty, seconds, warnings, yellow, red, goalkeeper)


def team(number, colour, score, robots=(), penalty_shot=0, single_shots=0, coach_sequence=0, coach_message=b""):
    """`robots`: of players 1, 2, ...; the coach comes first in the packet."""
    players = list(robots) + [robot()] * (PLAYERS - len(robots))
    head = struct.pack("<4BHB253s", number, colour, score, penalty_shot, single_shots, coach_sequence, coach_message)
    return head + robot() + b"".join(players)


def packet(count, state, teams, first_half=1, kick_off=0, secondary=0, info=bytes(4), drop_in=(0, 0), seconds=600,
           secondary_seconds=0, version=12, game_type=0):
    head = struct.pack("<4sH7B4sB3H", b"RGme", version, count % 256, 4, game_type, state, first_half, kick_off,
                       secondary, info, drop_in[0], drop_in[1], seconds, secondary_seconds)
    return head + teams[0] + teams[1]


def game():
    for i in range(24):
        t = 0.2 + 0.5 * i
        state = 0 if t < 1 else 1 if t < 2 else 2 if t < 3 else 3
        penalty = robot(34, int(35.2 - t), warnings=1) if 5 < t < 10 else robot()
        own = team(4, 0, 0, [robot(goalkeeper=1), penalty])
        other = team(21, 1, 1 if t > 8 else 0)
        yield round(t * 1e9), packet(i, state, (other, own), kick_off=4, seconds=600 - max(0, int(t - 3)))


def fields():
    robots = [robot(30 + i, 40 + i, 50 + i, 60 + i, 70 + i, i % 2) for i in range(PLAYERS)]
    teams = (team(9, 1, 3, robots, 5, 0x0607, 8, b"coach"), team(200, 0, 17, robots[::-1], 6, 0x0708, 9, b"hcaoc"))
    yield 0, packet(77, 2, teams, first_half=0, kick_off=200, secondary=6, info=bytes([9, 1, 7, 8]),
                    drop_in=(9, 0x0A0B), seconds=0x0123, secondary_seconds=0x0456)


def soccer_robot(version, penalty=0, seconds=0, warnings=0, cautions=0):
    return {18: struct.pack("<2B", penalty, seconds), 19: struct.pack("<4B", penalty, seconds, warnings, cautions),
            20: struct.pack("<3B", penalty, seconds, cautions)}[version]


def soccer_team(version, number, score, robots=(), goalkeeper=1, budget=12000):
    """Field and keeper's colours are 0 and 1; no penalty shots."""
    players = list(robots) + [soccer_robot(version)] * (20 - len(robots))
    return struct.pack("<6B2H", number, 0, 1, goalkeeper, score, 0, 0, budget) + b"".join(players)


def soccer_packet(version, count, state, teams, stopped=0, phase=0, set_play=0, first_half=1, kicking=255, seconds=600,
                  secondary=0):
    head = struct.pack("<4s10B2h", b"RGme", version, count % 256, 4, 0, stopped, phase, state, set_play, first_half,
                       kicking, seconds, secondary)
    return head + teams[0] + teams[1]


def soccer():
    for version in (18, 19, 20):
        robots = [soccer_robot(version, 1 + i % 11, 20 + i, 40 + i, 60 + i) for i in range(20)]
        teams = (soccer_team(version, 9, 3, robots, 2, 0x0A0B), soccer_team(version, 200, 17, robots[::-1], 0, 0x0C0D))
        yield version, soccer_packet(version, 77, 2, teams, 1, 2, 6, 0, 200, -0x0123, 0x0456)
    for i, (state, stopped) in enumerate([(1, 0), (2, 0), (3, 0), (3, 0), (3, 1), (3, 1), (3, 0), (3, 0)]):
        penalty = [soccer_robot(20), soccer_robot(20, 6, 30)] if i >= 6 else []
        teams = (soccer_team(20, 4, 0, penalty), soccer_team(20, 21, 0))
        yield round((0.2 + 0.5 * i) * 1e9), soccer_packet(20, i, state, teams, stopped, kicking=4)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for name, packets in (("game", game()), ("fields", fields()), ("soccer", soccer())):
        lines = [f"{time} game {data.hex()}" for time, data in packets]
        (folder / f"{name}.gamelog").write_text("\n".join(["MuRoSimF game log 1", *lines]) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
