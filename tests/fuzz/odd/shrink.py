"""The smallest scene that still comes to the same outcome: entries are taken out as long as they are not missed."""

from .as_yaml import scene_of, text_of

SECTIONS = ("forces", "dampers", "springs", "constraints", "initial", "points", "surfaces", "bodies")


def smallest(text, outcome):
    """`outcome(text)`: a label, or None where all is well."""
    wanted, scene = outcome(text), scene_of(text)
    again = True
    while again:
        again = False
        for smaller in _smaller(scene):
            written = text_of(smaller)
            if outcome(written) == wanted:
                scene, text, again = smaller, written, True
                break
    return text


def _smaller(scene):
    """Scenes with one entry less, the parameters that go with it taken out as well."""
    for section in ("gravity", "motion"):
        if section in scene:
            yield _used({key: value for key, value in scene.items() if key != section})
    for section in SECTIONS:
        for name in scene.get(section, {}):
            yield _used({**scene, section: {k: v for k, v in scene[section].items() if k != name}})
            entry = scene[section][name]
            for key in entry if isinstance(entry, dict) else ():
                yield _used({**scene, section: {**scene[section], name: {k: v for k, v in entry.items() if k != key}}})


def _used(scene):
    from re import findall

    rest = set(findall(r"\w+", str({key: value for key, value in scene.items() if key != "parameters"})))
    return {**{key: value for key, value in scene.items() if value},
            "parameters": {name: v for name, v in scene.get("parameters", {}).items() if name in rest} or {"one": "1"}}
