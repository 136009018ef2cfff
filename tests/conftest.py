"""Which tests are sweeps, that `make quick` leaves out: hostile and random scenes; of the tests with a problem file
those of all but one file in a chapter; of the other tests of rooms and commands with several cases all but the first
case; what takes a fifth of a second is marked where it stands. Each process has one thread: those of small matrices
wait for one another where several processes share the cores; and it seldom looks for garbage, among what was
collected never, nor while it is, as fifteen thousand tests and what they import are looked through each time; nor at
the end, in all that is kept. Every other process begins to collect at the end, where it is all that is collected: what
is rewritten to tell why an assertion fails is kept for the others, and each rewrites half."""

import gc
import os
from functools import cache
from pathlib import Path

import pytest

os.environ.setdefault("VIBCLI_NO_CACHE", "1")           # what a test checks is checked
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")      # before NumPy is imported; commands that are run inherit it

gc.disable()            # until all is collected

TESTS = Path(__file__).parent
PROBLEMS = sorted(TESTS.parent.glob("problems/*/*.yaml"))
ALL = {path.stem for path in PROBLEMS}
ONE_CASE = {"rooms", "commands"}
FROM_THE_END = pytest.StashKey[bool]()
ONE_A_CHAPTER = set({path.parent: path.stem for path in reversed(PROBLEMS)}.values())


def files_of_problems(item):
    """The stems of the files of problems/ that a test has, by path or by name."""
    values = item.callspec.params.values() if hasattr(item, "callspec") else ()
    stems = {value.stem if isinstance(value, Path) else value for value in values if isinstance(value, (Path, str))}
    return stems & ALL


@cache
def kind_of(path):
    """The folder of tests/ that a file is in."""
    return path.relative_to(TESTS).parts[0]


def pytest_configure(config):
    number = int(getattr(config, "workerinput", {"workerid": "gw0"})["workerid"].removeprefix("gw"))
    if number % 2 and [Path(arg).resolve() for arg in config.args] == [TESTS]:
        config.args = [str(path) for path in sorted(TESTS.rglob("test_*.py"), reverse=True)]
        config.stash[FROM_THE_END] = True


def pytest_collection_modifyitems(config, items):
    if config.stash.get(FROM_THE_END, False):
        items.sort(key=lambda item: item.path)
    met = set()     # tests of which one case was met
    for item in items:
        stems = files_of_problems(item)
        test, kind = (item.path, getattr(item, "originalname", item.name)), kind_of(item.path)
        another = not stems and test in met and kind in ONE_CASE
        if kind == "fuzz" or not stems <= ONE_A_CHAPTER or another:
            item.add_marker(pytest.mark.sweep)
        if not stems:
            met.add(test)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    from support.distribution import Together

    return Together(config, log)


def pytest_collection_finish():
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)
    gc.enable()


def pytest_sessionfinish():
    gc.freeze()


@pytest.fixture
def scene(tmp_path):
    """What writes a scene to a file and gives its path."""
    def write(text):
        path = tmp_path / "scene.yaml"
        path.write_text(text, encoding="utf-8")
        return str(path)
    return write
