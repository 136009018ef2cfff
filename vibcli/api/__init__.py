"""The front door, for Python and for the commands: scenes read from files, texts and mappings, and what they answer."""
