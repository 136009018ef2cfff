"""`vibcli schema`: the JSON Schema of scene files."""

import click


@click.command("schema")
def command():
    """The JSON Schema (draft 7) of scene files, by which editors complete and check them.

    Write `# yaml-language-server: $schema=scene.schema.json` in the first line of a scene, and
    `vibcli schema > scene.schema.json` once.
    """
    import json

    from vibcli.manual.json_schema import schema

    click.echo(json.dumps(schema(), ensure_ascii=False, indent=1))
