"""Sets of very many variables: their algebra, and scenes that are the same by them."""

import random
from pathlib import Path

import pytest

import vibcli
from vibcli.cli.program import run
from vibcli.symbolic import node
from vibcli.symbolic.node import first_variable, one_variable, union

EXAMPLES = ("double_pendulum", "slider_crank", "two_storeys", "unbalanced_motor", "shaken_support")


@pytest.fixture(params=[0, 3, 8])
def few(request, monkeypatch):
    monkeypatch.setattr(node, "FEW", request.param)


def drawn(generator):
    """A set of Python's, and the same of variables."""
    plain = set(generator.sample(range(12), generator.randrange(6)))
    return plain, union([one_variable(i) for i in plain])


def test_algebra(few):
    generator, everything = random.Random(1), set(range(12))
    for _ in range(300):
        (a, of_a), (b, of_b) = drawn(generator), drawn(generator)
        for plain, found in ((a & b, of_a & of_b), (a | b, of_a | of_b), (a & b, of_a & ~(~of_b)),
                             (a - b, of_a & ~of_b), (b - a, ~of_a & of_b), (a, union([of_a])),
                             (a | b, union([of_a, of_b])), (a - b, ~(~of_a | of_b))):
            assert found == union([one_variable(i) for i in plain])
            assert bool(found) == bool(plain)
            assert first_variable(found) == (min(plain) + 1 if plain else 0)
        outside = ~of_a & ~of_b
        assert all(bool(outside & one_variable(i)) == (i in everything - a - b) for i in everything)
        assert (of_a == of_b) == (a == b)
        assert a != b or hash(of_a) == hash(of_b)


@pytest.mark.parametrize("name", EXAMPLES)
def test_scenes_are_the_same(name, monkeypatch, capsys):
    path = str(Path(vibcli.__file__).parent / "examples" / f"{name}.yaml")
    told = []
    for many in (4096, 1):
        monkeypatch.setattr(node, "FEW", many)
        assert run(["solve", path]) == 0
        told.append(capsys.readouterr().out)
    assert told[0] == told[1]
