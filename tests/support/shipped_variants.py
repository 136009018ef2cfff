"""The problems that ship with variants; some of each, solved once for all tests of a process that only read them."""

from functools import cache
from pathlib import Path
from typing import NamedTuple

from vibcli.api.source import SceneSource, file_source, problem_of
from vibcli.homework.document import SceneDocument
from vibcli.homework.variants import SolvedVariants, solve_variants
from vibcli.reader.variants import VariantRules
from vibcli.results.problem import Problem

PROBLEMS = Path(__file__).parents[2] / "problems"
WITH_VARIANTS = [path for path in sorted(PROBLEMS.glob("*/*.yaml"))
                 if "\nvariants:" in path.read_text(encoding="utf-8")]
SOME = 5       # that are looked at


class WithSome(NamedTuple):
    source: SceneSource
    rules: VariantRules     # those of the file
    problem: Problem        # with so many variants


class Solved(NamedTuple):
    source: SceneSource
    problem: Problem
    document: SceneDocument
    found: SolvedVariants


@cache
def kept_scene_of(path: Path) -> WithSome:
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")
    few = problem.spec.with_sections(variants=rules._replace(sample=SOME))
    return WithSome(source, rules, problem.with_spec(few))


@cache
def kept_variants_of(path: Path) -> Solved:
    source, _, problem = kept_scene_of(path)
    document = SceneDocument.of(source.node, source.file, None)
    return Solved(source, problem, document, solve_variants(problem, document))
