"""vibcli: mechanical vibration problems, from a scene in YAML to textbook answers.

    p = vibcli.load("scene.yaml"); p.omega; p["max(x)"].value           vibcli explain python
"""

__version__ = "0.1.0"

TYPE_CHECKING = False       # that of `typing` would have to be imported
if TYPE_CHECKING:
    from typing import Any

DOOR = {"load": "load", "loads": "load", "Model": "model", "SpecError": "model", "PhysicsError": "model"}


def __getattr__(name: str) -> "Any":
    """What `vibcli explain python` names, imported from vibcli.api when it is asked for."""
    if name not in DOOR:
        raise AttributeError(f"module 'vibcli' has no attribute '{name}'")
    from importlib import import_module

    return getattr(import_module(f"vibcli.api.{DOOR[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *DOOR})
