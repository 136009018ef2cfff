"""vibcli: mechanical vibration problems, from a scene in YAML to textbook answers."""

__version__ = "0.1.0"
