"""The problems that ship with variants: some of each solved, held against fresh readings, by all gates."""

from pathlib import Path

import pytest

from vibcli.api.source import file_source, problem_of
from vibcli.homework.candidates import sampled
from vibcli.homework.course import course_of
from vibcli.homework.document import SceneDocument
from vibcli.homework.variants import solve_variants

PROBLEMS = Path(__file__).parents[3] / "problems"
WITH_VARIANTS = [path for path in sorted(PROBLEMS.glob("*/*.yaml"))
                 if "\nvariants:" in path.read_text(encoding="utf-8")]
SOME = 12


def test_how_many_there_are():
    assert len(WITH_VARIANTS) >= 15
    assert len({path.parent.name[0] for path in WITH_VARIANTS}) == 9


@pytest.mark.parametrize("path", WITH_VARIANTS, ids=lambda path: path.stem)
def test_variants_of_a_problem(path):
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")
    assert rules.candidates >= 200 and not set(rules.without) - {"told"}
    problem = problem.with_spec(problem.spec.with_sections(variants=rules._replace(sample=SOME)))
    found = solve_variants(problem, SceneDocument.of(source.node, source.file, None))
    looked_at = sampled(problem.spec.get("variants"))
    assert len(found.accepted) + len(found.rejected) == SOME == len(looked_at)
    assert len(found.accepted) >= 0.8 * SOME and found.reread == len(found.accepted)
    for one in found.accepted:
        for key in one.keys:
            assert 0 < key.band.width <= 0.02 * abs(key.value) and key.error <= 0.1 * key.band.width


@pytest.mark.parametrize("path", sorted(PROBLEMS.glob("sets/*")), ids=lambda path: path.name)
def test_sets(path):
    found = course_of(str(path))
    assert found.title and len(found.problems) >= 3
    assert {Path(one.path).resolve() for one in found.problems} <= {one.resolve() for one in WITH_VARIANTS}
