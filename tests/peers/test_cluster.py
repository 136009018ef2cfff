"""Parts of a grid by workers of dask.distributed, which run in threads: the same as by one process."""

import socket
from threading import Thread

import click
import pytest
from support.homework_scenes import EIGHTEEN

from vibcli.api.source import problem_of, text_source
from vibcli.cli.workers import workers
from vibcli.homework.document import SceneDocument
from vibcli.homework.parts import solve_in_parts

HELLOS = b"", b"HTTP/1.1 400 Bad Request\r\n\r\n"
distributed = pytest.importorskip("distributed", reason="no dask.distributed here: make peers")


def read():
    source = text_source(EIGHTEEN.replace("step: 0.4 kg", "step: 0.1 kg"))
    return problem_of(source), SceneDocument.of(source.node, source.file, None)


def test_a_cluster_of_threads_finds_the_same():
    one = solve_in_parts(*read(), size=10)
    with distributed.LocalCluster(n_workers=1, threads_per_worker=3, processes=False, protocol="tcp",
                                  dashboard_address=None) as cluster, workers(1, cluster.scheduler_address) as executor:
        other = solve_in_parts(*read(), executor=executor, size=10)
    assert [(each.place, each.keys) for each in one.accepted] == [(each.place, each.keys) for each in other.accepted]
    assert [each[:1] + each[2:] for each in one.rejected] == [each[:1] + each[2:] for each in other.rejected]
    assert len(one.accepted) > 40


@pytest.mark.parametrize("hello", HELLOS, ids=["silent", "another"])
def test_what_answers_as_no_scheduler_does_is_none(hello):
    callers = []

    def answer():
        while True:
            callers.append(server.accept()[0])
            callers[-1].sendall(hello)

    with socket.create_server(("127.0.0.1", 0)) as server:
        Thread(target=answer, daemon=True).start()
        with pytest.raises(click.UsageError, match="no cluster answers at"), workers(
                1, f"tcp://127.0.0.1:{server.getsockname()[1]}"):
            pass
    assert len(callers) == 2
