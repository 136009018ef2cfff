"""What was found of files by a check, kept for the next time: read back where nothing has changed that it hangs on.

An entry is a file of JSON, named by the file that it is of and by the options; it holds a key, made of the bytes of the
file and of the records beside it that it names, of the options, of the sources of the program and of the versions of
what it computes with. An entry that is damaged counts as none. Faults of ours are not kept, nor is what hangs on a file
that is not there.
"""

import json
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from hashlib import blake2b
from pathlib import Path
from typing import TYPE_CHECKING, Any

from vibcli.base.decoding import MAX_BYTES
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.cli.checking.found import CheckedAnswer, CheckedFile, Trouble

if TYPE_CHECKING:
    from collections.abc import Iterator

    from vibcli.language.document.nodes import DocumentNode

NAME, FORM, SOURCES = ".vibcli_cache", 1, "sources"
ROOT = Path(__file__).parents[2]
COMPUTES_WITH = "numpy", "scipy", "sympy", "mpmath", "PyYAML"
TAG = "Signature: 8a477f597d28d172789f06886806bc55\n# Results of `vibcli check`; they may be deleted.\n"
BESIDE = {"CACHEDIR.TAG": TAG, ".gitignore": "*\n"}
LONGEST, LARGEST = 300, 100 * 2**20     # characters of a name of a record; bytes of one
ABSENT = "there is no file"


class Unusable(Exception):
    """The folder of the cache cannot be used, for this reason."""


def folder_of(paths: Sequence[str]) -> Path:
    """Where the cache is unless another folder is named: beside the first path."""
    path = os.path.normpath(paths[0])
    beside = path if os.path.basename(path) in (".", "..", "") else os.path.dirname(path)
    return Path(beside or ".") / NAME


class Cache:
    """The cache in a folder; options: what else the results hang on. Unusable where it is a link, no folder, holds
    other files, which git would ignore from then on, or is not to be written to."""

    def __init__(self, folder: Path, options: Sequence[Any]) -> None:
        self._folder, self._options = folder, json.dumps(options)
        if folder.is_symlink():
            raise Unusable("it is a link")
        try:
            folder.mkdir(exist_ok=True)
            if not (folder / "CACHEDIR.TAG").exists() and any(map(_is_of_others, os.listdir(folder))):
                raise Unusable("it holds other files")
            for name, text in BESIDE.items():
                if not (folder / name).exists():
                    _write(folder / name, text.encode())
            self._machinery = _machinery(folder)
        except (OSError, PhysicsError) as error:
            raise Unusable(getattr(error, "strerror", None) or str(error)) from None
        if not os.access(folder, os.W_OK | os.X_OK):
            raise Unusable("it may not be written to")

    def find(self, file: str) -> CheckedFile | None:
        """What was found of a file when it was as it is now; None where that is not known."""
        entry = self._entry(file)
        if entry is None:
            return None
        data = _bytes(file, MAX_BYTES)
        if data is None or entry["key"] != self._key(file, data, entry["records"]):
            return None
        return _found(file, entry["found"])._replace(cached=True, seconds=entry["seconds"])

    def seconds(self, file: str) -> float:
        """How long the check of a file took last, 0 where that is not known."""
        entry = self._entry(file)
        seconds: float = 0.0 if entry is None else entry["seconds"]
        return seconds

    def checked(self, file: str, check: Callable[[str], CheckedFile]) -> CheckedFile:
        """What `check` finds of a file, kept where nothing that it hangs on has changed meanwhile."""
        before = self._state(file)
        found = check(file)
        if before is not None and _lasts(found) and self._state(file, before) == before:
            text = json.dumps({"file": file, "records": before.records, "key": before.key, "seconds": found.seconds,
                               "found": [found.code, found.failed, found.answers, found.troubles]})
            with suppress(PhysicsError):        # where it cannot be written it is not kept
                _write(self._path(file), json.dumps({"form": FORM, "sum": _digest(text), "entry": text}).encode())
        return found

    def _state(self, file: str, before: "Dependencies | None" = None) -> "Dependencies | None":
        """The Dependencies of a file now; None where it cannot be read. before: that of the same bytes, if they are."""
        data = _bytes(file, MAX_BYTES)
        if data is None:
            return None
        same = before is not None and before.data == data
        records = before.records if same else _records(file, data)
        return Dependencies(data, records, self._key(file, data, records))

    def _path(self, file: str) -> Path:
        return self._folder / f"{_digest(file, self._options)[:32]}.json"

    def _entry(self, file: str) -> dict[str, Any] | None:
        """The entry of a file, None where there is none or it is damaged."""
        try:
            outer = json.loads(_bytes(self._path(file), LARGEST) or b"")
            if outer["form"] != FORM or outer["sum"] != _digest(outer["entry"]):
                return None
            entry: dict[str, Any] = json.loads(outer["entry"])
        except (ValueError, KeyError, TypeError, RecursionError):
            return None
        return entry if entry["file"] == file else None

    def _key(self, file: str, data: bytes, records: Sequence[str]) -> str:
        beside = [name and _file_digest(os.path.join(os.path.dirname(file), name)) for name in records]
        return _digest(data, self._options, json.dumps([records, beside]), self._machinery)


