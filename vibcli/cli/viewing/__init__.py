"""A page in the browser that follows a file: what it shows, its server, and the process that solves."""
