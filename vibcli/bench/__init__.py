"""Benchmarks: `python -m vibcli.bench`, one file a part with `rows(runs)`.

By name what each part measures. A part is imported when it is its turn.
"""

PARTS = {
    "startup": "cold starts of commands as whole processes",
    "pictures": "pictures and reports with pictures as whole processes",
    "growth": "time against the number of coordinates",
    "linkage": "deriving closed linkages",
    "files": "many files checked in one process, and in two",
    "accuracy": "errors of frequencies",
    "certificates": "what certifies results, beside finding them",
    "capabilities": "run time and true error, capability by capability",
    "sparse": "the lowest modes of very many masses",
    "frequency_responses": "frequency responses of many degrees",
    "records": "motions under long measured records",
    "responses": "responses of linear scenes in time",
    "trajectories": "full motions in time",
    "asked_motions": "full motions to an accuracy that is asked",
    "compiled": "a full motion beside one that is compiled",
    "peers": "responses beside python-control, a pendulum beside MuJoCo",
    "events_and_loops": "full motions with events, and with a closed loop",
    "extremes": "extremes of full motions",
    "members": "beams, their frequencies and frequency responses",
    "members_counted": "random members counted against finite elements",
    "sweeps": "quantities over a parameter",
    "homework": "variants of a problem with all gates, and sheets for students",
    "exports": "packages for course systems; a grid in parts, by one process and by two",
}
