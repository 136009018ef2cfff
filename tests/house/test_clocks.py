"""What is printed hangs on no clock: budgets count work. Clocks are read where times are told, and their jumps change
no byte of what is found."""

import ast
import random
from contextlib import redirect_stderr, redirect_stdout
from importlib import import_module
from io import StringIO
from pathlib import Path

import pytest

from vibcli.cli.program import run

ROOT = Path(__file__).parents[2]
MODULES = {"time", "datetime", "timeit", "sched", "asyncio", "resource"}
TIMERS = {"alarm", "setitimer", "Timer"}        # of signal, and of threads
MEASURING = "vibcli/bench/"
READ = {                # where a clock is read, and what for
    "vibcli/api/source.py": "perf_counter",             # --timings
    "vibcli/base/stage.py": "perf_counter",             # --timings
    "vibcli/cli/progress.py": "monotonic",              # how far long work is
    "vibcli/cli/checking/work.py": "process_time",      # which file is begun first by several processes
    "vibcli/evidence/timing.py": "process_time",        # bench FILE
    "vibcli/evidence/subject.py": "process_time",       # bench FILE
    "vibcli/cli/viewing/following.py": "sleep",         # between two looks at a file that is edited
}
SCENE = """
parameters: {m: 2 kg, k: 800 N/m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: m, at: [0, 0], slide: x}
  bob: {mass: m/2, at: [0, -0.5 m], pin: {at: [0, 0], carrier: cart, by: phi}}
springs: {s: {k: k, between: [[-1 m, 0], cart]}}
initial: {phi: 2 rad}
motion: full
find: [frequencies, modes, {response: {until: 1 s}}]
answers: {"omega[1]": 4.400 rad/s, "max(x)": 5.0 cm}
"""


def clocks(path):
    """Names of clocks and timers that a file imports or calls."""
    found = []
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found += [one.name for one in node.names if one.name.split(".")[0] in MODULES]
        elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] in MODULES:
            found += [one.name for one in node.names]
        elif isinstance(node, ast.Attribute) and node.attr in TIMERS:
            found.append(node.attr)
        elif isinstance(node, ast.ImportFrom):
            found += [one.name for one in node.names if one.name in TIMERS]
    return found


@pytest.mark.sweep
def test_clocks_are_read_where_times_are_told_alone():
    found = {path.relative_to(ROOT).as_posix(): names for path in sorted((ROOT / "vibcli").rglob("*.py"))
             if (names := clocks(path))}
    elsewhere = {file: names for file, names in found.items() if not file.startswith(MEASURING)}
    assert elsewhere == {file: [name] for file, name in READ.items()}


def test_what_is_looked_for_is_seen(tmp_path):
    path = tmp_path / "a.py"
    path.write_text("import time\nfrom datetime import date\nimport signal\nsignal.alarm(3)\n"
                    "from threading import Timer\nimport math\n")
    assert sorted(clocks(path)) == ["Timer", "alarm", "date", "time"]


def said(*args):
    out, err = StringIO(), StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        code = run(list(args))
    return code, out.getvalue(), err.getvalue()


@pytest.mark.parametrize("command", ["solve", "check", "response"])
def test_a_clock_that_jumps_changes_no_byte(command, tmp_path, monkeypatch):
    scene = tmp_path / "scene.yaml"
    scene.write_text(SCENE)
    wanted = said(command, str(scene))
    dice = random.Random(command)
    for file, name in READ.items():
        if name != "sleep":
            module = import_module(file.removesuffix(".py").replace("/", "."))
            monkeypatch.setattr(module, name, lambda: dice.choice([-1e9, 0.0, 1e-9, 1e9]))
    assert wanted[1] and said(command, str(scene)) == wanted
