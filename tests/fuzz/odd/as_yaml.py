"""Scenes as text and as plain values, by libyaml where it is there."""

import yaml

LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)


class Plain(getattr(yaml, "CSafeDumper", yaml.SafeDumper)):
    """Without anchors: what stands twice is written twice."""

    def ignore_aliases(self, data):
        return True


def scene_of(text):
    """Mappings and lists of texts."""
    return yaml.load(text, LOADER)


def text_of(scene):
    return yaml.dump(scene, Dumper=Plain, sort_keys=False, default_flow_style=None, width=1000, allow_unicode=True)
