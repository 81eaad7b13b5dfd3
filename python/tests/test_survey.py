"""Tables of many meshes."""

import concurrent.futures
import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import threading

import pytest
from conftest import write_off

import handle_tunnel_loops as htl


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Twelve meshes of genus 0 to 3, one of which is none, and what is not there."""
    folder = tmp_path_factory.mktemp("meshes")
    for i in range(12):
        kind = "multi-torus" if i % 4 else "sphere"
        write_off(folder / f"{i:02}.off", *htl.generate(kind, faces=1500, genus=i % 4, seed=i))
    (folder / "05.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
    return folder


@pytest.fixture(scope="module")
def paths(folder):
    return [str(folder / f"{i:02}.off") for i in range(13)]


def check(rows, paths):
    assert [row["mesh"] for row in rows] == paths
    for i, row in enumerate(rows):
        if i in (5, 12):
            assert row["error"] and row["genus"] is None
        else:
            assert row["error"] is None and row["genus"] == i % 4 and row["components"] == 1
            assert len(row["sizes"]) == row["genus"] and row["sizes"] == sorted(row["sizes"])
            assert row["faces"] > 1000 and row["seconds"] > row["read_seconds"] > 0
            assert (row["handle_length"] > 0) == (row["genus"] > 0)


def without_times(rows):
    return [{key: row[key] for key in row if "seconds" not in key} for row in rows]


@pytest.mark.parametrize("extension", [".csv", ".jsonl"])
def test_files(paths, tmp_path, extension):
    out = tmp_path / ("table" + extension)
    rows = htl.survey(paths, out)
    check(rows, paths)
    written = out.read_text()
    assert htl.survey(paths, out) == rows and out.read_text() == written  # nothing is left to do
    # It was stopped while it wrote a line.
    lines = written.splitlines(keepends=True)
    out.write_text("".join(lines[:6]) + lines[6][:20])
    again = htl.survey(paths, out)
    assert without_times(again) == without_times(rows)
    assert len(out.read_text().splitlines()) == len(lines)
    check(htl.survey(paths, out, resume=False), paths)


def test_parquet(paths, tmp_path):
    if not _has_pyarrow():
        with pytest.raises(ImportError):
            htl.survey(paths, tmp_path / "a.parquet")
        pytest.skip("there is no pyarrow")
    import pyarrow.parquet

    rows = htl.survey(paths, tmp_path / "a.parquet")
    assert pyarrow.parquet.read_table(tmp_path / "a.parquet").to_pylist() == rows


def _has_pyarrow():
    try:
        import pyarrow  # noqa: F401
    except ImportError:
        return False
    return True


@pytest.mark.parametrize("name", ["a.csv", "a.jsonl"])
@pytest.mark.parametrize("text", ["name,value\na,1\nb,2", "precious", '{"a": 1}\n', "[1]\n"])
def test_files_of_others_are_left_alone(paths, tmp_path, name, text):
    (tmp_path / name).write_text(text)
    with pytest.raises(ValueError, match="not a table of survey"):
        htl.survey(paths, tmp_path / name)
    assert (tmp_path / name).read_text() == text


def test_odd_meshes_and_names(tmp_path):
    V, F = htl.generate("torus", faces=400)
    names = ["a,b.off", 'a"b.off', "a\nb.off", "a\u2028b.off"]
    for name in names:
        write_off(tmp_path / name, V, F)
    write_off(tmp_path / "point.off", 0 * V, F)
    paths = [str(tmp_path / name) for name in [*names, "point.off"]]
    for out in ("a.csv", "a.jsonl"):
        rows = htl.survey(paths, tmp_path / out)
        assert [row["genus"] for row in rows] == [1] * 5 and rows[-1]["sizes"] == [0]
        assert htl.survey(paths, tmp_path / out) == rows
    with pytest.raises(TypeError, match="a list of paths"):
        htl.survey("abc")
    for arguments, error in [
        (dict(executor=object()), TypeError),
        (dict(timeout="long"), TypeError),
        (dict(timeout=-1), ValueError),
        (dict(memory=0), ValueError),
        (dict(threads=-1), ValueError),
        (dict(basis="best"), ValueError),
    ]:
        with pytest.raises(error, match=next(iter(arguments))):
            htl.survey(paths, **arguments)


class Recording(concurrent.futures.ThreadPoolExecutor):
    def submit(self, *args, **kwargs):
        self.futures = getattr(self, "futures", [])
        self.futures.append(super().submit(*args, **kwargs))
        return self.futures[-1]


def test_what_is_stopped_is_not_computed(paths):
    with Recording(1) as executor:
        assert len(htl.survey(paths, executor=executor, progress=lambda fraction: False)) == 1
        assert sum(future.cancelled() for future in executor.futures) >= len(paths) - 4


def test_other_names_are_refused(paths):
    with pytest.raises(ValueError, match=".csv, .jsonl or .parquet"):
        htl.survey(paths, "table.txt")


def test_it_can_be_stopped(paths, tmp_path):
    told = []

    def stop(fraction):
        told.append(fraction)
        return len(told) < 3

    rows = htl.survey(paths, tmp_path / "a.csv", progress=stop)
    assert len(rows) == 3 and told[0] == pytest.approx(1 / 13)
    check(htl.survey(paths, tmp_path / "a.csv"), paths)


def test_time_is_limited(tmp_path):
    V, F = htl.generate("gyroid", faces=200000, genus=80)
    write_off(tmp_path / "large.off", V, F)
    (row,) = htl.survey([tmp_path / "large.off"], timeout=0.2)
    assert row["error"] == "it takes longer than 0.2 s" and row["seconds"] < 5


def address_space():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")


def test_memory_is_limited(tmp_path):
    if not os.path.exists("/proc/self/statm"):
        pytest.skip("there is no /proc")
    write_off(tmp_path / "small.off", *htl.generate("torus", faces=400))
    write_off(tmp_path / "large.off", *htl.generate("gyroid", faces=400000, genus=80))
    paths = [tmp_path / "small.off", tmp_path / "large.off", tmp_path / "small.off"]
    new = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=new) as executor:
        htl.survey(paths[:1], executor=executor)
        taken = executor.submit(address_space).result()
        small, large, _ = htl.survey(paths, executor=executor, memory=taken + 10**6)
        assert small["error"] is None and small["genus"] == 1
        assert large["error"].startswith("it takes more memory")
        (row,) = htl.survey(paths[1:2], executor=executor, memory=taken + 4 * 10**9)
        assert row["error"] is None and row["genus"] == 80


def test_memory_is_not_of_threads(paths):
    with concurrent.futures.ThreadPoolExecutor(2) as executor:
        with pytest.raises(ValueError, match="memory .* not threads"):
            htl.survey(paths, executor=executor, memory=10**10)


@pytest.fixture
def pipe(tmp_path):
    """A file from which nothing comes."""
    if not hasattr(os, "mkfifo"):
        pytest.skip("there are no named pipes")
    path = str(tmp_path / "pipe.off")
    os.mkfifo(path)
    return path


def test_time_is_limited_for_reading(paths, pipe):
    slow, quick = htl.survey([pipe, paths[1]], timeout=0.5)
    assert slow["error"] == "it takes longer than 0.5 s" and slow["seconds"] < 5
    assert quick["genus"] == 1
    os.close(os.open(pipe, os.O_WRONLY))  # so that its reader ends


def test_time_is_limited_for_repairing(tmp_path):
    V, F = htl.generate("gyroid", faces=200000, genus=80)
    write_off(tmp_path / "soup.off", V[F].reshape(-1, 3), range_of_faces(len(F)))
    (row,) = htl.survey([tmp_path / "soup.off"], repair=True)
    assert row["genus"] == 80
    (row,) = htl.survey([tmp_path / "soup.off"], repair=True, timeout=row["read_seconds"] / 2)
    assert row["error"].startswith("it takes longer than") and row["vertices"] is None


def range_of_faces(count):
    import numpy as np

    return np.arange(3 * count).reshape(-1, 3)


def kill_workers(pipe, times):
    """As the system does that has no memory left, when a worker has begun to read."""
    for _ in range(times):
        with open(pipe, "wb"):
            for child in multiprocessing.active_children():
                child.kill()  # if it is still there: its executor may have been faster
                child.join()


def test_a_killed_worker_costs_one_row(paths, pipe, tmp_path):
    killer = threading.Thread(target=kill_workers, args=(pipe, 2))  # it is tried again, alone
    killer.start()
    wanted = [*paths[:3], pipe, *paths[3:]]
    rows = htl.survey(wanted, tmp_path / "a.csv", executor=2)
    killer.join()
    assert rows[3]["error"].startswith("its worker process ended")
    check(rows[:3] + rows[4:], paths)
    assert htl.survey(wanted, tmp_path / "a.csv") == rows


def test_a_broken_executor_keeps_rows(paths, pipe, tmp_path):
    killer = threading.Thread(target=kill_workers, args=(pipe, 1))
    killer.start()
    wanted = [*paths[:5], pipe, *paths[5:]]
    new = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=new) as executor:
        with pytest.raises(concurrent.futures.BrokenExecutor, match=r"call survey\(\) again"):
            htl.survey(wanted, tmp_path / "a.jsonl", executor)
        with pytest.raises(concurrent.futures.BrokenExecutor, match="rows .* are kept"):
            htl.survey(wanted, tmp_path / "a.jsonl", executor)
    killer.join()
    assert len((tmp_path / "a.jsonl").read_text().splitlines()) == 5
    os.remove(pipe)
    shutil.copy(paths[1], pipe)
    rows = htl.survey(wanted, tmp_path / "a.jsonl", executor=1)
    assert rows[5]["genus"] == 1
    check(rows[:5] + rows[6:], paths)


def test_processes(paths):
    check(htl.survey(paths, executor=3), paths)
    for executor, error in [(0, ValueError), (True, TypeError), (2.5, TypeError)]:
        with pytest.raises(error, match="executor"):
            htl.survey(paths, executor=executor)


def test_scripts_are_told_what_they_lack(paths, tmp_path):
    (tmp_path / "script.py").write_text(
        f"import handle_tunnel_loops as htl\nhtl.survey([{paths[0]!r}], executor=1)\n"
    )
    child = subprocess.run([sys.executable, tmp_path / "script.py"], capture_output=True, text=True)
    assert child.returncode == 1 and '__name__ == "__main__"' in child.stderr.splitlines()[-1]


@pytest.mark.parametrize("name", ["a.csv", "a.jsonl"])
def test_one_survey_writes_a_file(paths, tmp_path, name, monkeypatch):
    pytest.importorskip("fcntl")
    out = tmp_path / name
    refusals = []

    def another(fraction):
        try:
            htl.survey(paths, out, resume=fraction < 0.5)
        except BlockingIOError as error:
            refusals.append(str(error))

    rows = htl.survey(paths, out, progress=another)
    check(rows, paths)
    assert refusals == [f"another survey is writing {out}"] * len(paths)
    assert htl.survey(paths, out) == rows
    monkeypatch.setattr("handle_tunnel_loops._table.fcntl", None)  # as on Windows
    assert htl.survey(paths, out) == rows


def test_workers_hold_no_file(paths, tmp_path):
    """They stay when the survey has ended."""
    try:
        fork = multiprocessing.get_context("fork")
    except ValueError:
        pytest.skip("nothing is forked here")
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=fork) as executor:
        htl.survey(paths[:4], tmp_path / "a.csv", executor)
        check(htl.survey(paths, tmp_path / "a.csv", executor), paths)


@pytest.mark.parametrize("name", ["a.csv", "a.jsonl"])
def test_errors_are_tried_again(paths, tmp_path, name):
    out = tmp_path / name
    wanted = [str(tmp_path / "1.off"), str(tmp_path / "2.off"), paths[1]]
    first = htl.survey(wanted, out)
    assert [row["genus"] for row in first] == [None, None, 1]
    for path in wanted[:2]:
        shutil.copy(paths[2], path)
    assert htl.survey(wanted, out) == first
    rows = htl.survey(wanted[:1], out, retry_errors=True)
    assert [row["genus"] for row in rows] == [2]
    rows = htl.survey(wanted, out)
    assert [row["genus"] for row in rows] == [2, None, 1]  # the other one was not asked for
    assert [row["genus"] for row in htl.survey(wanted, out, retry_errors=True)] == [2, 2, 1]
    assert len(out.read_text().splitlines()) == 3 + (name == "a.csv")
    assert sorted(os.listdir(tmp_path)) == ["1.off", "2.off", name]


def test_executors(paths):
    for kind in (concurrent.futures.ThreadPoolExecutor, concurrent.futures.ProcessPoolExecutor):
        with kind(2) as executor:
            check(htl.survey(paths, executor=executor), paths)


def test_dask_loses_nothing_with_a_worker(paths, tmp_path):
    distributed = pytest.importorskip("distributed")
    many = [str(path) for path in _many(tmp_path)]
    out = tmp_path / "table.csv"
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        workers = list(client.run(os.getpid).values())

        def end_the_first(fraction):
            if fraction > 0.2 and workers:
                os.kill(workers[0], signal.SIGKILL)
                workers.clear()

        rows = htl.survey(many, out, client, progress=end_the_first)
    assert not workers
    assert [row["mesh"] for row in rows] == many
    assert all(row["error"] is None and row["genus"] == 1 for row in rows)
    written = [line.split(",")[0] for line in out.read_text().splitlines()[1:]]
    assert sorted(written) == sorted(many)


def _many(folder):
    for i in range(60):
        path = folder / f"{i}.off"
        write_off(path, *htl.generate("torus", faces=3000, seed=i))
        yield path
