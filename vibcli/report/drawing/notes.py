"""What a drawing cannot show, in words below it: elements without a place, equations, given energies and matrices."""

from vibcli.report.drawing import lettering, rows

SIZE, LEADING, MOST = 9.5, 15.0, 8


def lines(stage, box):
    """The Texts of the notes, below the box of the drawing."""
    left, bottom = (box[0], box[1] - 10.0) if box else (0.0, 0.0)
    found = []
    for runs in of(stage)[:MOST]:
        bottom -= LEADING
        found.append(lettering.text(runs, left, bottom, "note"))
    return found


def of(stage):
    """The runs of each note."""
    spec, scene = stage.scene.spec, stage.scene
    shown = {edge.name for edge in rows.edges(scene)}
    found = []
    for section, keys in (("springs", ("k", "torsion")), ("dampers", ("c", "torsion"))):
        for name, record in (spec.get(section) or {}).items():
            if "stretch" in record and name not in shown:
                field = next(record[key] for key in keys if key in record)
                found.append(_note(f"{name}: ", scene, (field, " on "), (record["stretch"], "")))
    for name, record in (spec.get("forces") or {}).items():
        if "value" in record:
            found.append(_note(f"{name}: ", scene, (record["value"], "")))
    for name, record in (spec.get("constraints") or {}).items():
        if "equation" in record:
            found.append(_note(f"{name}: ", scene, (record["equation"], " = 0")))
    for key, field in getattr(spec.get("energies"), "values", {}).items():
        found.append(_note(f"{key} = ", scene, (field, "")))
    if "matrices" in spec.sections:
        found.append(lettering.words("M, C, K given for " + ", ".join(scene.coordinates), SIZE))
    return found


def _note(head, scene, *parts):
    runs = list(lettering.words(head, SIZE))
    for field, after in parts:
        written = lettering.written(scene.lower(field), SIZE)
        if len(lettering.letters(written)) > lettering.LONGEST:
            written = lettering.words(field.text, SIZE)
        runs += written
        if after:
            runs += lettering.words(after, SIZE)
    return tuple(runs)
