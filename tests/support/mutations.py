"""Small faults in what is found of a variant, one at a time: do the gates notice each before it is handed out?

    PYTHONPATH=.:tests python -m support.mutations --seed 1 --count 100
"""

import argparse
import random
from collections import Counter

from support.shipped_variants import WITH_VARIANTS

from vibcli.api.source import file_source, problem_of
from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.document import SceneDocument
from vibcli.homework.gates import Wrong
from vibcli.homework.variants import read_anew, solve_variants
from vibcli.language.given_values import giver, number_and_unit


def some_of(path, count):
    """(document, SolvedVariants) of so many variants of a problem."""
    source = file_source(path)
    problem = problem_of(source)
    rules = problem.spec.get("variants")._replace(sample=count)
    document = SceneDocument.of(source.node, source.file, None)
    return document, solve_variants(problem.with_spec(problem.spec.with_sections(variants=rules)), document)


def key_off(draw, document, found, variant):
    """A key off by two bands."""
    i = draw.randrange(len(variant.keys))
    one = variant.keys[i]
    return _with(variant, i, one._replace(value=one.value + draw.choice((-2, 2)) * one.band.width))


def mistakes_swapped(draw, document, found, variant):
    """What two mistakes give, swapped; None where all give the same within the band."""
    pairs = [(i, j, k) for i, one in enumerate(variant.keys) for j, a in enumerate(one.wrong)
             for k, b in enumerate(one.wrong[:j]) if abs(a.value - b.value) > one.band.width]
    if not pairs:
        return None
    i, j, k = draw.choice(pairs)
    wrong = list(variant.keys[i].wrong)
    wrong[j], wrong[k] = Wrong(wrong[j].mistake, wrong[k].value), Wrong(wrong[k].mistake, wrong[j].value)
    return _with(variant, i, variant.keys[i]._replace(wrong=tuple(wrong)))


def mistake_off(draw, document, found, variant):
    """What a mistake gives, off by two bands; None where that is nothing."""
    i = draw.randrange(len(variant.keys))
    one, wrong = variant.keys[i], list(variant.keys[i].wrong)
    j = draw.randrange(len(wrong))
    if not wrong[j].value:
        return None
    off = 1 + draw.choice((-2, 2)) * one.band.width / abs(one.value)
    wrong[j] = Wrong(wrong[j].mistake, wrong[j].value * off)
    return _with(variant, i, one._replace(wrong=tuple(wrong)))


def given_doubled(draw, document, found, variant):
    """Its keys with a force, stiffness, mass or length doubled; None where no key changes."""
    given = {name: record["value"] for name, record in found.problem.spec.parameters.items() if "value" in record}
    given |= {name: value.expression for name, value in variant.values.items()}
    known = {name: number_and_unit(value) for name, value in given.items()}
    name = draw.choice([name for name, written in known.items() if written is not None])
    number, unit = known[name]
    try:
        scene = document.anew({**variant.values, name: giver(unit, name)(2 * number)})
        values = [key.value(scene) for key in found.keys]
    except (SpecError, PhysicsError):
        return None
    pairs = list(zip(values, variant.keys, strict=True))
    if all(abs(value - one.value) <= one.band.width for (value, _), one in pairs):
        return None
    return variant._replace(keys=tuple(one._replace(value=value, error=error) for (value, error), one in pairs))


MUTATIONS = key_off, mistakes_swapped, mistake_off, given_doubled


def _with(variant, i, key):
    return variant._replace(keys=(*variant.keys[:i], key, *variant.keys[i + 1:]))


def is_noticed(document, found, variant):
    """Is it a fault to hand this variant out?"""
    try:
        read_anew(document, found.keys, variant)
    except RuntimeError as error:
        return "two ways to" in str(error)
    return False


def mutated(draw, mutation, known):
    """(document, SolvedVariants, one of its variants with a fault)."""
    while True:
        document, found = draw.choice(known)
        variant = mutation(draw, document, found, draw.choice(found.accepted))
        if variant is not None:
            return document, found, variant


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--count", type=int, default=100, help="of each kind of fault")
    given = options.parse_args()
    draw, known = random.Random(given.seed), [some_of(path, 10) for path in WITH_VARIANTS]
    for mutation in MUTATIONS:
        noticed = Counter(is_noticed(*mutated(draw, mutation, known)) for _ in range(given.count))
        print(f"{mutation.__name__}: {noticed[True]} of {given.count} noticed")


if __name__ == "__main__":
    main()
