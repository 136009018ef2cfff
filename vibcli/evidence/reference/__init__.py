"""True values in mpmath, from the element data alone: nothing here calls the methods that are compared."""
