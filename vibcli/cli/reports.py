"""Reports as files and in other formats: their options, and writing documents and the pictures beside them."""

from functools import reduce
from pathlib import Path
from typing import NamedTuple

import click

from vibcli.cli.pictures import FILE

SUFFIXES = {"text": (".txt",), "markdown": (".md", ".markdown"), "latex": (".tex",), "html": (".html", ".htm"),
            "json": (".json",)}
PICTURES = {"markdown": "svg", "latex": "pdf"}        # written beside the report


class Output(NamedTuple):
    """What to write, where (None: stdout), and whether with pictures."""

    kind: str = "text"
    path: Path | None = None
    pictures: bool = False
    force: bool = False


def report_options(function):
    """Options of the commands that print a report."""
    options = [
        click.option("--format", "kind", type=click.Choice([kind for kind in SUFFIXES if kind != "json"]),
                     help="How to write the report; by the suffix of -o unless named, else text."),
        click.option("-o", "--output", metavar="FILE", type=FILE,
                     help="Write the report to a file: .txt, .md, .tex, .html or .json."),
        click.option("--force", is_flag=True, help="Replace files that exist."),
        click.option("--pictures", is_flag=True, help="Also draw the scene and its mode shapes (not in text)."),
    ]
    return reduce(lambda f, option: option(f), reversed(options), function)


def output_of(file, as_json, kind, output, force, pictures):
    """The Output that the options ask for, before anything is computed; a usage error where that cannot be."""
    if as_json and kind:
        raise click.UsageError("--json does not go with --format")
    suffixes = SUFFIXES.get("json" if as_json else kind, sum(SUFFIXES.values(), ()))
    kind = "json" if as_json else kind or _by_suffix(output)
    if pictures and kind == "json":
        raise click.UsageError("--pictures does not go with JSON")
    if pictures and kind == "text":
        raise click.UsageError("--pictures needs --format markdown, latex or html")
    if output in (None, "-"):
        if pictures and kind in PICTURES:
            raise click.UsageError(f"--pictures in {kind} are files beside the report: name it with -o FILE")
        return Output(kind, None, pictures)
    from vibcli.cli.pictures import target

    return Output(kind, target(file, output, suffixes, force), pictures, force)


def _by_suffix(output):
    suffix = Path(output or "").suffix.lower()
    return next((kind for kind, suffixes in SUFFIXES.items() if suffix in suffixes), "text")


def write_text(text, output):
    """Print a report, or write its file."""
    if output.path is None:
        click.echo(text)
        return
    from vibcli.cli.pictures import write

    write(output.path, (text + "\n").encode("utf-8", "replace"), output.force)


def write_documents(documents, output):
    """Render documents and write them, the pictures first."""
    placed = []

    def place(picture):
        from vibcli.cli.pictures import slug

        name = f"{slug(output.path.stem, str(len(placed) + 1), picture.name)}.{PICTURES[output.kind]}"
        placed.append((output.path.with_name(name), picture))
        return name

    text = _render(documents, output.kind, place)
    if placed:
        from vibcli.cli.pictures import target, write

        for path, _ in placed:
            target(None, path, (path.suffix,), output.force)
        for path, picture in placed:
            write(path, picture.draw(path.suffix[1:]), output.force)
    write_text(text, output)


def _render(documents, kind, place):
    if kind == "html":
        from vibcli.report.formats.html import render

        return render(documents)
    if kind == "latex":
        from vibcli.report.formats.latex import render
    elif kind == "markdown":
        from vibcli.report.formats.markdown import render
    else:
        from vibcli.report.formats.text import render

        return "\n\n\n".join(map(render, documents))
    return render(documents, place)
