"""Bytes that atheris changes by what code they reach: nothing but a diagnostic or a refusal escapes.

    python tests/fuzz/guided.py COUNT SEED [KIND ...]

The kinds: documents are bytes to be read, expressions texts within them, solve whole scenes of which every stage is
asked. They begin with the shortest scenes that are shipped, or with pieces of expressions, each kind in a process of
its own; what escapes is told with its bytes.
"""

import importlib.util
import subprocess
import sys
import tempfile
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parents[1]))

LONGEST = 4096      # bytes of an input
SHORTEST = 12       # scenes to begin with
INSTRUMENTED = ("vibcli.language", "vibcli.symbolic", "vibcli.reader")


def document(data):
    from fuzz.test_document_fuzz import read_and_checked

    read_and_checked(data)


def expression(data):
    from fuzz.test_fuzz import try_expression

    try_expression(data[1:].decode(errors="replace"), bool(data[:1] and data[0] & 1))


def solve(data):
    from fuzz.test_fuzz import try_scene

    from vibcli.language.document.document import read

    try_scene(*read(data, "s.yaml"))


KINDS = {"documents": document, "expressions": expression, "solve": solve}


def seeds(kind):
    """The bytes that a kind begins with."""
    from fuzz.test_fuzz import PIECES, SCENES

    if kind == "expressions":
        return [b" " + piece.encode() for piece in PIECES]
    return sorted(SCENES, key=len)[:SHORTEST]


def guided(kind, count, seed, folder):
    """Run one kind in this process, which ends with it."""
    import atheris

    with atheris.instrument_imports(include=list(INSTRUMENTED)):
        KINDS[kind](b"a: 1\n")
    for number, data in enumerate(seeds(kind)):
        (Path(folder) / f"{number}.seed").write_bytes(data)
    atheris.Setup([sys.argv[0], folder, f"-runs={count}", f"-seed={seed}", f"-max_len={LONGEST}", "-verbosity=0",
                   f"-artifact_prefix={folder}/escaped_"], KINDS[kind])
    atheris.Fuzz()


def ended(kind, count, seed):
    """(exit code, what was told) of one kind in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([sys.executable, __file__, "--alone", kind, count, seed, folder], capture_output=True,
                              text=True)
        found = [path.read_bytes() for path in Path(folder).glob("escaped_*")]
    return done.returncode, "\n".join([*map(repr, found), done.stdout + done.stderr])


def main(count, seed, *kinds):
    if importlib.util.find_spec("atheris") is None:
        print("atheris is not installed: nothing is changed by what code it reaches")
        return 0
    failed = 0
    for kind in kinds or KINDS:
        code, told = ended(kind, count, seed)
        print(f"{kind}, by what they reach: {count}, {'nothing escaped' if not code else told}", flush=True)
        failed += bool(code)
    return int(failed > 0)


if __name__ == "__main__":
    if sys.argv[1] == "--alone":
        guided(*sys.argv[2:])
    sys.exit(main(*sys.argv[1:]))
