"""Homework: variants of a problem with four keys, mistakes, bands and all gates, against as many scenes read anew; and
a set of three problems handed out to a course, with keys and worked solutions, against as many commands."""

import json
import os
import tempfile
from pathlib import Path
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.files import PROBLEMS
from vibcli.bench.processes import answer, costs, vibcli
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from vibcli.homework.variants import SolvedVariants

QUARTER_CAR = """title: Quarter of a car
question: A wheel {mu} on a tyre {kt} carries a body {ms} on a spring {ks} and a damper {c}.
parameters: {mu: 40 kg, ms: 300 kg, kt: 180 kN/m, ks: 20 kN/m, c: 1200 N*s/m}
bodies: {wheel: {mass: mu, slide: x1}, body: {mass: ms, slide: x2}}
springs: {tyre: {k: kt, between: [ground, wheel]}, s: {k: ks, between: [wheel, body]}}
dampers: {d: {c: c, between: [wheel, body]}}
variants:
  parameters:
    mu: {from: 30 kg, to: 48 kg, step: 2 kg}
    ms: {from: 250 kg, to: 430 kg, step: 20 kg}
    ks: {from: 16 kN/m, to: 25 kN/m, step: 1 kN/m}
  ask: {"omega_d[1]": rad/s, "omega_d[2]": rad/s, "zeta[1]": , "zeta[2]": }
  without: [regime]
"""
MANY = 4600
MORE = QUARTER_CAR.replace("step: 1 kN/m", "step: 0.2 kN/m")
COUNT, ALONE, STUDENTS = 1000, 20, 20
LONG = 3            # runs of what takes over half a second
GATE = 0.35         # of as many scenes read anew
COURSE = 100        # students
SET = ("4_free_damped/bell_crank_dashpot.yaml", "3_free_undamped/wheel_on_incline_with_cord.yaml",
       "6_two_degrees/quarter_car_damped.yaml")
HANDED_OUT = 0.5    # of as many worked solutions by commands
MEMORY = 500        # MiB


def rows(runs: Any) -> list[Timing]:
    """Milliseconds of all variants with scenes read anew as the baseline, of a tenth of them, of sheets."""
    measured = json.loads(answer("from vibcli.bench.homework import main; main()", runs))
    ours, tenth, many, anew, sheets, accepted = measured
    case = f"{COUNT} variants of two degrees, four keys, mistakes, bands, gates"
    return [Timing(case, ours, "ms", GATE, "as many read anew, keys alone", anew),
            Timing("  a variant, beside one of a tenth of them", ours / COUNT, "ms", None, "", 10 * tenth / COUNT),
            Timing(f"  a variant of {MANY:,}, beside one of these", many / MANY, "ms", None, "", ours / COUNT),
            Timing("  of these are accepted", accepted, "", None),
            Timing(f"  {STUDENTS} sheets with keys and worked solutions, a sheet", sheets / STUDENTS, "ms", None),
            *_course()]


def _course() -> list[Timing]:
    """Seconds and peak memory of sheets for all students of a course, beside those of the commands that solve one."""
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(PROBLEMS, os.path.join(folder, "problems"))
        given = {"set.yaml": "problems: [" + ", ".join(f"problems/{name}" for name in SET) + "]\n",
                 "roster.csv": "id\n" + "".join(f"s{number}\n" for number in range(COURSE)),
                 "salt": "a secret text\n"}
        for name, text in given.items():
            Path(folder, name).write_text(text, encoding="utf-8")
        paths = {name: os.path.join(folder, name) for name in given}
        handed = vibcli("homework", paths["set.yaml"], "-o", os.path.join(folder, "out"), "--students",
                        paths["roster.csv"], "--salt-file", paths["salt"])
        alone = {name: (vibcli("solve", os.path.join(PROBLEMS, name), "--steps"), (0,)) for name in SET}
        found = costs({"handed": (handed, (0,)), **alone}, 1, warm=True)
    case = f"{COURSE} students, {len(SET)} problems: sheets, keys with steps, manifest"
    commands = COURSE * sum(found[name].time for name in SET) / 1e3
    return [Timing(case, found["handed"].time / 1e3, "s", HANDED_OUT, "as many vibcli solve --steps", commands),
            Timing("  peak memory", found["handed"].memory, "MiB", MEMORY, absolute=True)]


def main() -> None:
    """Child process: print [ms of all variants, of a tenth, of some four times as many, of as many scenes read anew, of
    sheets, how many are accepted]."""
    import sys

    from vibcli.api.source import problem_of, text_source
    from vibcli.homework.assignment import assigned
    from vibcli.homework.course import Course, CoursePart, CourseProblem
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.folder import files
    from vibcli.homework.handout import Handout
    from vibcli.homework.paper import Pages
    from vibcli.homework.roster import numbered
    from vibcli.homework.variants import solve_variants

    def solved(text: str) -> "tuple[float, SolvedVariants, SceneDocument]":
        source = text_source(text)
        document = SceneDocument.of(source.node, source.file, None)
        start = process_time()
        found = solve_variants(problem_of(source), document)
        return process_time() - start, found, document

    few = f"{QUARTER_CAR}  sample: {COUNT // 10}\n"
    solved(few)
    ours = [solved(QUARTER_CAR) for _ in range(min(int(sys.argv[1]), LONG))]
    tenth = median(solved(few)[0] for _ in range(int(sys.argv[1])))
    many = solved(MORE)[0]
    _, found, document = ours[0]
    start = process_time()
    for variant in found.accepted[:ALONE]:
        fresh = document.anew(variant.values)
        for key in found.keys:
            key.value(fresh)
    anew = (process_time() - start) * COUNT / ALONE
    problem = CourseProblem("car", "car.yaml")
    handout = Handout.of(problem, found, document, QUARTER_CAR)
    students = numbered(STUDENTS)
    numbers = assigned(b"a secret text", "car", students, len(found.accepted))
    sheets = [(student, [(handout, number)]) for student, number in zip(students, numbers, strict=True)]
    course = Course("Week 1", "", "", (CoursePart((problem,), 1),))
    start = process_time()
    list(files(course, [handout], sheets, 1, "a secret text", Pages(), lambda part: None))
    seconds = median(one[0] for one in ours), tenth, many, anew, process_time() - start
    print(json.dumps([*(1e3 * one for one in seconds), len(found.accepted)]))
