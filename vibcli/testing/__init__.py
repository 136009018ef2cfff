"""Answers of scenes as tests of pytest."""
