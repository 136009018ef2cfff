"""Modes of members that several scenes of a file have alike, found once: what tells one search from another are the
numbers of the system, exactly as they are, and what is asked of it."""

from functools import wraps

import pytest

from vibcli.analyses.continuous.damped_parts import DampedPart
from vibcli.analyses.continuous.mode_source import NaturalModes


@pytest.fixture(scope="module")
def modes_found_once():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(NaturalModes, "numbered", _once(NaturalModes.numbered, lambda modes: (
            [getattr(modes.elements, part) for part in modes.elements.__slots__], modes.digits,
            modes.ground.growing, modes.ground.resting)))
        for find in ("roots", "zeros_within", "series"):
            patch.setattr(DampedPart, find, _once(getattr(DampedPart, find), lambda part: (
                part.matrix.polynomial.tolist(), part.matrix.pieces, part.matrix.kept, part.coordinates, part.n)))
        yield


def _once(find, numbers_of):
    known: dict = {}

    @wraps(find)
    def found(one, *asked):
        key = repr((numbers_of(one), [part.tolist() if hasattr(part, "tolist") else part for part in asked]))
        if key not in known:
            known[key] = find(one, *asked)
        return known[key]
    return found
