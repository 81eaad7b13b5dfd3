"""A table of many meshes."""

from __future__ import annotations

import concurrent.futures as futures_of_python
import contextlib
import csv
import io
import itertools
import json
import os
import sys
import time
from typing import Any, Callable, Dict, Generator, Iterable, Iterator, List, Optional, Set, Union

from . import _core
from ._loops import loops
from ._progress import told
from ._sources import read

Path = Union[str, "os.PathLike[str]"]
Row = Dict[str, Any]

#: what is known of each mesh; sizes are those of `Loops.table`, the smallest first
COLUMNS = [
    "mesh",
    "vertices",
    "faces",
    "components",
    "boundaries",
    "genus",
    "sizes",
    "handle_length",
    "tunnel_length",
    "read_seconds",
    "seconds",
    "error",
]

# Enough to keep any cluster busy, few enough to keep in mind.
_most_in_flight = 1000


def survey(
    paths: Iterable[Path],
    out: Optional[Path] = None,
    executor: Any = None,
    *,
    resume: bool = True,
    timeout: Optional[float] = None,
    memory: Optional[int] = None,
    threads: int = 1,
    basis: str = "pure",
    triangulate: bool = False,
    repair: bool = False,
    progress: Any = None,
) -> List[Row]:
    """A row for each of many mesh files: genus, components, boundary, sizes of the handles, times, error.

    Parameters
    ----------
    paths : of .off, .obj, .ply or .stl
    out : a .csv, .jsonl or .parquet file (that needs pyarrow), to which each row is written as soon as it
        is known
    executor : who does the work: a `dask.distributed.Client`, or any `concurrent.futures.Executor`; this
        process, one mesh after the other, if not given
    resume : whether meshes that have a row in ``out`` are left out, so that a survey that was stopped can
        be called again
    timeout : seconds that a mesh may take
    memory : bytes of address space that a worker may have while it does a mesh, on Linux, as ``ulimit -v``
        counts them; some 2 * 10**8 are taken before it begins
    threads : of each mesh
    basis : as for `loops`
    triangulate, repair : as the options of ``htloops``
    progress : True for a bar, or a callable that is told a number from 0 to 1

    Returns the rows, in the order of the paths, those that were there before, too. A mesh that is none, or
    that takes too long or too much memory, costs its own row, which says why.
    """
    if isinstance(paths, (str, bytes)):
        raise TypeError("paths are several: a list of them")
    wanted = [os.fsdecode(path) for path in paths]
    table = _table(out, resume)
    rows = {row["mesh"]: row for row in table.rows}
    missing = [path for path in dict.fromkeys(wanted) if path not in rows]
    options = dict(
        timeout=timeout,
        memory=memory,
        threads=threads,
        basis=basis,
        triangulate=triangulate,
        repair=repair,
    )
    results = _results(missing, options, executor)
    with table, contextlib.closing(results), told(progress, "survey") as callback:
        for number, row in enumerate(results, 1):
            rows[row["mesh"]] = row
            table.add(row)
            if callback is not None and callback(number / len(missing)) is False:
                break
    return [rows[path] for path in wanted if path in rows]


def row_of(path: str, options: Dict[str, Any]) -> Row:
    """What is known of one mesh; never throws on account of the mesh."""
    row: Row = dict.fromkeys(COLUMNS)
    row["mesh"] = path
    start = time.monotonic()
    limit = options["timeout"]
    in_time = None if limit is None else lambda _: time.monotonic() < start + limit
    try:
        with _memory_limit(options["memory"]):
            points, triangles = read(
                path,
                triangulate=options["triangulate"],
                repair=options["repair"],
                progress=in_time,
            )
            row["vertices"], row["faces"] = len(points), len(triangles)
            row["read_seconds"] = time.monotonic() - start
            answer = loops(
                points,
                triangles,
                options["basis"],
                options["threads"],
                progress=in_time,
            )
        row["components"] = answer.number_of_components
        row["boundaries"] = len(answer.boundaries)
        row["genus"] = answer.genus
        row["sizes"] = answer.table()["size"].tolist()
        row["handle_length"] = sum(loop.length for loop in answer.handles)
        row["tunnel_length"] = sum(loop.length for loop in answer.tunnels)
    except _core.Interrupted:
        row["error"] = f"it takes longer than {options['timeout']:g} s"
    except MemoryError:
        row["error"] = f"it takes more memory than there is, or than {options['memory']} bytes"
    except Exception as error:  # whatever it is, the other meshes go on
        row["error"] = str(error) or type(error).__name__
    row["seconds"] = time.monotonic() - start
    return row


