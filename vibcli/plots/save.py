"""Figures as files: PNG, SVG or PDF by the suffix; the same figure gives the same bytes."""

from pathlib import Path

from vibcli.base.output_files import refuse_unwritable, write_whole

SUFFIXES = (".png", ".svg", ".pdf")


def refuse(path):
    """A PhysicsError where a figure cannot be saved there: unknown suffix, no such folder, a link, not writable."""
    refuse_unwritable(path, SUFFIXES)


def save(figure, path):
    """Write the figure to the file."""
    refuse(path)
    from vibcli.plots.picture import picture

    write_whole(path, picture(figure, Path(path).suffix.lower()[1:]))
