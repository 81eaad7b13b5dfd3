"""Progress, interruption, threads."""

import functools
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import write_off

import handle_tunnel_loops as htl
from handle_tunnel_loops import _core


@pytest.fixture(scope="module")
def large():
    return htl.generate("gyroid", faces=150000, genus=60)


def test_progress(large):
    fractions = []
    htl.loops(*large, progress=fractions.append)
    assert fractions and fractions[-1] == 1 and np.all(np.diff(fractions) >= 0)
    assert all(0 <= fraction <= 1 for fraction in fractions)


def test_progress_never_goes_back(large):
    V, F = large
    for call in (htl.reeb, htl.cut_to_disk, functools.partial(htl.remove_handles, genus=0), htl.dual_cuts):
        fractions = []
        call(V, F, progress=fractions.append)
        assert fractions[-1] == 1 and np.all(np.diff(fractions) >= 0), call


def test_a_bar(torus, capsys):
    htl.loops(*torus, progress=True)  # that of tqdm, if it is there


def test_false_stops(large):
    start = time.monotonic()
    with pytest.raises(htl.Interrupted):
        htl.loops(*large, progress=lambda fraction: False)
    assert time.monotonic() - start < 2


def test_errors_of_the_callable_come_through(large):
    with pytest.raises(ZeroDivisionError):
        htl.loops(*large, progress=lambda fraction: 1 / 0)


@pytest.mark.parametrize(
    "call",
    [
        "loops(V, F)",
        "reeb(V, F)",
        "cut_to_disk(V, F)",
        "remove_handles(V, F, genus=0)",
        "certify(V, F, L)",
        "html(V, F, L, os.devnull)",
        "repair(V, F)",
        "generate('gyroid', faces=3000000, genus=200)",
        "read('mesh.off')",
    ],
)
def test_ctrl_c(call, tmp_path):
    if os.name != "posix":
        pytest.skip("signals are those of POSIX")
    if call.startswith("read"):
        V, F = htl.generate("gyroid", faces=400000, genus=200)
        write_off(tmp_path / "mesh.off", V, F)
    program = f"""
import os, signal, handle_tunnel_loops as htl
signal.signal(signal.SIGINT, signal.default_int_handler)
os.chdir({str(tmp_path)!r})
V, F = htl.generate("gyroid", faces=400000, genus=200)
L = htl.loops(V, F) if "L" in "{call}" else None
print("ready", flush=True)
try:
    while True:
        htl.{call}
except KeyboardInterrupt:
    print("stopped", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout.readline() == "ready\n"
        time.sleep(0.3)
        start = time.monotonic()
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "stopped\n"
        assert time.monotonic() - start < 5
    assert child.returncode == 0


@pytest.mark.parametrize(
    "name, call",
    [
        ("loops", lambda V, F, L: htl.loops(V, F)),
        ("reeb", lambda V, F, L: htl.reeb(V, F)),
        ("cut_to_disk", lambda V, F, L: htl.cut_to_disk(V, F)),
        ("cut_edges", lambda V, F, L: htl.cut_edges(V, F)),
        ("dual_cuts", lambda V, F, L: htl.dual_cuts(V, F)),
        ("remove_handles", lambda V, F, L: htl.remove_handles(V, F, genus=0, loops=L)),
        ("certify", lambda V, F, L: htl.certify(V, F, L)),
        ("page", lambda V, F, L: htl.html(V, F, L, os.devnull)),
        ("repair", lambda V, F, L: htl.repair(V, F)),
        ("generate", lambda V, F, L: htl.generate("torus")),
        ("read", lambda V, F, L: htl.read(__file__)),
    ],
)
def test_ctrl_c_waits_for_nothing(torus, monkeypatch, name, call):
    """Not even for what looks at nothing until it is done."""
    if os.name != "posix":
        pytest.skip("signals are those of POSIX")
    L = htl.loops(*torus)
    is_done = threading.Event()

    def deaf(*arguments):
        os.kill(os.getpid(), signal.SIGINT)
        is_done.wait(30)

    monkeypatch.setattr(_core, name, deaf)
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        call(*torus, L)
    assert time.monotonic() - start < 5
    is_done.set()


@pytest.mark.parametrize("does_read", [True, False])
def test_what_is_stopped_ends(does_read):
    """It does not only go on unheard."""
    V, F = htl.generate("gyroid", faces=300000, genus=60)
    soup, faces = V[F].reshape(-1, 3), np.arange(3 * len(F)).reshape(-1, 3)
    if does_read:
        points, corners = (
            "\n".join(map(" ".join, rows.astype(str).tolist())) for rows in (soup, faces)
        )
        corners = "3 " + corners.replace("\n", "\n3 ")
        content = f"OFF\n{len(soup)} {len(faces)} 0\n{points}\n{corners}\n".encode()
        call = lambda watch: _core.read("a.off", content, True, True, watch)  # noqa: E731
    else:
        call = lambda watch: _core.repair(soup, [faces], watch)  # noqa: E731
    start = time.monotonic()
    call(_core.Watch())
    seconds = time.monotonic() - start
    watch = _core.Watch()
    stop = threading.Timer(seconds / 4, watch.stop)
    stop.start()
    with pytest.raises(htl.Interrupted):
        call(watch)
    stop.join()


def test_the_interpreter_may_end_meanwhile():
    program = """
import threading, time, handle_tunnel_loops as htl
V, F = htl.generate("gyroid", faces=200000, genus=100)
def forever():
    while True:
        htl.loops(V, F)
for _ in range(2):
    threading.Thread(target=forever, daemon=True).start()
time.sleep(0.5)
"""
    start = time.monotonic()
    child = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert child.returncode == 0 and "terminate" not in child.stderr, child.stderr
    assert time.monotonic() - start < 20


def test_other_threads_run(large):
    turns = 0
    is_done = threading.Event()

    def count():
        nonlocal turns
        while not is_done.is_set():
            turns += 1
            time.sleep(0.005)

    counter = threading.Thread(target=count)
    counter.start()
    start = time.monotonic()
    htl.loops(*large, threads=1)
    seconds = time.monotonic() - start
    is_done.set()
    counter.join()
    assert turns > seconds / 0.005 / 20


def test_several_threads_at_once():
    meshes = [htl.generate("multi-torus", faces=3000, genus=1 + i % 3, seed=i) for i in range(8)]
    expected = [htl.loops(*mesh).handles[0].points for mesh in meshes]
    found = [None] * len(meshes)

    def find(i):
        found[i] = htl.loops(*meshes[i]).handles[0].points

    threads = [threading.Thread(target=find, args=(i,)) for i in range(len(meshes))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(a, b) for a, b in zip(expected, found))


def memory():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_nothing_leaks():
    if not os.path.exists("/proc/self/statm"):
        pytest.skip("there is no /proc")
    V, F = htl.generate("torus", faces=400)
    calls = [
        lambda: htl.loops(V, F, threads=1),
        lambda: htl.reeb(V, F),
        lambda: htl.remove_handles(V, F, genus=0),
        lambda: htl.cut_to_disk(V, F),
        lambda: htl.repair(V, F),
        lambda: pytest.raises(ValueError, htl.loops, V, F[:, :2]),
        lambda: pytest.raises(htl.MeshError, htl.loops, V, F[:, ::-1][:1].repeat(2, axis=0)),
    ]
    for call in calls:
        for _ in range(50):
            call()
        assert any(growth(call) < 1e5 for _ in range(12)), call


def growth(call):
    """What is lost grows each time; what allocators keep for later does not."""
    before = memory()
    for _ in range(100):
        call()
    return memory() - before