def _is_of_others(name: str) -> bool:
    """In a folder that has no tag yet: is a file of this name none of those that make it a cache?"""
    return not any(name.startswith((own, f".{own}.")) for own in BESIDE)


class Dependencies(NamedTuple):
    """What a result hangs on: the bytes of a file, the names of its records, the key of all."""

    data: bytes
    records: list[str]
    key: str


def _lasts(found: CheckedFile) -> bool:
    """Is it no fault of ours, and hangs on nothing that is not there?"""
    return found.code != 101 and not any(one.message.startswith(ABSENT) for one in found.troubles)


def _machinery(folder: Path) -> str:
    """The hash of what computes: the sources of vibcli, Python, and the packages by their versions."""
    described = _described()
    return _digest(sys.version, *(_version(name, described) for name in COMPUTES_WITH),
                   _installed(described.get("vibcli")) or _sources(folder / SOURCES))


def _described() -> dict[str, str]:
    """{package in small letters: the folder that describes it}, the first of each on the path of modules."""
    found = {}
    for place in sys.path:
        with suppress(OSError):
            for entry in sorted(os.listdir(place or os.curdir)):
                if entry.endswith((".dist-info", ".egg-info")):
                    found.setdefault(entry.partition("-")[0].lower(), os.path.join(place, entry))
    return found


def _version(name: str, described: dict[str, str]) -> str:
    """What tells the version of a package: the name of the folder that describes it."""
    if name.lower() in described:
        return os.path.basename(described[name.lower()])
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(name)
    except PackageNotFoundError:
        return "–"


def _installed(described: str | None) -> str | None:
    """The list of the files of an installed wheel, with their hashes; None of sources that can be edited."""
    here = os.path.relpath(__file__, ROOT.parent).replace(os.sep, "/")
    try:
        record = Path(described, "RECORD").read_text(encoding="utf-8")
    except (OSError, TypeError):
        return None
    is_this = os.path.realpath(os.path.dirname(described)) == os.path.realpath(ROOT.parent)
    return record if is_this and f"\n{here}," in f"\n{record}" else None


def _sources(kept: Path) -> str:
    """The hash of the sources, read anew where a name, size or instant of change is another one than in a file."""
    files = sorted((os.path.relpath(path, ROOT), path) for path in _files(ROOT))
    looks = _digest(*(f"{name} {(known := os.stat(path)).st_size} {known.st_mtime_ns}" for name, path in files))
    try:
        before, found, own = (_bytes(kept, MAX_BYTES) or b"").decode().split()
        if before == looks and own == _digest(before, found):
            return found
    except ValueError:
        pass
    found = _digest(*(part for name, path in files for part in (name, Path(path).read_bytes())))
    with suppress(PhysicsError):
        _write(kept, f"{looks} {found} {_digest(looks, found)}\n".encode())
    return found


def _files(folder: str | Path) -> "Iterator[str]":
    """The paths of Python files in a folder and all below it."""
    with os.scandir(folder) as entries:
        inside = list(entries)
    for entry in inside:
        if entry.is_dir(follow_symlinks=False):
            if entry.name != "__pycache__":
                yield from _files(entry.path)
        elif entry.name.endswith(".py"):
            yield entry.path


def _digest(*parts: str | bytes) -> str:
    """The hash of texts and bytes, each with its length."""
    found = blake2b(digest_size=20)
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        found.update(len(data).to_bytes(8, "little") + data)
    return found.hexdigest()


def _bytes(file: str | Path, most: int) -> bytes | None:
    """The bytes of a file, None where it cannot be read or is longer."""
    try:
        if not os.path.isfile(file):
            return None
        with open(file, "rb") as stream:
            data = stream.read(most + 1)
    except OSError:
        return None
    return data if len(data) <= most else None


def _file_digest(path: str) -> str | None:
    data = _bytes(path, LARGEST)
    return None if data is None else _digest(data)


def _records(file: str, data: bytes) -> list[str]:
    """The names in a scene that are those of files beside it."""
    from vibcli.api.source import bytes_source

    node = bytes_source(data, file).node
    folder = os.path.dirname(file)
    names = {text for text in _texts(node) if 0 < len(text) <= LONGEST and "\0" not in text and "\n" not in text}
    return sorted(name for name in names if os.path.isfile(os.path.join(folder, name)))


def _texts(node: "DocumentNode | None") -> "Iterator[str]":
    """All texts that stand as values in a document."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        if hasattr(one, "entries"):
            waiting += [value for _, value in one.entries.values()]
        elif hasattr(one, "items"):
            waiting += one.items
        elif hasattr(one, "text"):
            yield one.text.strip()


def _found(file: str, kept: Sequence[Any]) -> CheckedFile:
    """The CheckedFile of what JSON holds."""
    code, failed, answers, troubles = kept
    return CheckedFile(file, code, failed, [
        CheckedAnswer(data, rule, tuple(place), name, said, estimated)
        for data, rule, place, name, said, estimated in answers], [
        Trouble(rule, message, hint, place and tuple(place), source, of_answers)
        for rule, message, hint, place, source, of_answers in troubles])


def _write(path: Path, data: bytes) -> None:
    from vibcli.base.output_files import write_whole

    write_whole(path, data)
