"""What certifies the results of ten scenes, against reading, solving and reporting them: each scene in its turn."""

import json
import os
from statistics import median
from time import process_time
from typing import Any

from vibcli.bench.files import PROBLEMS
from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing

SCENES = ("2_lagrange/bead_on_swinging_rod.yaml", "3_free_undamped/metronome_rider.yaml",
          "4_free_damped/gate_struck_by_a_hammer.yaml", "4_free_damped/plate_swings_in_water.yaml",
          "5_forced/pendulum_under_a_square_wave.yaml", "6_two_degrees/quarter_car_damped.yaml",
          "7_forced_two_degrees/two_machines_on_a_floor_with_an_absorber.yaml",
          "7_more_degrees/geared_drive_line_driven.yaml", "7_more_degrees/shaft_under_a_torque_pulse.yaml",
          "7_more_degrees/three_storeys_on_shaking_ground.yaml")
SHARE = 0.05


def rows(runs: Any) -> list[Timing]:
    """Milliseconds of all certificates, and those of the scene in which they are dearest."""
    found = json.loads(answer("from vibcli.bench.certificates import main; main()", runs))
    dearest = max(found, key=lambda name: found[name][0] / found[name][1])
    ours, solved = (sum(one[i] for one in found.values()) for i in (0, 1))
    every = f"certificates of {len(found)} scenes"
    return [Timing(every, ours, "ms", SHARE, "reading, solving, reporting them", solved),
            Timing(f"  the dearest: {os.path.basename(dearest)}", found[dearest][0], "ms", None, "", found[dearest][1])]


def main() -> None:
    """Child process: print {scene: [ms of its certificate, of its solution]}."""
    import sys

    runs = [{name: _measured(name) for name in SCENES} for _ in range(int(sys.argv[1]) + 1)][1:]
    print(json.dumps({name: [1e3 * median(run[name][i] for run in runs) for i in (0, 1)] for name in SCENES}))


def _measured(name: str) -> tuple[float, float]:
    """Seconds of (the certificate, the solution) of a scene that is read anew."""
    from vibcli.api.reports import report, solution
    from vibcli.api.source import certified, file_source, problem_of

    start = process_time()
    problem = problem_of(file_source(os.path.join(PROBLEMS, name)))
    report(problem, solution(problem))
    solved = process_time()
    certified(problem)
    return process_time() - solved, solved - start
