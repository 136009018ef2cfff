"""Equilibria followed as a parameter goes, and the limit points (folds) at which two of them meet."""
