"""What a scene file may say, before anything is built: fields, parameters, signals."""
