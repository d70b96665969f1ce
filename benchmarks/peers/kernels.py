"""Rigid-body algorithms on kid21: ours alone and in eight lanes, Pinocchio for any processor and for this one."""
import statistics

from contest import Entrant, in_turns, print_table
from running import run
from steps import describe

import scenes

KERNELS = ["kinematics", "inverse dynamics", "mass matrix", "forward dynamics"]
RESULTS = ["accelerations", "torques"]
TOLERANCE = 1e-9  # of the largest number: other orders of adding up


class Library(Entrant):
    """Its time is that of forward dynamics; the others stand beside."""

    def __init__(self, name, setting, command):
        super().__init__(name, setting, lambda _observe: command, ours=name == "MuRoSimF")
        self.results, self.each = {}, {}

    def keep(self, result):
        self.results = {key: result[key] for key in RESULTS}
        for kernel in KERNELS:
            if kernel in result:
                self.each.setdefault(kernel, []).append(result[kernel])
        return result["forward dynamics"]

    def medians(self):
        return {kernel: statistics.median(times) for kernel, times in self.each.items()}

    def agrees(self, other):
        return all(agree(self.results[key], other.results[key]) for key in RESULTS)


def agree(a, b):
    return len(a) == len(b) and max(abs(x - y) for x, y in zip(a, b, strict=True)) <= TOLERANCE * max(map(abs, b))


def libraries(machine, options, folder):
    seconds = 0.01 if options.quick else 0.2

    def library(name, setting, program, what):
        return Library(name, setting, [program, folder, "--setting", what, "--seconds", seconds])

    program, native = machine.program("murosimf_peer_kernels"), machine.program("murosimf_peer_kernels_native")
    if not program:
        machine.miss(f"kernels: {machine.build}/murosimf_peer_kernels (target murosimf_peers)")
        return []
    found = [library("MuRoSimF", "one robot", program, "MuRoSimF"), library("MuRoSimF", "eight in lanes, each", program, "lanes")]
    if not native:
        machine.miss("Pinocchio: its headers (race.py --install, configure again, target murosimf_peers)")
        return found
    return [*found, library("Pinocchio", "for any x86-64", program, "Pinocchio"),
            library("Pinocchio", "for this processor", native, "Pinocchio")]


def cells(library, reference):
    each = library.medians()
    return [library.label, *(f"{each[kernel]:.2f}" if kernel in each else "" for kernel in KERNELS),
            "yes" if library.agrees(reference) else "NO"]


def part(machine, options):
    with scenes.written("walk", 1) as folder:
        describe(machine, folder, 0.01)
        finished = in_turns(libraries(machine, options, folder), run, None, options.rounds)
    if not finished:
        return []
    reference = finished[0]
    print_table("algorithms on kid21 (27 degrees of freedom), from joint positions on, us a call",
                ["library", *KERNELS, "same results"], [cells(library, reference) for library in finished])
    return [library.row(reference, "forward dynamics", "us", kernels=library.medians(), same=library.agrees(reference))
            for library in finished]
