"""Reading a scene file: bytes to a tree of nodes with places and all diagnostics, whatever the bytes are.

Only the events of YAML's parser are used, with an explicit stack: nothing here recurses, guesses a type,
follows an alias or builds an object that a file names. What a text means, each field decides.
"""

import os
import stat
from typing import Any

import yaml

from vibcli.base import decoding
from vibcli.base.errors import Diagnostic, Where
from vibcli.language.document.nodes import Mapping, Scalar, Sequence
from vibcli.language.document.tree_builder import Slipped, Stopped, Tree

__all__ = ["Mapping", "Scalar", "Sequence", "read", "read_file"]

MAX_REREAD = 50_000  # characters read again, in all, to go on after slips in flow collections
MAX_SLIPS = 20


class SlowParser(yaml.reader.Reader, yaml.scanner.Scanner, yaml.parser.Parser):  # type: ignore[misc]
    """The same events from pure Python, some twenty times slower."""

    def __init__(self, text: str) -> None:
        yaml.reader.Reader.__init__(self, text)
        yaml.scanner.Scanner.__init__(self)
        yaml.parser.Parser.__init__(self)


_Parser = yaml.cyaml.CParser if yaml.__with_libyaml__ else SlowParser


def read(data: bytes, file: str) -> tuple[Mapping | None, list[Diagnostic]]:
    """The top mapping of the bytes, None where reading had to stop, and all diagnostics in file order."""
    text, problems = decoding.decode(data, file)
    if text is None:
        return None, problems
    node, found = _read_text(text, file)
    return node, sorted(problems + found, key=lambda problem: problem.where[1:3])


def read_file(path: Any) -> tuple[Any, list[Diagnostic], list[str]]:
    """(node, diagnostics, source lines) of a file. Only a missing path raises: FileNotFoundError."""
    file = os.fsdecode(path)
    try:
        mode = os.stat(file).st_mode
        if not stat.S_ISREG(mode):  # a pipe without writer would wait for ever, a device never end
            what = "a directory" if stat.S_ISDIR(mode) else "a device or pipe"
            return None, [_unreadable(file, f"expected a scene file, found {what}")], []
        with open(file, "rb") as stream:
            data = stream.read(decoding.MAX_BYTES + 1)
            size = max(len(data), os.fstat(stream.fileno()).st_size)
    except (FileNotFoundError, NotADirectoryError) as error:
        raise FileNotFoundError(error.errno, error.strerror, file) from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        return None, [_unreadable(file, f"the file cannot be read: {reason.lower()}")], []
    if size > decoding.MAX_BYTES:
        return None, [decoding.too_long(file, size)], []
    node, problems = read(data, file)
    return node, problems, decoding.lines(data)


def _unreadable(file: str, message: str) -> Diagnostic:
    return Diagnostic(Where(file, 1, 1, 0), message, "give the name of a readable .yaml file")


def _read_text(source: str, file: str) -> tuple[Mapping | None, list[Diagnostic]]:
    """Read, and after each slip in a flow collection mend it and read again, within bounds."""
    slips, budget, hidden = [], MAX_REREAD, None
    while True:
        tree = Tree(source, file, hidden)
        try:
            complete = _grow(tree)
            break
        except Slipped as slip:
            from vibcli.language.document.misread_expressions import SHOW

            hidden = SHOW
            problem, source, index = slip.args
            slips.append(problem)
            budget -= index + MAX_REREAD // MAX_SLIPS
            if budget < 0:
                return None, slips + tree.problems
    return _top(tree, complete, slips), slips + tree.problems


def _grow(tree: Tree) -> bool:
    """Fill the tree; whether the whole file was read."""
    try:
        tree.grow(_Parser(tree.source).get_event)
        return True
    except Stopped:
        return False
    except (yaml.YAMLError, ValueError, OverflowError) as error:  # the two latter: chr() in the slow parser
        from vibcli.language.document import syntax_messages

        slip = syntax_messages.slip(error, tree)
        if slip:
            raise Slipped(*slip) from None
        tree.problems.append(syntax_messages.explained(error, tree))
        return False


def _top(tree: Tree, complete: bool, slips: list[Diagnostic]) -> Mapping | None:
    """The top mapping, or None with a report where the file holds something else."""
    top = tree.root
    if not complete:
        return None
    if isinstance(top, Mapping):
        return top
    if isinstance(top, Sequence) or (top is not None and (top.text or top.quoted)):
        from vibcli.language.document import syntax_messages

        tree.problems.append(syntax_messages.not_a_mapping(top, tree.source))
    elif not tree.problems and not slips:
        tree.problems.append(Diagnostic(Where(tree.file, 1, 1, 0), "the file is empty, expected a scene",
                                        "write for example bodies: {block: {mass: 2 kg, slide: x}}"))
    return None
