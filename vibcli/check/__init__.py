"""Answers against results."""
