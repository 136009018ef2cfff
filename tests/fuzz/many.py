"""So many mutated files, expressions and scenes, one after the other: nothing but a diagnostic or a refusal escapes.

    python tests/fuzz/many.py COUNT SEED [KIND ...]

Each is drawn by its kind, the seed and its number alone, so that one that fails can be drawn again:

    python tests/fuzz/many.py scenes 17:4711

The kinds: documents are bytes to be read, expressions texts within them, texts and nodes scenes with a few changes in
their text or tree, of which every stage is asked, scenes whole runs of a command on a file.
"""

import random
import sys
import tempfile
import traceback
from contextlib import chdir, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))

from fuzz.test_document_fuzz import bad_bytes, read_and_checked
from fuzz.test_fuzz import a_text, mutated_text, tree_of, try_expression, try_scene, with_changed_text

from vibcli.cli.program import run

COMMANDS = (["solve"], ["check", "--no-cache"], ["equations"], ["frequencies"], ["solve", "--steps"],
            ["draw", "-o", "a.svg"], ["solve", "-o", "a.html"], ["solve", "-o", "a.tex"], ["solve", "--json"],
            ["response", "-o", "a.md"])
CODES = {0, 1, 3, 4, 5}


def expression(dice):
    return try_expression(a_text(dice), dice.random() < 0.1)


def command(dice):
    """A command on a scene with changes in its text, in a folder of its own; its exit code."""
    with tempfile.TemporaryDirectory() as folder, chdir(folder):
        Path("scene.yaml").write_bytes(mutated_text(dice))
        first, *rest = dice.choice(COMMANDS)
        out, err = StringIO(), StringIO()
        with redirect_stdout(out), redirect_stderr(err):
            code = run([first, "scene.yaml", *rest])
        assert code in CODES, err.getvalue()
        assert "\x1b" not in out.getvalue() + err.getvalue()
        assert {path.name for path in Path().iterdir()} <= {"scene.yaml", *rest}
        return code


KINDS = {"documents": lambda dice: read_and_checked(bad_bytes(dice)), "expressions": expression,
         "texts": lambda dice: try_scene(*with_changed_text(dice)), "nodes": lambda dice: try_scene(*tree_of(dice)),
         "scenes": command}


def drawn(kind, seed, number):
    """What becomes of one; its traceback where something else escapes."""
    try:
        return KINDS[kind](random.Random(f"{kind} {seed} {number}"))
    except Exception:
        return traceback.format_exc()


def failures(kind, count, seed):
    """[(number, traceback)] of those from which something escapes."""
    return [(number, found) for number in range(count)
            if isinstance(found := drawn(kind, seed, number), str) and found.startswith("Traceback")]


def main(count, seed, *kinds):
    if count in KINDS:
        print(drawn(count, *seed.split(":")))
        return 0
    failed = 0
    for kind in kinds or KINDS:
        found = failures(kind, int(count), seed)
        for number, told in found:
            print(f"{kind} {seed}:{number}\n{told}")
        print(f"{kind}: {count}, {len(found)} failed", flush=True)
        failed += len(found)
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
