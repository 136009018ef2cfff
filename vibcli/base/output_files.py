"""Files that the program writes: whole or not at all, and never through a link."""

import os
from collections.abc import Sequence
from pathlib import Path

from vibcli.base.errors import PhysicsError


def refuse_unwritable(path: Path, suffixes: Sequence[str] | None = None) -> None:
    """A refusal, before anything is computed, where a file of these suffixes (None: any) cannot be written there."""
    path = Path(path)
    if suffixes is not None and path.suffix.lower() not in suffixes:
        found = f"'{path.suffix}'" if path.suffix else "no suffix"
        raise PhysicsError(f"{path} is no file that can be written: it has {found}",
                           f"give it one of {', '.join(suffixes)}")
    try:
        _refuse_place(path)
    except (OSError, ValueError) as error:
        raise _unwritable(path, error) from None


def _refuse_place(path: Path) -> None:
    if not path.parent.is_dir():
        raise PhysicsError(f"there is no folder {path.parent}", f"make it first, to hold {path.name}")
    if path.is_symlink():
        raise PhysicsError(f"{path} is a link, and nothing is written through links", "name the file it leads to")
    if path.exists() and not path.is_file():
        raise PhysicsError(f"{path} is no file", "name a file")
    if not os.access(path.parent, os.W_OK | os.X_OK):
        raise PhysicsError(f"the folder {path.parent} may not be written to", "name another one")


def _unwritable(path: Path, error: OSError | ValueError) -> PhysicsError:
    return PhysicsError(f"{path} cannot be written: {getattr(error, 'strerror', None) or error}", "name another file")


def write_whole(path: Path | str, data: bytes, new: bool = False) -> None:
    """Write the bytes to a new file beside `path` and rename it: what was there is replaced at once, links are not
    followed. `new`: FileExistsError where anything is there."""
    path = Path(path)
    beside = path.with_name(f".{path.name[:64]}.{os.urandom(8).hex()}")
    try:
        try:
            descriptor = os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0), 0o666)
            with os.fdopen(descriptor, "wb") as file:
                file.write(data)
            _put(beside, path, new)
        except BaseException:
            beside.unlink(missing_ok=True)
            raise
    except FileExistsError:
        raise
    except (OSError, ValueError) as error:
        raise _unwritable(path, error) from None


def _put(beside: Path, path: Path, new: bool) -> None:
    """Give a file that is written its name; a new one takes no other's place, whoever was faster."""
    if new:
        try:
            os.link(beside, path)
            beside.unlink()
            return
        except FileExistsError:
            raise
        except OSError:         # a file system without links: the name is taken first
            os.close(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL))
    os.replace(beside, path)
