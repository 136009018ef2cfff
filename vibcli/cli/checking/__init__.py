"""`vibcli check`: what is found of each file as data, told or written in any form, and kept for the next time."""