@contextlib.contextmanager
def _memory_limit(size: Optional[int]) -> Iterator[None]:
    """Lets this process have no more address space."""
    if size is None or not sys.platform.startswith("linux"):
        yield
        return
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    limit = size if hard == resource.RLIM_INFINITY else min(size, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _results(
    paths: List[str], options: Dict[str, Any], executor: Any
) -> Generator[Row, None, None]:
    if executor is None:
        for path in paths:
            yield row_of(path, options)
        return
    submit, first_done = _way_to_submit(executor)
    waiting = iter(paths)
    in_flight = {submit(p, options): p for p in itertools.islice(waiting, _most_in_flight)}
    try:
        while in_flight:
            done = first_done(set(in_flight))
            # What is there is kept, even if something else has gone wrong.
            for future in sorted(done, key=lambda future: future.exception() is not None):
                path = in_flight[future]
                row = _row_of_future(future, path)
                del in_flight[future]
                yield row
            for path in itertools.islice(waiting, len(done)):
                in_flight[submit(path, options)] = path
    finally:
        for future in in_flight:
            future.cancel()


def _row_of_future(future: Any, path: str) -> Row:
    error = future.exception()
    if error is None:
        return future.result()
    if isinstance(error, futures_of_python.BrokenExecutor):
        raise error  # nothing more can be asked of it
    row: Row = dict.fromkeys(COLUMNS)
    row["mesh"] = path
    row["error"] = f"its worker ended: {error}"
    return row


def _way_to_submit(executor: Any) -> "tuple[Callable[..., Any], Callable[[Set[Any]], Set[Any]]]":
    if isinstance(executor, futures_of_python.Executor):
        return (
            lambda path, options: executor.submit(row_of, path, options),
            lambda futures: set(
                futures_of_python.wait(
                    futures, return_when=futures_of_python.FIRST_COMPLETED
                ).done
            ),
        )
    distributed = sys.modules.get("distributed")
    if distributed is None or not isinstance(executor, distributed.Client):
        raise TypeError("executor is a concurrent.futures.Executor or a dask.distributed.Client")
    # Dask gives a task whose worker has ended to another one.
    return (
        lambda path, options: executor.submit(row_of, path, options, pure=False),
        lambda futures: set(distributed.wait(futures, return_when="FIRST_COMPLETED").done),
    )


class _Table:
    """A file of rows, one line each; a last line that was not ended is dropped."""

    def __init__(self, path: Optional[str], resume: bool):
        self.rows: List[Row] = []
        self._path = path
        self._file: Any = None
        if path is not None and resume and os.path.exists(path):
            with open(path, "rb") as file:
                content = file.read()
            whole = content[: content.rfind(b"\n") + 1]
            rest = content[len(whole) :].decode("utf-8", "surrogateescape")
            text = whole.decode("utf-8", "surrogateescape")
            expected = self.header() or '{"mesh": '
            if not text and not (expected.startswith(rest) or rest.startswith(expected)):
                raise ValueError(f"{path} is no table of survey()")
            try:
                self.rows = self.parsed(text)
            except (KeyError, TypeError, ValueError) as error:
                raise ValueError(f"{path} is no table of survey()") from error
            if rest:
                with open(path, "rb+") as file:
                    file.truncate(len(whole))
        elif path is not None and os.path.exists(path):
            os.remove(path)

    def parsed(self, text: str) -> List[Row]:
        raise NotImplementedError

    def line(self, row: Row) -> str:
        raise NotImplementedError

    def header(self) -> str:
        return ""

    def __enter__(self) -> "_Table":
        if self._path is not None:
            self._file = open(
                self._path, "a", encoding="utf-8", errors="surrogateescape", newline=""
            )
            if self._file.tell() == 0:
                self._file.write(self.header())
        return self

    def add(self, row: Row) -> None:
        if self._file is not None:
            self._file.write(self.line(row))
            self._file.flush()

    def __exit__(self, *_: Any) -> None:
        if self._file is not None:
            self._file.close()


class _Jsonl(_Table):
    def parsed(self, text: str) -> List[Row]:
        rows = [json.loads(line) for line in text.split("\n") if line]
        for row in rows:
            row["mesh"]  # or else it is none
        return rows

    def line(self, row: Row) -> str:
        return json.dumps(row) + "\n"


_numbers = {
    "vertices": int,
    "faces": int,
    "components": int,
    "boundaries": int,
    "genus": int,
    "handle_length": float,
    "tunnel_length": float,
    "read_seconds": float,
    "seconds": float,
}


class _Csv(_Table):
    def header(self) -> str:
        return ",".join(COLUMNS) + "\n"

    def parsed(self, text: str) -> List[Row]:
        if text and not text.startswith(self.header()):
            raise ValueError("another header")
        csv.field_size_limit(max(csv.field_size_limit(), len(text)))  # of genus 10,000 one is long
        rows: List[Row] = []
        for cells in csv.DictReader(io.StringIO(text, newline="")):
            row: Row = {name: cells[name] or None for name in COLUMNS}
            for name, number in _numbers.items():
                row[name] = None if row[name] is None else number(row[name])
            if row["genus"] is not None:
                row["sizes"] = [float(size) for size in cells["sizes"].split()]
            rows.append(row)
        return rows

    def line(self, row: Row) -> str:
        cells = dict(row, sizes=" ".join(map(repr, row["sizes"] or [])))
        if row["error"] is not None:
            cells["error"] = " ".join(row["error"].split())  # a row is a line
        text = io.StringIO()
        csv.DictWriter(text, COLUMNS, lineterminator="\n").writerow(cells)
        return text.getvalue()


class _Parquet(_Jsonl):
    """Kept as lines of JSON beside it until it is whole."""

    def __init__(self, path: str, resume: bool):
        import pyarrow  # noqa: F401  says at once that it is missing

        self._parquet = path
        super().__init__(path + ".jsonl", resume)

    def __exit__(self, *reason: Any) -> None:
        super().__exit__(*reason)
        if reason[0] is None:
            import pyarrow
            import pyarrow.parquet

            with open(self._path or "", encoding="utf-8") as file:
                rows = self.parsed(file.read())
            pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), self._parquet)


def _table(out: Optional[Path], resume: bool) -> _Table:
    if out is None:
        return _Table(None, False)
    path = os.fspath(out)
    kinds = {".csv": _Csv, ".jsonl": _Jsonl, ".parquet": _Parquet}
    extension = os.path.splitext(path)[1].lower()
    if extension not in kinds:
        raise ValueError(f"out ends in .csv, .jsonl or .parquet, not {path!r}")
    return kinds[extension](path, resume)
