"""Which tests are sweeps, that `make quick` leaves out: hostile and random scenes, and of the tests with a problem file
each those of all but one file in a chapter; what takes half a second is marked where it stands. Each process has one
thread: those of small matrices wait for one another where several processes share the cores; and it seldom looks for
garbage, among what was collected never, as eleven thousand tests and what they import are looked through each time."""

import gc
import os
from pathlib import Path

import pytest

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")      # before NumPy is imported; commands that are run inherit it

TESTS = Path(__file__).parent
PROBLEMS = sorted(TESTS.parent.glob("problems/*/*.yaml"))
ONE_A_CHAPTER = {path.parent: path.stem for path in reversed(PROBLEMS)}.values()
SWEPT = {path.stem for path in PROBLEMS} - set(ONE_A_CHAPTER)


def of_problems_swept(item):
    """Is it a test with a file of problems/, by path or by name, that is not the first of its chapter?"""
    values = item.callspec.params.values() if hasattr(item, "callspec") else ()
    return any((value.stem if isinstance(value, Path) else value) in SWEPT
               for value in values if isinstance(value, (Path, str)))


def pytest_collection_modifyitems(items):
    for item in items:
        if TESTS / "fuzz" in item.path.parents or of_problems_swept(item):
            item.add_marker(pytest.mark.sweep)


def pytest_collection_finish():
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)
