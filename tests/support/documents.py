"""A scene file with one of everything that a reader meets, and what is read as plain lists and mappings."""

import yaml

from vibcli.language.document.document import Scalar, Sequence

LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)      # of texts alone; in C where PyYAML has it

SCENE = """\
title: "Mass: on a spring"
parameters: {m: 2 kg, k: , on: 010}
bodies:
  block: {mass: m, slide: x}
  'tip''s':
    - [0, -(L + h)]
    - omega[1]: 1e3
answers:
  omega[1]: sqrt(k/m)   # rad/s
  x': ''
question: >
  What is
  asked
"""


def plain(node):
    if isinstance(node, Scalar):
        return node.text
    if isinstance(node, Sequence):
        return [plain(item) for item in node.items]
    return {key: plain(value) for key, (_, value) in node.entries.items()}
