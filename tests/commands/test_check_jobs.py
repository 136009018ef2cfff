"""`vibcli check --jobs N`: the same bytes in the same order, an interrupt and a fault of one file leave the others."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from support.checked import SCENE

from vibcli.cli import progress
from vibcli.cli.checking import work
from vibcli.cli.program import run

ROOT = Path(__file__).parents[2]


@pytest.fixture
def folder(tmp_path):
    for number, text in enumerate((SCENE.replace("MASS", "1"), SCENE.replace("MASS", "2"), "bodies: {a: 1}\n",
                                   SCENE.replace("MASS", "0"), "title: nothing\n", SCENE.replace("MASS", "1"))):
        (tmp_path / f"{number}.yaml").write_text(text)
    return tmp_path


@pytest.mark.parametrize("options", [[], ["--quiet"], ["--json"], ["--color", "always"], ["--set", "k=3"]])
def test_the_same_bytes_in_the_same_order(folder, options, capfd):
    found = []
    for jobs in ("1", "3"):
        code = run(["check", str(folder), "--jobs", jobs, *options])
        found.append((code, *capfd.readouterr()))
    assert found[0] == found[1] and found[0][0] in (2, 3)


def test_a_fault_of_one_file_leaves_the_others(folder, capfd, monkeypatch):
    whole = work._checked

    def faulty(file, *rest):
        if file.endswith("1.yaml"):
            raise RuntimeError("broken")
        return whole(file, *rest)

    monkeypatch.setattr(work, "_checked", faulty)
    assert run(["check", str(folder), "--json"]) == 101
    out, err = capfd.readouterr()
    assert [one["exit_code"] for one in json.loads(out)] == [0, 101, 3, 4, 0, 0]
    assert "1.yaml" in err and "RuntimeError: broken" in err


def test_a_file_that_ends_its_processes_leaves_the_others(folder, capfd, monkeypatch):
    whole = work._checked
    monkeypatch.setattr(work, "_checked", lambda file, *rest: os._exit(9) if file.endswith("1.yaml") else
                        whole(file, *rest))
    assert run(["check", str(folder), "--json", "--jobs", "2"]) == 3
    out, err = capfd.readouterr()
    assert [one["exit_code"] for one in json.loads(out)] == [0, 4, 3, 4, 0, 0]
    assert "1.yaml: error: workers ended twice before their work did\nhint: ask for fewer --jobs" in err


def test_the_line_that_tells_how_far_it_is_leaves_room_for_what_is_printed(folder, capfd, monkeypatch):
    clock = iter(range(0, 1000, 10))
    monkeypatch.setattr(progress, "monotonic", lambda: float(next(clock)))
    monkeypatch.setattr(progress, "teller", progress.Progress)
    monkeypatch.setattr(sys, "stdout", sys.stderr)       # as on a terminal
    run(["check", str(folder), "--jobs", "2"])
    told = capfd.readouterr().err
    assert "2 of 6 files: 33.3 % done" in told and "5 of 6 files" in told
    for line in told.split("\n"):
        *_, last = line.split("\r\x1b[K")
        assert "done," not in last, line


@pytest.mark.sweep
def test_an_interrupt_tells_what_was_found(tmp_path):
    (tmp_path / "0.yaml").write_text(SCENE.replace("MASS", "1"))
    long = (ROOT / "problems/7_forced_two_degrees/pendulum_as_absorber_of_a_platform.yaml").read_text()
    for number in range(1, 9):
        (tmp_path / f"{number}.yaml").write_text(long)
    process = subprocess.Popen([sys.executable, "-m", "vibcli", "check", "-j", "2", str(tmp_path)], text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                               env={**os.environ, "PYTHONUNBUFFERED": "1"})
    assert "0.yaml" in process.stdout.readline()
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=300)
    assert process.returncode == 130 and "interrupted" in err and "Traceback" not in err
    assert "1 answer agrees in 1 file" in out or "answers agree in" in out
    time.sleep(0.1)
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)
