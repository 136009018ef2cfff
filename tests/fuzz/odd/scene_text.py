"""Parts of a scene as it is written: a case over it, the texts of its motions."""


def displacements(kind, motion):
    """The texts that say how far a body moves."""
    if motion is None:
        return []
    if kind == "move":
        return motion["by"] if isinstance(motion, dict) else motion
    if kind == "roll":
        return [motion[key] for key in ("travel", "turn", "swing") if key in motion]
    return [motion["by"] if isinstance(motion, dict) else motion]


def merged(scene, case):
    """A case over its scene: mappings key by key, all else replaced."""
    def over(below, above):
        if not (isinstance(below, dict) and isinstance(above, dict)):
            return above
        return {**below, **{key: over(below.get(key), value) for key, value in above.items()}}

    return over({k: v for k, v in scene.items() if k not in ("cases",)}, scene["cases"][case]) if case else scene
