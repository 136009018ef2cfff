"""The language of scene files, before anything is built: fields, parameters, signals."""
