"""Scenes that trials answered wrongly: each file of trials/ names in its first comment where its answers come from.

What has to be refused instead stands in bad/ with its words.
"""

from pathlib import Path

import pytest

from vibcli.cli.program import run

TRIALS = sorted(Path(__file__).parent.glob("*.yaml"))


@pytest.mark.sweep
@pytest.mark.parametrize("path", TRIALS, ids=lambda path: path.stem)
def test_its_answers_agree(path, capsys):
    assert path.read_text(encoding="utf-8").startswith("# ")
    code = run(["check", str(path)])
    out, err = capsys.readouterr()
    assert code == 0, out + err


def test_all_were_swept():
    assert TRIALS
