"""Does a test notice? One small change at a time, and the tests of its room: `python tests/mutate.py --seed 1`.

The changes are made in a copy of the project. Constants that only place something in a picture, and texts, are left
alone; a change that no test can see since nothing depends on it is told by hand in the list of survivors.
"""

import argparse
import ast
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path
from queue import Queue
from typing import NamedTuple

PROJECT = Path(__file__).resolve().parent.parent
TOOLS = ("vibcli/bench", "vibcli/manual")       # measured by being run, and texts
PICTURES = ("vibcli/drawing", "vibcli/plots")
SCENES = ("bad", "trials", "fuzz/test_wrong_nodes.py", "routes", "derivations", "fuzz/test_odd.py")
MODES = ("rooms/analyses/modal", "trials", "rooms/inverse", "rooms/analyses/closed_form")
MOTIONS = ("rooms/quantities", "trials", "routes/test_motion_routes.py", "commands/test_curves.py")
BESIDE = {      # a room: what else tests it beside the folder of its name under rooms/; the longest prefix counts
    "vibcli/symbolic": ("rooms/notation", "rooms/mechanics/equilibrium", *SCENES),
    "vibcli/numerics": (*MODES, "rooms/mechanics/equilibrium", *MOTIONS),
    "vibcli/notation": ("rooms/symbolic", "rooms/analyses/closed_form", "commands"),
    "vibcli/analyses": MODES,
    "vibcli/analyses/excitation": ("rooms/analyses/transient", *MOTIONS),
    "vibcli/analyses/transient": ("rooms/results", *MOTIONS),
    "vibcli/analyses/frequency_response": ("rooms/mechanics/test_outputs.py", *MOTIONS),
    "vibcli/analyses/closed_form": ("rooms/inverse", "commands/test_json.py", "derivations"),
    "vibcli/analyses/time_integration": ("rooms/elements", "rooms/scene", *MOTIONS),
    "vibcli/elements": SCENES,
    "vibcli/scene": ("rooms/elements", "rooms/reader", *SCENES),
    "vibcli/mechanics": ("rooms/elements", "rooms/scene", *MODES, *SCENES),
    "vibcli/inverse": ("trials", "bad"),
    "vibcli/drawing": (),
    "vibcli/plots": ("commands/test_plots.py",),
    "vibcli/report": ("rooms/notation", "rooms/drawing", "commands"),
    "vibcli/cli": ("bad", "commands", "fuzz/test_hostile.py"),
    "vibcli": ("rooms/symbolic", "rooms/base", "rooms/language", "rooms/reader", *MOTIONS, "bad", "commands",
               "rooms/inverse", *SCENES),
}
COMPARED = {ast.Lt: ">=", ast.LtE: ">", ast.Gt: "<=", ast.GtE: "<", ast.Eq: "!=", ast.NotEq: "==",
            ast.In: "not in", ast.NotIn: "in", ast.Is: "is not", ast.IsNot: "is"}
QUICK = {"OPENBLAS_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": ""}     # one thread; modules are compiled once
REPLACED = {ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*", ast.Pow: "*"}


class Change(NamedTuple):
    """What stands at `start` of the text of a file, and what takes its place."""

    file: str
    line: int
    start: int
    old: str
    new: str

    def __str__(self):
        return f"{self.file}:{self.line}: {self.old!r} → {self.new!r}"


def room_of(file):
    """The longest prefix in BESIDE."""
    return max((room for room in BESIDE if file.startswith(room + "/")), key=len)


def changes(file):
    """Every Change of a file."""
    text = (PROJECT / file).read_text(encoding="utf-8")
    starts, tree = [0], ast.parse(text)
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line.encode()))
    data = text.encode()

    def place(node, end=False):
        line, column = (node.end_lineno, node.end_col_offset) if end else (node.lineno, node.col_offset)
        return starts[line - 1] + column

    def between(left, right, new):
        start, end = place(left, True), place(right)
        return Change(file, left.end_lineno, start, data[start:end].decode(), f" {new} ")

    texts = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in ast.walk(node)}
    found = [one for node in ast.walk(tree) if id(node) not in texts for one in _of(node, file, data, place, between)]
    return sorted((one for one in found if not set("()#\n") & set(one.old)), key=lambda one: one.start)


