"""Parts of a grid by workers of dask.distributed, which run in threads: the same as by one process."""

import pytest

from vibcli.api.source import problem_of, text_source
from vibcli.cli.workers import workers
from vibcli.homework.document import SceneDocument
from vibcli.homework.parts import solve_in_parts

distributed = pytest.importorskip("distributed", reason="no dask.distributed here: make peers")
SCENE = """title: A block
question: A block {m} on a spring {k} and a damper {c}.
parameters: {m: 2 kg, k: 800 N/m, c: 8 N*s/m}
bodies: {block: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, block]}}
dampers: {d: {c: c, between: [ground, block]}}
variants:
  parameters: {m: {from: 1.2 kg, to: 3.2 kg, step: 0.1 kg}, k: [620 N/m, 820 N/m, 1.1 kN/m]}
  ask: {"omega_d[1]": rad/s, "zeta[1]": }
"""


def read():
    source = text_source(SCENE)
    return problem_of(source), SceneDocument.of(source.node, source.file, None)


def test_a_cluster_of_threads_finds_the_same():
    one = solve_in_parts(*read(), size=10)
    with distributed.LocalCluster(n_workers=1, threads_per_worker=3, processes=False, protocol="tcp",
                                  dashboard_address=None) as cluster, workers(1, cluster.scheduler_address) as executor:
        other = solve_in_parts(*read(), executor=executor, size=10)
    assert [(each.place, each.keys) for each in one.accepted] == [(each.place, each.keys) for each in other.accepted]
    assert [each[:1] + each[2:] for each in one.rejected] == [each[:1] + each[2:] for each in other.rejected]
    assert len(one.accepted) > 40
