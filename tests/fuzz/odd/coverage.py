"""How often random scenes hold what the language has: each key, word, function, signal, quantity and door is a kind."""

import re
from collections import Counter

from . import doors
from .as_yaml import scene_of
from .scene_text import displacements

# what changes no number, asks for numbers, or is drawn by a door and not in a scene; members and `damping`, which have
# sweeps of their own
ASIDE = re.compile(r"scene\.(title|source|question|find|choose|answers|cases|damping|bars|shafts|beams|strings)|"
                   r"parameter\.|.*\.about|coordinate\.null|(damping|bar|shaft|beam|string|segment|section|end|attachment"
                   r"|oscillator|modes)\.")
DEFINITIONS = "parameter", "request", "response", "frequency_response", "choose", "answer"


class Catalogue:
    """The kinds of keys and words that the schema of scenes lists, and which of them a scene holds."""

    def __init__(self):
        self.schema, self.kinds = doors.schema(), set()
        self._list("scene", self.schema)
        for name, definition in self.schema["definitions"].items():
            if name not in DEFINITIONS:
                self._list(name, definition)
        self.functions = doors.words_of("functions")
        self.kinds |= {f"{name}()" for name in self.functions} | {"ag() record"}
        self.kinds |= {f"carried by {kind}" for kind in ("slide", "pin", "roll", "move", "weld")}
        self.kinds |= {f"prescribed {kind}" for kind in ("slide", "pin", "roll", "move", "turn", "moves", "equation")}
        self.kinds = {kind for kind in self.kinds if not ASIDE.match(kind)}

    def _list(self, name, schema):
        for part in (schema, *schema.get("anyOf", ()), *schema.get("allOf", ())):
            self.kinds |= {f"{name}.{key}" for key in part.get("properties", ())}
            for key, value in part.get("properties", {}).items():
                self.kinds |= {f"{name}.{key}={word}" for word in value.get("enum", ()) if word != "true"}

    def of_scene(self, text):
        """{kind: 1} of what a scene holds."""
        scene = scene_of(text)
        found = set(self._held("scene", self.schema, scene))
        found |= {f"{name}()" for name in re.findall(r"(\w+)\(", text) if name in self.functions}
        found |= {"ag() record" for name in scene.get("records", {}) if f"{name}(" in text}
        for body in scene.get("bodies", {}).values():
            for kind in ("slide", "pin", "roll", "move", "turn"):
                if any(re.search(r"\bt\b", text) for text in map(str, displacements(kind, body.get(kind)))):
                    found.add(f"prescribed {kind}")
                motion = body.get(kind)
                carrier = motion.get("carrier") if isinstance(motion, dict) else None
                found |= {f"carried by {kind}" for kind in scene["bodies"].get(carrier, {})}
        found |= {"prescribed moves" for point in scene.get("points", {}).values() if "moves" in point}
        found |= {"prescribed equation" for tie in scene.get("constraints", {}).values()
                  if re.search(r"\bt\b", str(tie.get("equation", "") if isinstance(tie, dict) else tie))}
        return Counter(kind for kind in found if kind in self.kinds)

    def _held(self, name, schema, value):
        """The kinds in a value that a part of the schema describes."""
        if "$ref" in schema:
            name = schema["$ref"].rpartition("/")[2]
            schema = self.schema["definitions"][name]
        if isinstance(value, list):
            for part in (schema, *schema.get("anyOf", ())):
                for entry in value if "items" in part else ():
                    yield from self._held(name, part["items"], entry)
        for part in (*schema.get("anyOf", ()), *schema.get("allOf", ())):
            yield from self._held(name, part, value)
        if not isinstance(value, dict):
            yield from (f"{name}={value}" for _ in range(value in schema.get("enum", ())))
            return
        for key, entry in value.items():
            if key in schema.get("properties", {}):
                yield f"{name}.{key}"
                yield from self._held(f"{name}.{key}", schema["properties"][key], entry)
            elif isinstance(schema.get("additionalProperties"), dict):
                yield from self._held(name, schema["additionalProperties"], entry)


SIGNALS = ("q", "q'", "T", "V", "Phi", "*.x", "*.y", "*.angle", "*.x'", "*.y'", "*.angle'", "*.stretch",
           "*.stretch'", "*.force", "*.energy", "*.power", "*.reaction.x", "*.reaction.y", "*.reaction.moment",
           "*.drive")
ASKED = {*SIGNALS, *(f"full {signal}" for signal in SIGNALS), "frf"}


def of_signal(signal):
    """The kind of a signal: its names left out."""
    _, dot, part = signal.partition(".")
    return f"*.{part}" if dot else signal if signal in SIGNALS else "q" + "'" * signal.count("'")