def _of(node, file, data, place, between):
    """The Changes of one node of the tree."""
    def whole(part, new):
        return Change(file, part.lineno, place(part), data[place(part):place(part, True)].decode(), new)

    if isinstance(node, ast.Compare) and len(node.ops) == 1:
        yield between(node.left, node.comparators[0], COMPARED[type(node.ops[0])])
    elif isinstance(node, ast.BinOp) and type(node.op) in REPLACED and not _text(node):
        yield between(node.left, node.right, REPLACED[type(node.op)])
    elif isinstance(node, ast.BoolOp):
        yield between(*node.values[:2], "or" if isinstance(node.op, ast.And) else "and")
    elif isinstance(node, ast.Constant) and type(node.value) in (int, float) and not file.startswith(PICTURES):
        yield whole(node, repr(node.value + 1) if isinstance(node.value, int) else repr(node.value / 1024 or 1.0))
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in ("min", "max"):
        yield whole(node.func, "max" if node.func.id == "min" else "min")
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub) and not isinstance(node.operand, ast.Constant):
        yield Change(file, node.lineno, place(node), data[place(node):place(node.operand)].decode(), "")


def _text(node):
    """Is a sum or product one of texts?"""
    return any(isinstance(part, (ast.JoinedStr, ast.List, ast.Tuple))
               or (isinstance(part, ast.Constant) and isinstance(part.value, str)) for part in ast.walk(node))


def chosen(count, seed, room=None):
    """So many Changes, all rooms alike."""
    dice = random.Random(seed)
    files = {}
    for path in sorted((PROJECT / "vibcli").rglob("*.py")):
        file = path.relative_to(PROJECT).as_posix()
        if not file.startswith(TOOLS):
            files.setdefault(room_of(file), []).extend(changes(file))
    rooms = [room] if room else sorted(files)
    return [dice.choice(files[rooms[k % len(rooms)]]) for k in range(count)]


def _changed_together():
    """{file: {name of a test: weight}} of the commits that changed both, a large commit weighing little."""
    log = subprocess.run(["git", "log", "--name-only", "--format=format:#"], cwd=PROJECT, capture_output=True).stdout
    found = {}
    for files in map(str.split, log.decode().split("#")):
        for file, test in product(files, [file for file in files if "/test_" in file]):
            weights, name = found.setdefault(file, {}), Path(test).name
            weights[name] = weights.get(name, 0.0) + 1 / len(files)
    return found


def _own(file):
    """[the folder of tests/rooms/ that is named as the file's, or as the nearest folder above it that has one]."""
    folders = [PROJECT / "tests" / "rooms" / folder for folder in Path(file).relative_to("vibcli").parents]
    return [folder for folder in folders[:-1] if folder.is_dir()][:1]


def tests_of(file, together):
    """The tests in the folder of the file's room, then those beside them; of each first those that import the file by
    its name, then those that changed together with it."""
    package, _, module = file.removesuffix(".py").replace("/", ".").rpartition(".")
    imported = re.compile(rf"{re.escape(package)}(\.{module}\b| import .*\b{module}\b)")

    def rank(test):
        names = imported.search(test.read_text(encoding="utf-8"))
        return not names, -together.get(file, {}).get(test.name, 0.0)

    found = {}
    for folder in (*_own(file), *(PROJECT / "tests" / name for name in BESIDE[room_of(file)])):
        found |= dict.fromkeys(sorted([folder] if folder.suffix else folder.rglob("test_*.py"), key=rank))
    return [test.relative_to(PROJECT).as_posix() for test in found]


def noticed(change, copy, tests, seconds):
    """The first test of the room that fails, "no end" where one does not end in time; None where none does."""
    path = copy / change.file
    original, times = path.read_bytes(), path.stat()
    start, old = change.start, change.old.encode()
    assert original[start:start + len(old)] == old
    path.write_bytes(original[:start] + change.new.encode() + original[start + len(old):])
    try:
        done = subprocess.run([sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests], cwd=copy,
                              env=dict(os.environ, PYTHONPATH=str(copy), **QUICK), timeout=seconds,
                              capture_output=True, text=True)
    except subprocess.TimeoutExpired:
        return "no end"
    finally:
        path.write_bytes(original)
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))       # else what was compiled in this second stays
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return None if done.returncode == 0 else (failed or ["it does not start"])[0]


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--count", type=int, default=100)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--room", choices=sorted(BESIDE))
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--seconds", type=float, default=900, help="after which the tests of a change count as hung")
    asked = options.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        copies = Queue()
        for k in range(asked.jobs):
            copy = Path(folder) / str(k)
            shutil.copytree(PROJECT, copy, ignore=shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache"))
            copies.put(copy)

        def tried(change):
            copy = copies.get()
            try:
                return change, noticed(change, copy, tests_of(change.file, together), asked.seconds)
            finally:
                copies.put(copy)

        survivors, together = [], _changed_together()
        with ThreadPoolExecutor(asked.jobs) as pool:
            for change, by in pool.map(tried, chosen(asked.count, asked.seed, asked.room)):
                print(change, "—", by or "SURVIVED", flush=True)
                survivors += [change] if by is None else []
    print(f"{asked.count - len(survivors)} of {asked.count} noticed")


if __name__ == "__main__":
    main()
