"""The lazy pipeline from a Spec to its answers."""
