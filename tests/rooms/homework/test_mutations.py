"""Planted faults of ours in how all variants are found: each is seen by a gate."""

import random

import pytest
from support.shipped_variants import WITH_VARIANTS, kept_variants_of

from vibcli.api.source import file_source, problem_of
from vibcli.homework import solved as solving
from vibcli.homework import variants
from vibcli.homework.candidates import candidates
from vibcli.homework.document import SceneDocument
from vibcli.homework.keys import AnswerKey
from vibcli.homework.variants import solve_variants
from vibcli.language.document.mapping import document_of
from vibcli.quantities.expression import value_of
from vibcli.reader.read import read_changed

FEW = 6
DOUBLED = {"springs": "k", "dampers": "c", "forces": "force"}


class Scene:
    """A problem with so many of its variants."""

    def __init__(self, path, count=FEW):
        self.path, source = path, file_source(path)
        problem = problem_of(source)
        self.document = SceneDocument.of(source.node, source.file, None)
        rules = problem.spec.get("variants")._replace(sample=count)
        self.problem = problem.with_spec(problem.spec.with_sections(variants=rules))

    def solve(self):
        return solve_variants(self.problem, self.document)

    def doubled(self):
        """[(section, name)] of what may be twice as large."""
        return [(section, name) for section, key in DOUBLED.items()
                for name, record in (self.problem.spec.get(section) or {}).items() if key in record]

    def with_doubled(self, section, name):
        """The problem with one spring, damper or force twice as large."""
        written = self.problem.spec.get(section)[name][DOUBLED[section]]
        twice = [f"2*({part.text})" for part in written] if isinstance(written, list) else f"2*({written.text})"
        part, _ = document_of({section: {name: {DOUBLED[section]: twice}}})
        return self.problem.with_spec(read_changed(self.document.root, part, "scene.yaml", "", {}))


def all_keys_off(scene, monkeypatch, draw):
    """The keys of a quantity are off in all variants as the shared evaluation finds them."""
    asked = draw.choice(scene.problem.spec.get("variants").ask).asked.text
    real, share = AnswerKey.found, draw.choice((-0.03, 0.03))

    def found(key, problem):
        value = real(key, problem)
        return (value[0] * (1 + share), value[1]) if key.text == asked else value

    monkeypatch.setattr(AnswerKey, "found", found)
    with pytest.raises(RuntimeError, match="two ways"):
        scene.solve()


def mistakes_swapped(scene, monkeypatch, draw):
    """Two mistakes give each other's numbers."""
    first = kept_variants_of(scene.path).found.accepted[0]
    wrong = {one.mistake: one.value for value in first.keys for one in value.wrong}
    pairs = [(a, b) for a in wrong for b in wrong if abs(wrong[a] - wrong[b]) > 1e-6 * abs(wrong[a])]
    one, other = draw.choice(pairs)
    real = variants._equal

    def equal(keys, candidates):
        for each in candidates.values():
            each.wrong[one], each.wrong[other] = each.wrong[other], each.wrong[one]
        return real(keys, candidates)

    monkeypatch.setattr(variants, "_equal", equal)
    with pytest.raises(RuntimeError, match="two ways"):
        scene.solve()


def doubled(scene, monkeypatch, draw):
    """What is solved for all has a spring, damper or force that is twice as large as in the scene."""
    section, name = draw.choice(scene.doubled())
    other = scene.with_doubled(section, name)
    monkeypatch.setattr(solving, "candidates", lambda problem, *args: candidates(
        other if problem is scene.problem else problem, *args))
    try:
        found = scene.solve()
    except RuntimeError as error:
        assert "two ways" in str(error)
        return
    assert not found.accepted or not _matters(scene, other), (section, name)


def _matters(scene, other):
    """Does any key of the scene change with it?"""
    keys = scene.problem.spec.get("variants").ask
    return any(abs(value_of(scene.problem, one.asked)[0] / value_of(other, one.asked)[0] - 1) > 1e-9 for one in keys)


FAULTS = all_keys_off, mistakes_swapped, doubled


@pytest.mark.sweep
@pytest.mark.parametrize("fault", FAULTS, ids=lambda one: one.__name__)
@pytest.mark.parametrize("name", ["bell_crank_dashpot", "quarter_car_damped", "inerter_under_a_machine"])
def test_a_planted_fault_is_seen(fault, name, monkeypatch):
    path = next(path for path in WITH_VARIANTS if path.stem == name)
    fault(Scene(path), monkeypatch, random.Random(f"{name} {fault.__name__}"))


@pytest.mark.sweep
def test_nothing_is_seen_where_nothing_is_planted():
    assert Scene(WITH_VARIANTS[0]).solve().reread == FEW


@pytest.mark.sweep
def test_of_mistakes_that_change_the_scene_one_is_solved_where_its_turn_is(monkeypatch):
    """All where no turn is given, as for the variants of the gate."""
    from support.mutations import some_of
    from support.shipped_variants import WITH_VARIANTS

    from vibcli.homework import fresh_mistakes
    from vibcli.homework.variants import read_anew

    document, found = some_of(next(path for path in WITH_VARIANTS if path.stem == "bell_crank_dashpot"), 2)
    whole, built = fresh_mistakes.mistakes_of, []

    def noted(*given):
        known = whole(*given)
        built.extend(one.name for one in known if one.problem is not None)
        return known

    monkeypatch.setattr(fresh_mistakes, "mistakes_of", noted)
    solved = []
    for turn in (None, 0, 1, 2):
        built.clear()
        read_anew(document, found.keys, found.accepted[0], turn)
        solved.append(set(built))
    assert len(solved[0]) == 2 and [len(one) for one in solved[1:]] == [1, 1, 1]
    assert solved[1] | solved[2] == solved[0] and solved[3] == solved[1]
