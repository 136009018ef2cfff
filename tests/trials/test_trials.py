"""Scenes that trials answered wrongly: each file of trials/ names in its first comment where its answers come from.

What has to be refused instead stands in bad/ with its words.
"""

from pathlib import Path

import pytest
from support.decays import wrong_decays
from support.scenes import kept_problem_of

from vibcli.check.verdicts import check

TRIALS = sorted(Path(__file__).parent.glob("*.yaml"))


@pytest.mark.sweep
@pytest.mark.parametrize("path", TRIALS, ids=lambda path: path.stem)
def test_its_answers_agree(path):
    """And the decay of each damped mode is its ζω."""
    assert path.read_text(encoding="utf-8").startswith("# ")
    scene = kept_problem_of(path)
    verdicts = check(scene)
    assert verdicts and not [verdict for verdict in verdicts if not verdict.agrees]
    assert not wrong_decays(scene)


def test_all_were_swept():
    assert TRIALS
