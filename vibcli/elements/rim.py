"""The circle of a body, about whose centre it rolls, meshes with gears and carries ropes: not its mass centre, where
the body is a sector, an arch or one of several parts."""

from vibcli.elements.shapes import NEEDS

ROUND = tuple(shape for shape, sizes in NEEDS.items() if "radius" in sizes)
CLOSE = 1e-9


def of_parts(record, pieces, scene):
    """(centres as drawn, radius) of the circles of a body of parts, its holes where nothing else is round; `at` of the
    body names the centre outright. The radius is None where the circles are of several sizes."""
    rims = [(piece[3], piece[4], part.get("cut", False)) for part, piece in zip(record["parts"], pieces, strict=True)
            if part.get("shape") in ROUND]
    rims = [rim for rim in rims if not rim[2]] or rims
    if "at" in record:
        at = scene.pair(record["at"])
        rims, centres = [rim for rim in rims if _same(rim[0], at, scene)], [at]
    else:
        centres = _different([rim[0] for rim in rims], scene)
    radii = _different([(rim[1], scene.table.zero) for rim in rims], scene)
    return centres, radii[0][0] if len(radii) == 1 else None


def _different(places, scene):
    found = []
    for place in places:
        if not any(_same(place, other, scene) for other in found):
            found.append(place)
    return found


def _same(one, two, scene):
    near, far = (sum(abs(scene.number(part)) for part in parts)
                 for parts in ([a - b for a, b in zip(one, two, strict=True)], [*one, *two]))
    return near <= CLOSE * far

