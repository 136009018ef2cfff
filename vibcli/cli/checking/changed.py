"""The scenes that have changed since a revision of git, or whose records have."""

import os
import subprocess
from collections.abc import Sequence

import click

from vibcli.base.decoding import MAX_BYTES


def changed_since(revision: str, files: Sequence[str]) -> list[str]:
    """Those of the files that differ from a revision, are new, or name a changed file beside them or below; a usage
    error where git cannot tell."""
    if revision.startswith("-"):
        raise click.UsageError(f"--changed-since {revision}: expected a revision of git, such as origin/main")
    found = {}      # {folder: the changed files of its repository}
    return [file for file in files if _has_changed(file, _changed(os.path.dirname(file) or ".", revision, found))]


def _changed(folder: str, revision: str, found: dict[str, set[str]]) -> set[str]:
    if folder not in found:
        top = _git(folder, "rev-parse", "--show-toplevel", revision=revision)[0]
        if top not in found:
            names = _git(top, "diff", "--name-only", "-z", "--no-renames", revision, "--", revision=revision)
            names += _git(top, "ls-files", "--others", "--exclude-standard", "-z", revision=revision)
            found[top] = {os.path.realpath(os.path.join(top, name)) for name in names if name}
        found[folder] = found[top]
    return found[folder]


def _git(folder: str, *args: str, revision: str) -> list[str]:
    """What git prints, in parts."""
    try:
        done = subprocess.run(["git", "-C", folder, *args], capture_output=True, check=False)
    except OSError:
        raise click.UsageError("--changed-since asks git, which is not here") from None
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().split("\n")[0]
        raise click.UsageError(f"--changed-since {revision}: git says: {said[:200]}")
    out = done.stdout.decode("utf-8", "surrogateescape")
    return out.split("\0") if "\0" in out else out.strip("\n").split("\n")


def _has_changed(file: str, changed: set[str]) -> bool:
    path = os.path.realpath(file)
    if path in changed:
        return True
    folder = os.path.dirname(path) + os.sep
    below = [os.path.basename(one).encode("utf-8", "surrogateescape") for one in changed if one.startswith(folder)]
    if not below:
        return False
    try:
        with open(path, "rb") as stream:
            data = stream.read(MAX_BYTES)
    except OSError:
        return True
    return any(name in data for name in below)
