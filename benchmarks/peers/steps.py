"""Scenes that every engine steps: walks, squats, heaps, a slope."""
import pathlib
import tempfile

import scenes
from contest import Entrant, differences, in_turns, ratios
from running import HERE, ROOT, Failure, fail, run

LEVELS = ["articulated_dynamics", "full_dynamics", "simplified_dynamics", "kinematic_walking"]
OTHERS = {  # program: its settings, the Debian package that it needs
    "ode": (["quickstep 20", "quickstep 50", "worldstep"], "libode-dev"),
    "bullet": (["10 iterations", "50 iterations"], "libbullet-dev"),
    "dart": (["usual"], "libdart-dev"),
}
MUJOCO = ["Euler", "implicitfast", "discrete"]
# [s] before the time counts, and the time that counts at least
KINDS = {"walk": (1, 3), "squat": (1, 3), "heap": (3, 2), "slope": (2, 8)}


def entrants(machine, options, folder, kind, robots):
    warm, seconds = KINDS[kind]
    if options.quick:
        warm, seconds = 0.2, 0.3
    seconds *= options.length * (max(1, 3 / robots) if kind in ("walk", "squat") and not options.quick else 1)
    ends = ["--warm", warm, "--seconds", seconds]

    def command(start, setting):
        return lambda observe: [*start, folder, "--setting", setting, *ends, *(["--observe"] if observe else [])]

    levels = LEVELS if kind in ("walk", "squat") else LEVELS[:1] if kind == "slope" else LEVELS[:3]
    if kind == "squat":
        levels = LEVELS[:3]
    own = machine.own("murosimf_peer_murosimf")
    found = [Entrant("MuRoSimF", level, command([own], level), ours=True) for level in levels]
    if machine.python:
        script = [machine.python, HERE / "mujoco_peer.py"]
        found += [Entrant("MuJoCo", setting, command(script, setting)) for setting in MUJOCO]
    else:
        machine.miss("MuJoCo: no Python that has it (pip install mujoco, or race.py --install; then --python)")
    for name, (settings, package) in OTHERS.items():
        program = machine.program(f"murosimf_peer_{name}")
        if program:
            chosen = settings if robots <= 10 else settings[:1]
            found += [Entrant(name, setting, command([program], setting)) for setting in chosen]
        else:
            machine.miss(f"{name}: {machine.build}/murosimf_peer_{name} (Debian and Ubuntu: {package}; target murosimf_peers)")
    wanted = [entrant for entrant in found if entrant is found[0] or not options.engines
              or any(word.lower() in entrant.name.lower() for word in options.engines)]
    return wanted, warm + seconds


def show(kind, robots, finished):
    reference = finished[0]
    print(f"\n{kind} of {robots}, us of processor time per step of 1 ms; `times`: as long as {reference.label}, same round")
    print("| engine | us | times | real time | height m | distance m | tracking rad | contacts | depth mm | gap mm | mm/s | lie "
          "| same work |\n|" + "---|" * 13)
    for entrant in finished:
        row = entrant.to_json()
        middle, least, most = ratios(entrant, reference)
        seen = entrant.observed
        differing = ", ".join(differences(kind, entrant, reference))
        print(f"| {entrant.label} | {row['median']:.1f} | {middle:.2f} ({least:.2f} to {most:.2f}) | {1e3 / row['median']:.2f} "
              f"| {seen['height_m']:.3f} | {seen['distance_m']:.3f} | {seen['tracking_rad']:.4f} | {seen['contacts']:.1f} "
              f"| {seen['depth_mm']:.2f} | {seen['gap_mm']:.3f} | {seen['late_speed_mm_s']:.2g} | {seen['lying']} "
              f"| {'no: ' + differing if differing else 'yes'} |", flush=True)


def race(machine, options, kind, robots):
    """One scene; rows for the JSON document."""
    with tempfile.TemporaryDirectory(prefix="murosimf_race_") as name:
        folder = pathlib.Path(name)
        if kind == "heap":
            scenes.write_heap(folder, robots, ROOT)
        else:
            getattr(scenes, f"write_{kind}")(folder, robots)
        racers, duration = entrants(machine, options, folder, kind, robots)
        try:
            describe(machine, folder, duration)
        except Failure as failure:
            fail(failure)
        finished = in_turns(racers, run, "us_per_step", options.rounds)
        if not finished or finished[0] is not racers[0]:
            fail(f"{kind} of {robots}: our own program did not finish")
        show(kind, robots, finished)
        return [entrant.to_json() | {"scene": kind, "robots": robots, "unit": "us", "ours": entrant.ours,
                                     "times_as_long": ratios(entrant, finished[0])[0],
                                     "differences": differences(kind, entrant, finished[0])} for entrant in finished]


def describe(machine, folder, duration):
    run([machine.own("murosimf_peer_describe"), folder, duration])


def part(kind, counts):
    """What race.py calls; --quick has one scene of each."""
    def run_part(machine, options):
        return [row for robots in (options.robots if options.robots and len(counts) > 1 else counts[:1] if options.quick else counts) for row in race(machine, options, kind, robots)]
    return run_part
