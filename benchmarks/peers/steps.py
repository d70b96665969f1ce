"""Scenes that every engine steps: walks, squats, heaps, a slope."""
from contest import Entrant, in_turns, print_table, ratios, show_spread
from likeness import differences
from running import HERE, fail, run

import scenes

LEVELS = ["articulated_dynamics", "full_dynamics", "simplified_dynamics", "kinematic_walking"]
LEVELS_OF = {"walk": LEVELS, "squat": LEVELS[:3], "heap": LEVELS[:3], "slope": LEVELS[:1]}
MUJOCO = ["Euler", "implicitfast", "discrete"]
OTHERS = {  # program: its settings, the Debian package that it needs, and the most robots that do not take it minutes
    "ode": (["quickstep 20", "quickstep 50", "worldstep"], "libode-dev", 22),
    "bullet": (["10 iterations", "50 iterations"], "libbullet-dev", 22),
    "dart": (["usual"], "libdart-dev", 1),
}
SECONDS = {"walk": (1, 3), "squat": (1, 3), "heap": (3, 2), "slope": (2, 8)}  # before the time counts, and while it does
LONE = 3  # so much longer is a run of one robot
HEADS = ["engine", "us", "times", "real time", "height m", "distance m", "tracking rad", "contacts", "depth mm", "gap mm",
         "late mm/s", "lying", "same work"]


def durations(options, kind, robots):
    if options.quick:
        return 0.2, 0.3
    warm, seconds = SECONDS[kind]
    return warm, seconds * options.length * (LONE if robots == 1 and kind != "slope" else 1)


def others(machine, kind, robots, command):
    for name, (settings, package, most) in OTHERS.items():
        program = machine.program(f"murosimf_peer_{name}")
        if not program:
            machine.miss(f"{name}: {machine.build}/murosimf_peer_{name} (Debian and Ubuntu: {package}; target murosimf_peers)")
            continue
        # the slower settings show what accuracy costs; once is enough
        for setting in settings if robots == 1 else settings[:1] if robots <= most else []:
            yield Entrant(name, setting, command([program], setting))


def entrants(machine, options, folder, kind, robots, durations):
    ends = ["--warm", durations[0], "--seconds", durations[1]]

    def command(start, setting):
        return lambda observe: [*start, folder, "--setting", setting, *ends, *(["--observe"] if observe else [])]

    own = machine.own("murosimf_peer_murosimf")
    found = [Entrant("MuRoSimF", level, command([own], level), ours=True) for level in LEVELS_OF[kind]]
    if machine.python:
        found += [Entrant("MuJoCo", setting, command([machine.python, HERE / "mujoco_peer.py"], setting)) for setting in MUJOCO]
    else:
        machine.miss("MuJoCo: no Python that has it (race.py --install, or pip install mujoco and --python)")
    found += others(machine, kind, robots, command)
    return [entrant for entrant in found if entrant is found[0] or not options.engines
            or any(word.lower() in entrant.name.lower() for word in options.engines)]


def cells(kind, entrant, reference):
    seen = entrant.observed
    differing = differences(kind, seen, reference.observed)
    return [entrant.label, f"{entrant.median:.1f}", show_spread(ratios(entrant, reference)), f"{1e3 / entrant.median:.2f}",
            f"{seen['height_m']:.3f}", f"{seen['distance_m']:.3f}", f"{seen['tracking_rad']:.4f}", f"{seen['contacts']:.1f}",
            f"{seen['depth_mm']:.2f}", f"{seen['gap_mm']:.3f}", f"{seen['late_speed_mm_s']:.2g}", seen["lying"],
            "no: " + ", ".join(differing) if differing else "yes"]


def race(machine, options, kind, robots):
    """One scene; rows for the JSON document."""
    warm, seconds = durations(options, kind, robots)
    with scenes.written(kind, robots) as folder:
        describe(machine, folder, warm + seconds)
        racers = entrants(machine, options, folder, kind, robots, (warm, seconds))
        finished = in_turns(racers, run, "us_per_step", options.rounds)
    if not finished or finished[0] is not racers[0]:
        fail(f"{kind} of {robots}: our own program did not finish")
    reference = finished[0]
    title = f"{kind} of {robots}, us of processor time per step of 1 ms; `times`: as long as {reference.label}, same round"
    print_table(title, HEADS, [cells(kind, entrant, reference) for entrant in finished])
    return [entrant.row(reference, kind, "us", robots=robots, differences=differences(kind, entrant.observed, reference.observed))
            for entrant in finished]


def describe(machine, folder, duration):
    run([machine.own("murosimf_peer_describe"), folder, duration])


def part(kind, counts):
    """What race.py calls; --quick has one scene of each."""
    def run_part(machine, options):
        wanted = options.robots if options.robots and kind != "slope" else counts[:1] if options.quick else counts
        return [row for robots in wanted for row in race(machine, options, kind, robots)]
    return run_part
