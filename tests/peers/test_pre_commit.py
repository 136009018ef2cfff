"""The hook as pre-commit runs it: it installs the package and its requirements into an environment of its own, which
takes minutes and a registry, so that `make peers` alone does."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
RIGHT = "bodies: {a: {mass: 2 kg, slide: x}}\nsprings: {s: {k: 200 N/m, between: [ground, a]}}\n" \
        'answers: {"omega[1]": 10 rad/s}\n'

pytest.importorskip("pre_commit", reason="no pre-commit here")


@pytest.mark.skipif("VIBCLI_PEERS_POOL" not in os.environ, reason="make peers")
@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="no repository here")
def test_try_repo_marks_the_wrong_file_of_two(tmp_path):
    folder = tmp_path / "course"
    folder.mkdir()
    (folder / "right.yaml").write_text(RIGHT)
    (folder / "wrong.yaml").write_text(RIGHT.replace("10 rad/s", "11 rad/s"))
    subprocess.run(["git", "init", "-q"], cwd=folder, check=True)
    subprocess.run(["git", "add", "."], cwd=folder, check=True)
    settings = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    done = subprocess.run([sys.executable, "-m", "pre_commit", "try-repo", str(ROOT), "vibcli-check", "--all-files"],
                          cwd=folder, env=settings | {"PRE_COMMIT_HOME": str(tmp_path / "home")}, text=True,
                          stdout=subprocess.PIPE, check=False)
    assert done.returncode == 1 and "1 answer agrees, 1 differs in 2 files" in done.stdout
    assert "wrong.yaml" in done.stdout and "right.yaml" not in done.stdout.replace("wrong.yaml", "")
