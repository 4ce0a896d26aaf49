"""Campaigns: the same results in the same order wherever they run, whoever dies."""

import multiprocessing
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import dask.config
import pool_tasks as tasks
import pytest
from distributed import LocalCluster
from small_suite import BIT, CANARIES, CODED, ECHOES, WORDS, adapter

from clers.oracle.pool.local import AHEAD, DEATHS, TRIES, by_processes
from clers.oracle.pool.place import Cluster, Local, Lost, Place
from clers.oracle.pool.spread import obstacle, spread
from clers.oracle.runs.events import Came, Sang
from clers.oracle.runs.run import Plan, run

NUMBERS = range(20)
DOUBLED = [2 * number for number in NUMBERS]
TWICE_AND_THRICE = [times * number for number in NUMBERS for times in (2, 3)]


@pytest.fixture(scope="module")
def cluster() -> Iterator[Place]:
    """Two workers; all that makes the death of one slow to be seen is made quick."""
    quick = dask.config.set(
        {
            "distributed.scheduler.allowed-failures": 1,
            "distributed.comm.timeouts.connect": "1s",
            "distributed.comm.retry.count": 0,
        }
    )
    with (
        quick,
        LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            dashboard_address=None,
            memory_limit=0,
            silence_logs="CRITICAL",
        ) as local,
    ):
        yield Cluster(local.scheduler_address)


def eventually(path: Path) -> bool:
    deadline = time.monotonic() + 20
    while not path.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    return path.exists()


@pytest.mark.parametrize("workers", [1, 2, 3])
def test_the_results_of_one_process(workers: int) -> None:
    """ORCL-POOL-1."""
    assert list(spread(tasks.double, NUMBERS, Local(workers))) == DOUBLED
    assert list(spread(tasks.double, (), Local(workers))) == []


def test_one_worker_is_this_process_and_two_are_not() -> None:
    """ORCL-POOL-1."""
    assert {*spread(tasks.who, NUMBERS, Local(1))} == {os.getpid()}
    assert len({*spread(tasks.who, NUMBERS, Local(2))} - {os.getpid()}) == 2


def test_the_order_is_that_of_the_items() -> None:
    """ORCL-POOL-1: though the first is done last."""
    assert list(spread(tasks.late_first, NUMBERS, Local(2))) == list(NUMBERS)


def test_items_are_taken_as_they_are_needed() -> None:
    """ORCL-POOL-1: an endless campaign can be asked for its first results."""
    taken: list[int] = []

    def endless() -> Iterator[int]:
        number = 0
        while True:
            taken.append(number)
            yield number
            number += 1

    campaign = spread(tasks.double, endless(), Local(2))
    assert [next(campaign) for _ in range(3)] == [0, 2, 4]
    campaign.close()
    assert len(taken) <= 2 * AHEAD + 3


@pytest.mark.parametrize("workers", [1, 2])
def test_many_results_of_an_item_or_none(workers: int) -> None:
    """ORCL-POOL-1."""
    expected = [number for number in NUMBERS if number % 2 == 0 for _ in range(3)]
    assert list(spread(tasks.nothing_for_odd_ones, NUMBERS, Local(workers))) == expected


@pytest.mark.parametrize("workers", [1, 2])
def test_results_come_before_the_item_is_done(workers: int) -> None:
    """ORCL-POOL-1: the first of two that is followed by a minute of nothing."""
    campaign = spread(tasks.lingers, ["/nonexistent"], Local(workers))
    assert next(campaign) == "/nonexistent"
    campaign.close()


@pytest.mark.parametrize("workers", [1, 2])
def test_what_a_task_raises_is_raised_in_its_turn(workers: int) -> None:
    """ORCL-POOL-1."""
    campaign = spread(tasks.odd_ones_raise, NUMBERS, Local(workers))
    assert [next(campaign) for _ in range(3)] == [0, 0, 1]
    with pytest.raises(ValueError, match="1 is odd"):
        next(campaign)


def test_a_death_loses_nothing(tmp_path: Path) -> None:
    """ORCL-POOL-2: and what was given before comes once."""
    mark = str(tmp_path / "died")
    items = [(number, mark) for number in NUMBERS]
    assert list(spread(tasks.dies_once, items, Local(2))) == TWICE_AND_THRICE
    assert Path(mark).exists()


