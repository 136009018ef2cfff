"""`vibcli schema`: the JSON Schema of scene files, or of sets of them."""

from typing import Any

import click


@click.command("schema")
@click.option("--set", "of_set", is_flag=True, help="That of set.yaml, which names problems of homework.")
def command(of_set: bool) -> None:
    """The JSON Schema (draft 7) of scene files, by which editors complete and check them.

    Write `# yaml-language-server: $schema=scene.schema.json` in the first line of a scene, and
    `vibcli schema > scene.schema.json` once.
    """
    import json

    click.echo(json.dumps(_of_sets() if of_set else _of_scenes(), ensure_ascii=False, indent=1))


def _of_scenes() -> dict[str, Any]:
    from vibcli.manual.json_schema import schema

    return schema()


def _of_sets() -> dict[str, Any]:
    from vibcli.homework.course import ELEMENT
    from vibcli.manual.json_schema import DRAFT

    return {"$schema": DRAFT, "title": "A set of problems of vibcli", **ELEMENT.schema()}
