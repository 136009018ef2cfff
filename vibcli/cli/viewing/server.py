"""The page on this machine's loopback: two paths, both from memory; no path of a request reaches the file system.

A request that names another host than ours is refused, so that no page from elsewhere reads this one by letting its own
name stand for this machine.
"""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from http import server as http_server
from secrets import token_urlsafe
from threading import Thread
from typing import Any

import click

from vibcli.cli.viewing.page import page
from vibcli.cli.viewing.shown import Shown
from vibcli.report.formats.html_page import POLICY

HOST = "127.0.0.1"
LONGEST = 20.0      # seconds that an answer waits for news
IDLE = 60.0         # seconds after which a silent connection is closed
POLL = 0.05         # seconds until the server sees that it is to end


class Server(http_server.ThreadingHTTPServer):
    """Serves what is Shown."""

    daemon_threads = True

    def __init__(self, shown: Shown, port: int):
        self.shown, self.nonce = shown, token_urlsafe(16)
        super().__init__((HOST, port), Handler)
        names = [f"{name}:{self.server_port}" for name in (HOST, "localhost")]
        self.hosts = {*names, *((HOST, "localhost") if self.server_port == 80 else ())}

    def handle_error(self, request: Any, client_address: Any) -> None:
        """A browser that closes a connection is no fault."""


class Handler(http_server.BaseHTTPRequestHandler):
    """Answers GET of the page and of its content."""

    protocol_version, server_version, sys_version, timeout = "HTTP/1.1", "vibcli", "", IDLE
    server: Server

    def do_GET(self) -> None:
        origin = self.headers.get("Origin")
        hosts = self.headers.get_all("Host") or []
        if len(hosts) != 1 or hosts[0] not in self.server.hosts or (
                origin is not None and origin.removeprefix("http://") not in self.server.hosts):
            self._answer(403, "text/plain", "this page is for the machine that it runs on")
            return
        path, _, query = self.path.partition("?")
        if path == "/":
            state = self.server.shown.state
            self._answer(200, "text/html", page(state, self.server.nonce))
        elif path == "/content":
            version = query.removeprefix("after=")
            state = self.server.shown.after(int(version) if version.isdecimal() and len(version) < 16 else -1, LONGEST)
            self._answer(200, "application/json", json.dumps(state._asdict()))
        else:
            self._answer(404, "text/plain", "there is nothing here")

    def _answer(self, status: int, kind: str, text: str) -> None:
        data = text.encode("utf-8", "replace")
        self.send_response(status)
        policy = (f"{POLICY}; script-src 'nonce-{self.server.nonce}'; connect-src 'self'; base-uri 'none'; "
                  "form-action 'none'; frame-ancestors 'none'")
        for name, value in (("Content-Type", f"{kind}; charset=utf-8"), ("Content-Length", str(len(data))),
                            ("Cache-Control", "no-store"), ("Content-Security-Policy", policy),
                            ("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer"),
                            ("Cross-Origin-Resource-Policy", "same-origin")):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, format: str, *args: Any) -> None:
        """Nothing is told of requests."""


@contextmanager
def serving(shown: Shown, port: int) -> Iterator[str]:
    """The address of the page, which is served within; a usage error where the port is taken."""
    try:
        server = Server(shown, port)
    except OSError as error:
        raise click.UsageError(f"--port {port} cannot be had: {(error.strerror or str(error)).lower()}") from None
    thread = Thread(target=server.serve_forever, args=(POLL,), daemon=True)
    thread.start()
    try:
        yield f"http://{HOST}:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()
