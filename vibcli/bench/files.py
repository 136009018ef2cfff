"""Many files in one process: `vibcli check` of a folder of numeric problems."""

import json
import os
import shutil

from vibcli.bench import scenes
from vibcli.bench.processes import answer, costs, vibcli
from vibcli.bench.rows import Row

PROBLEMS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "problems")
FILES = 200


def rows(runs, folder):
    """Milliseconds a file, start-up shared out among them."""
    place = os.path.join(folder, "many")
    os.mkdir(place)
    originals = json.loads(answer("from vibcli.bench.files import main; main()")) if os.path.isdir(PROBLEMS) else []
    for i in range(FILES):
        copy = os.path.join(place, f"{i:03}.yaml")
        if originals:
            shutil.copyfile(originals[i % len(originals)], copy)
        else:
            with open(copy, "w", encoding="utf-8") as stream:
                stream.write(scenes.TWO_DEGREES)
    found = costs({"check": (vibcli("check", "--quiet", place), (0, 1))}, runs)
    return [Row(f"vibcli check, {FILES} numeric files, each", found["check"].time / FILES, "ms", 10.0, absolute=True)]


def main():
    """Child process: print the problem files whose scenes have numbers and search for nothing."""
    from vibcli.cli.check import _files
    from vibcli.cli.common import load

    def searches(spec):
        found = spec.get("find")
        return bool(spec.choices or (found and found.search) or any(a.asked.text == "equilibria" for a in spec.answers))

    def plain(problem):
        return not problem.symbolic and not any(map(searches, (problem.spec, *problem.spec.cases.values())))

    print(json.dumps([file for file in _files(PROBLEMS) if plain(load(file))]))
