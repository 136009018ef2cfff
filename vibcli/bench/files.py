"""Many files in one process: `vibcli check` of a folder of numeric problems."""

import json
import os
import shutil
from glob import glob
from typing import TYPE_CHECKING, Any

from vibcli.bench import scenes
from vibcli.bench.processes import answer, costs, vibcli
from vibcli.bench.rows import Timing

if TYPE_CHECKING:
    from pathlib import Path

PROBLEMS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "problems")
FILES = 200


def rows(runs: Any, folder: "Path | str"):
    """Milliseconds a file, start-up shared out among them."""
    place = os.path.join(folder, "many")
    os.mkdir(place)
    originals = json.loads(answer("from vibcli.bench.files import main; main()")) if os.path.isdir(PROBLEMS) else []
    for i in range(FILES):
        if originals:
            _copy(originals[i % len(originals)], place, i)
        else:
            with open(os.path.join(place, f"{i:03}.yaml"), "w", encoding="utf-8") as stream:
                stream.write(scenes.TWO_DEGREES)
    found = costs({"check": (vibcli("check", "--quiet", place), (0, 1))}, runs)
    each = found["check"].time / FILES
    return [Timing(f"vibcli check, {FILES} numeric files, each", each, "ms", 10.0, absolute=True)]


def _copy(original, place, number):
    """A file under a number of its own, in a folder with the records that lie beside it."""
    chapter = os.path.dirname(original)
    folder = os.path.join(place, os.path.basename(chapter))
    if not os.path.isdir(folder):
        os.mkdir(folder)
        for name in os.listdir(chapter):
            if not name.endswith(".yaml"):
                shutil.copyfile(os.path.join(chapter, name), os.path.join(folder, name))
    shutil.copyfile(original, os.path.join(folder, f"{number:03}.yaml"))


def main():
    """Child process: print the problem files whose scenes have numbers and search for nothing."""
    from vibcli.api.source import file_source, problem_of

    def searches(spec):
        found = spec.get("find")
        return bool(spec.choices or (found and found.search) or any(a.asked.text == "equilibria" for a in spec.answers))

    def plain(problem):
        specs = (problem.spec, *problem.spec.cases.values())
        return not problem.numeric.has_free_symbols and not any(map(searches, specs))

    files = sorted(glob(os.path.join(PROBLEMS, "**", "*.yaml"), recursive=True))
    print(json.dumps([file for file in files if plain(problem_of(file_source(file)))]))
