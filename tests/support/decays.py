"""The damped modes of a scene, and which of them decay otherwise than by ζω."""

from vibcli.base.errors import PhysicsError, SpecError


def damped_modes(scene):
    """Those that are shown of a scene in numbers; none where it has none."""
    if scene.numeric.has_free_symbols or scene.spec.choices:
        return ()
    try:
        return scene.modal.damped.shown() if scene.modal.damped else ()
    except (PhysicsError, SpecError):
        return ()


def wrong_decays(scene):
    """The modes whose decay is not ζω; of what has no ζ it is −Re λ."""
    found = []
    for mode in damped_modes(scene):
        wanted = -mode.eigenvalue.real if mode.zeta is None else mode.zeta * mode.omega
        if not abs(float(mode.decay - wanted)) <= 1e-13 * abs(mode.omega):
            found.append(mode)
    return found
