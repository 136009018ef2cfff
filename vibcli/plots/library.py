"""Matplotlib, imported where something is drawn."""


def matplotlib():
    """The library, which says nothing of the folder that it would keep its cache in."""
    import logging

    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    import matplotlib

    return matplotlib
