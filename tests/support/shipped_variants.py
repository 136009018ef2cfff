"""The problems that ship with variants; some of each, solved once for all tests of a process that only read them."""

from functools import cache
from pathlib import Path
from typing import NamedTuple

from vibcli.api.source import SceneSource, file_source, problem_of
from vibcli.homework.document import SceneDocument
from vibcli.homework.variants import SolvedVariants, solve_variants
from vibcli.results.problem import Problem

PROBLEMS = Path(__file__).parents[2] / "problems"
WITH_VARIANTS = [path for path in sorted(PROBLEMS.glob("*/*.yaml"))
                 if "\nvariants:" in path.read_text(encoding="utf-8")]
SOME = 5       # that are looked at


class Solved(NamedTuple):
    source: SceneSource
    problem: Problem        # with so many variants
    document: SceneDocument
    found: SolvedVariants


@cache
def kept_variants_of(path: Path) -> Solved:
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")._replace(sample=SOME)
    problem = problem.with_spec(problem.spec.with_sections(variants=rules))
    document = SceneDocument.of(source.node, source.file, None)
    return Solved(source, problem, document, solve_variants(problem, document))