def test_an_item_that_kills_is_given_up() -> None:
    """ORCL-POOL-2: it alone."""
    lost = Lost("3 workers ended over it, the last with code -9")
    expected = [lost if number == 7 else 2 * number for number in NUMBERS]
    assert list(spread(tasks.fatal_seven, NUMBERS, Local(2))) == expected


def test_a_campaign_without_survivors_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-POOL-2: after so many deaths nothing is tried any more."""
    assert (TRIES, DEATHS) == (3, 20)
    monkeypatch.setattr("clers.oracle.pool.local.DEATHS", 5)
    found = list(by_processes(tasks.dies_at_once, range(100), 2))
    assert len(found) == 100
    untried = Lost("not tried: 5 workers have ended")
    lost = Lost("3 workers ended over it, the last with code -9")
    assert {*found} == {lost, untried}
    assert 1 <= found.count(lost) <= 2
    assert found[-1] == untried


def test_closing_a_campaign_ends_its_workers(tmp_path: Path) -> None:
    """ORCL-POOL-4: and lets them end what they have started, wherever they are."""
    before = {*multiprocessing.active_children()}
    marks = [str(tmp_path / "one"), str(tmp_path / "other")]
    campaign = spread(tasks.waits, marks, Local(2))
    assert next(campaign) == marks[0] * 1000
    assert all(map(eventually, map(Path, marks)))
    campaign.close()
    assert all(Path(f"{mark}.ended").exists() for mark in marks)
    assert {*multiprocessing.active_children()} <= before


def test_a_cluster_gives_the_same_results(cluster: Place) -> None:
    """Clauses: ORCL-POOL-1, ORCL-POOL-3: more items than the cluster gets at a time."""
    assert obstacle(cluster) == ""
    numbers = range(150)
    expected = [2 * number for number in numbers]
    assert list(spread(tasks.double, numbers, cluster)) == expected
    assert list(spread(tasks.late_first, NUMBERS, cluster)) == list(NUMBERS)


def test_the_death_of_a_worker_of_a_cluster(cluster: Place, tmp_path: Path) -> None:
    """Clauses: ORCL-POOL-2, ORCL-POOL-3: an item that kills is given up, those beside it not."""
    mark = str(tmp_path / "died")
    items = [(number, mark) for number in NUMBERS]
    assert list(spread(tasks.dies_once, items, cluster)) == TWICE_AND_THRICE
    assert Path(mark).exists()
    *before, lost, last = spread(tasks.fatal_seven, range(9), cluster)
    assert (before, last) == (DOUBLED[:7], 16)
    assert isinstance(lost, Lost)
    assert "2 different workers" in lost.why


def test_what_a_task_raises_on_a_cluster(cluster: Place) -> None:
    """ORCL-POOL-1."""
    campaign = spread(tasks.odd_ones_raise, NUMBERS, cluster)
    assert [next(campaign) for _ in range(2)] == [0, 0]
    with pytest.raises(ValueError, match="1 is odd"):
        next(campaign)


def test_a_run_on_a_cluster(cluster: Place) -> None:
    """Clauses: ORCL-POOL-1, ORCL-POOL-3, ORCL-CHECK-1: it is the run of one process."""
    who = adapter(BIT)
    cases = (*ECHOES, *WORDS, *CODED)
    here, there = (list(run(Plan(who, place), cases, CANARIES)) for place in (Local(1), cluster))
    assert there == here
    assert {type(event) for event in here} == {Came, Sang}


def test_no_scheduler_and_no_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-POOL-3."""
    assert obstacle(Local(3)) == ""
    monkeypatch.setattr("clers.oracle.pool.cluster.PATIENCE", 0.3)
    assert obstacle(Cluster("tcp://127.0.0.1:1")).startswith("no scheduler answers at tcp://")
    assert obstacle(Cluster("nonsense://x")).startswith("no scheduler answers at nonsense://x")
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert "pip install 'clers[cluster]'" in obstacle(Cluster("tcp://127.0.0.1:1"))
