"""True values in mpmath, from the element data alone: nothing here calls what vibcli solves with."""
