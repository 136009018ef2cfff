"""Entries put into a mapping of a scene file, its text: whatever else it holds stays as it is, comments too."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

import yaml

STEP = 2        # columns by which a mapping that is new stands further in than the one around it


def with_entries(text: str, path: Sequence[str], entries: Mapping[str, str], before: str | None = None) -> str:
    """The text of a valid scene with {key: value} at the end of the mapping that stands at a path of keys. One that is
    missing is made at the end of what is around it, above its key `before` if it has that."""
    found = yaml.compose(text, yaml.CSafeLoader if yaml.__with_libyaml__ else yaml.SafeLoader)
    missing = list(path)
    while missing and (inner := _entry(found, missing[0])) is not None:
        found = inner
        missing.pop(0)
    following = _entry(found, before) if missing and before is not None else None
    if found.flow_style:
        return _within_braces(text, found.end_mark.index - 1, missing, entries)
    column = found.value[0][0].start_mark.column
    held = [value for _, value in found.value]
    if following is not None and held.index(following):
        held = held[:held.index(following)]
    lines = _lines(column, missing, entries)
    return _after_line(text, _end(held[-1]), lines)


def _entry(mapping: yaml.MappingNode, key: str) -> yaml.Node | None:
    return next((value for name, value in mapping.value if name.value == key), None)


def _end(node: yaml.Node) -> int:
    """The index behind the last text of a node; comments and empty lines below it are none of it."""
    while not isinstance(node, yaml.ScalarNode) and not node.flow_style:
        node = node.value[-1][1] if isinstance(node, yaml.MappingNode) else node.value[-1]
    end = node.end_mark
    literal = isinstance(node, yaml.ScalarNode) and node.style in ("|", ">")
    index: int = end.index - (literal and end.column == 0 and end.index > node.start_mark.index)
    return index


def _lines(column: int, missing: Sequence[str], entries: Mapping[str, str]) -> Iterator[str]:
    for key in missing:
        yield f"{' ' * column}{key}:"
        column += STEP
    for key, value in entries.items():
        yield f"{' ' * column}{key}: {value}"


def _after_line(text: str, index: int, lines: Iterable[str]) -> str:
    """The text with lines below the one in which an index stands, with line ends as it has them."""
    ending = "\r\n" if "\r\n" in text else "\n"
    stop = text.find("\n", index)
    head, tail = (text.rstrip("\r\n") + ending, "") if stop < 0 else (text[:stop + 1], text[stop + 1:])
    return head + "".join(line + ending for line in lines) + tail


def _within_braces(text: str, index: int, missing: Sequence[str], entries: Mapping[str, str]) -> str:
    """The text with entries in quotes before the brace at an index."""
    inner = ", ".join(f'"{key}": "{value}"' for key, value in entries.items())
    for key in reversed(missing):
        inner = f'"{key}": {{{inner}}}'
    head = text[:index].rstrip()
    return f"{head}{'' if head.endswith((',', '{')) else ','}{' ' * (head[-1:] != '{')}{inner}{text[index:]}"
