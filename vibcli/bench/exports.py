"""Packages for course systems of a thousand variants with four keys; a grid of thousands of variants in parts, by one
process and by two, whose processor time and ours is shared out on two cores: by turns, the least of each, as what else
runs on a machine adds to either."""

import json
from importlib import import_module
from multiprocessing import get_context
from resource import RUSAGE_CHILDREN, RUSAGE_SELF, getrusage
from statistics import median
from time import process_time
from typing import TYPE_CHECKING, Any

from vibcli.bench.homework import LONG, MANY, MORE, QUARTER_CAR
from vibcli.bench.processes import answer
from vibcli.bench.rows import Timing
from vibcli.homework.exports import FORMATS

if TYPE_CHECKING:
    from vibcli.results.problem import Problem

COUNT, MADE, SIZE = 1000, 40, 1000
GATE = 0.15         # of making the models of as many
KILOBYTES = 20      # a variant, its figure taken off
TWO = 0.7           # of one process; 0.6 where starts of processes count for nothing


def rows(runs: Any) -> list[Timing]:
    """Seconds of each package with the models of as many variants as the baseline, KB a variant; the grid by two."""
    made, packages, one, two = json.loads(answer("from vibcli.bench.exports import main; main()", runs))
    found = [Timing(f"{COUNT} variants with four keys for {name}", seconds, "s", GATE, "their models made", made)
             for name, (seconds, _) in packages.items()]
    found += [Timing(f"  {name}, a variant beside its figure", size, "KB", KILOBYTES, absolute=True)
              for name, (_, size) in packages.items()]
    return [*found, Timing(f"a grid of {MANY:,} in parts, two processes", two, "s", TWO, "one", one)]


def main() -> None:
    """Child process: print [s of the models, {format: (s, KB a variant)}, s of a grid by one process, by two]."""
    import sys
    from concurrent.futures import ProcessPoolExecutor

    from vibcli.api.source import problem_of, text_source
    from vibcli.homework.course import Course, CoursePart, CourseProblem
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.exports.item import questions_of
    from vibcli.homework.handout import Handout
    from vibcli.homework.parts import solve_in_parts

    def read(text: str) -> "tuple[Problem, SceneDocument]":
        source = text_source(text)
        return problem_of(source), SceneDocument.of(source.node, source.file, None)

    problem, document = read(QUARTER_CAR.replace("variants:", f"variants:\n  sample: {MADE}"))
    one = CourseProblem("car", "car.yaml")
    course = Course("Week 3", "", "", (CoursePart((one,), 1),))
    handout = Handout.of(one, solve_in_parts(problem, document), document, QUARTER_CAR)
    start = process_time()
    questions = [each for number in handout.variants for each in questions_of(course, handout, number)]
    made = (process_time() - start) * COUNT / len(questions)
    many = [questions[i % len(questions)]._replace(item=f"car-{i}") for i in range(COUNT)]
    figure = len(questions[0].figure.draw("svg"))
    packages = {}
    for name in FORMATS:
        times = []
        for _ in range(min(int(sys.argv[1]), LONG)):
            start = process_time()
            files = dict(import_module(f"vibcli.homework.exports.{name}").package(course, many))
            times.append(process_time() - start)
        figures = COUNT * figure * 4 / 3 if name == "moodle" else figure
        packages[name] = median(times), (sum(map(len, files.values())) - figures) / COUNT / 1024

    alone, both = [], []
    for _ in range(min(int(sys.argv[1]), LONG)):
        start = _spent()
        solve_in_parts(*read(MORE), None, SIZE)
        middle = _spent()
        with ProcessPoolExecutor(2, get_context("spawn")) as executor:
            solve_in_parts(*read(MORE), executor, SIZE)
        alone.append(middle - start)
        both.append((_spent() - middle) / 2)
    print(json.dumps([made, packages, min(alone), min(both)]))


def _spent() -> float:
    """Processor seconds of this process and of those that it started and that have ended."""
    each = getrusage(RUSAGE_SELF), getrusage(RUSAGE_CHILDREN)
    return sum(usage.ru_utime + usage.ru_stime for usage in each)
