"""A grid in parts: the same by one process, by executors in any order, and by halves; workers that die."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import Executor, Future
from functools import cache
from math import inf
from pathlib import Path
from types import SimpleNamespace

import click
import pytest
from support.homework_scenes import BLOCK

from vibcli.api.source import problem_of, text_source
from vibcli.base.errors import PhysicsError
from vibcli.cli.processes import Processes
from vibcli.cli.workers import workers
from vibcli.homework.document import SceneDocument
from vibcli.homework.key_summary import summaries
from vibcli.homework.parts import begin_variants, solve_in_parts
from vibcli.homework.variants import solve_variants

SCENE = BLOCK + """variants:
  parameters:
    m: {from: 1.2 kg, to: 3.2 kg, step: 0.4 kg}
    k: [620 N/m, 820 N/m, 1.1 kN/m]
    c: [5 N*s/m, 9 N*s/m, 40 N*s/m]
  require:
    - zeta[1] < 0.4
  ask: {"omega_d[1]": rad/s, "zeta[1]": }
  mistakes: {"half": {parameters: {k: 500 N/m}}}
"""


class Backwards(Executor):
    """Works on what was submitted last first, when anything is asked for."""

    def __init__(self):
        self.waiting = []

    def submit(self, work, /, *args, **named):
        found = Future()
        self.waiting.append((found, work, args, named))
        found.result = lambda timeout=None: self.done(found)
        return found

    def done(self, found):
        while self.waiting:
            one, work, args, named = self.waiting.pop()
            one.set_result(work(*args, **named))
        return Future.result(found)


def read(text=SCENE):
    source = text_source(text)
    return problem_of(source), SceneDocument.of(source.node, source.file, None)


def told(found):
    return ([(one.place, {name: value.text for name, value in one.values.items()}, one.keys) for one in found.accepted],
            [(one.place, one.gate, one.reason, one.missed) for one in found.rejected], found.same, found.closed,
            [key.text for key in found.keys], [one.name for one in found.mistakes])


@cache
def whole():
    return solve_variants(*read())


@cache
def in_parts(size):
    return solve_in_parts(*read(), size=size)


@pytest.mark.sweep
@pytest.mark.parametrize("size", [7, 20, 53])
def test_parts_are_the_same_in_whatever_order_they_are_solved(size):
    one = in_parts(size)
    assert told(one) == told(solve_in_parts(*read(), executor=Backwards(), size=size))
    assert len(one.accepted) + len(one.rejected) == 54
    assert [one[:2] for one in told(whole())[0]] == [each[:2] for each in told(one)[0]]
    for each, other in zip(whole().accepted, one.accepted, strict=True):
        for key, its in zip(each.keys, other.keys, strict=True):
            assert its.value == pytest.approx(key.value, rel=1e-12) and its.band == pytest.approx(key.band, rel=1e-9)
            assert [wrong.mistake for wrong in key.wrong] == [wrong.mistake for wrong in its.wrong]


@pytest.mark.parametrize("size, count", [(54, 1), (53, 2), (27, 2), (20, 4), (7, 8)])
def test_parts_are_even_in_number_and_of_one_size(size, count):
    tasks = begin_variants(*read(), size=size).tasks
    assert len(tasks) == count and len({task.size for task in tasks}) == 1 and tasks[0].size <= size
    assert [task.start for task in tasks] == list(range(0, 54, tasks[0].size))


@pytest.mark.sweep
def test_what_parts_tell_of_keys_is_what_all_variants_do():
    found = in_parts(7)
    for told_by_parts, of_all in zip(found.summaries, summaries(list(found.accepted)), strict=True):
        assert told_by_parts == of_all and len(of_all.texts) > 2 and len(of_all.nearest) > 1
    first = found.accepted[0].keys[0]._replace(value=0.0)
    nothing = summaries([SimpleNamespace(keys=(first,))])[0]
    assert nothing.widest == 0 and {gap for gap, _, _ in nothing.nearest.values()} == {inf}


@pytest.mark.sweep
def test_a_small_grid_is_one_part():
    begun = begin_variants(*read())
    assert len(begun.tasks) == 1 and begun.pending == []
    assert told(begun.solved()) == told(solve_in_parts(*read(), executor=Backwards()))


@pytest.mark.sweep
def test_processes_find_the_same():
    with workers(2, None) as executor:
        assert told(solve_in_parts(*read(), executor=executor, size=20)) == told(in_parts(20))


def die_once(path):
    if not Path(path).exists():
        Path(path).touch()
        os._exit(1)
    return 42


def die():
    os._exit(1)


@pytest.mark.sweep
def test_a_worker_that_dies_is_said_and_its_part_done_again_once(tmp_path, capsys):
    pool = Processes(2)
    try:
        assert pool.submit(die_once, str(tmp_path / "mark")).result() == 42
        assert "its part is done again" in capsys.readouterr().err
        with pytest.raises(PhysicsError, match="ended twice"):
            pool.submit(die).result()
    finally:
        pool.end()


def test_what_workers_are_asked_for():
    with workers(1, None) as executor:
        assert executor is None
    with pytest.raises(click.UsageError, match="choose one"), workers(2, "tcp://localhost:1"):
        pass
    with pytest.raises(click.UsageError, match=r"extra cluster|no cluster answers"), workers(1, "tcp://localhost:1"):
        pass


@pytest.mark.sweep
def test_an_interrupt_ends_the_workers_and_leaves_nothing(tmp_path):
    (tmp_path / "block.yaml").write_text(SCENE.replace("step: 0.4 kg", "step: 0.001 kg"), encoding="utf-8")
    (tmp_path / "salt").write_text("a secret text", encoding="utf-8")
    command = subprocess.Popen([sys.executable, "-m", "vibcli", "homework", "block.yaml", "-o", "out", "--paper", "2",
                                "--salt-file", "salt", "--jobs", "2"], cwd=tmp_path, stderr=subprocess.PIPE,
                               start_new_session=True)
    children = Path(f"/proc/{command.pid}/task/{command.pid}/children")
    try:
        for _ in range(600):
            if len(children.read_text().split()) >= 3:      # with the tracker of their resources
                break
            time.sleep(0.05)
        started = children.read_text().split()
        time.sleep(0.5)
        os.killpg(command.pid, signal.SIGINT)
        assert command.wait(300) == 130
    finally:
        command.kill()
        command.stderr.close()
    assert len(started) >= 2 and not any(Path(f"/proc/{child}/cmdline").exists() and b"spawn_main" in Path(
        f"/proc/{child}/cmdline").read_bytes() for child in started)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["block.yaml", "salt"]
