"""`vibcli explain [WORD]`: the manual of the scene language."""

from collections.abc import Sequence

import click


def _complete(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[str]:
    from vibcli.manual.index import words

    return [word for word in words() if word.startswith(incomplete)]


@click.command("explain")
@click.argument("word", nargs=-1, shell_complete=_complete)
def command(word: Sequence[str]) -> None:
    """The manual of the scene language: a section, an element, a key, a quantity, a unit or a topic.

    Without a WORD an overview of all there is; `spring.preload` is a key of one element.
    """
    from vibcli.base.diagnostics import quoted

    text = " ".join(word)
    if not text.strip():
        from vibcli.manual.overview import overview

        click.echo(overview())
        return
    from vibcli.manual.index import nearest_words, page

    try:
        click.echo(page(text))
    except KeyError:
        near = nearest_words(text)
        hint = "did you mean " + " or ".join(near) + "?" if near else "`vibcli explain` lists what there is"
        raise click.UsageError(f"the manual has no page {quoted(text)}; {hint}") from None
