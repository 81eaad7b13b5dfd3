"""A table of many meshes."""

from __future__ import annotations

import contextlib
import functools
import os
import sys
import time
from typing import Any, Dict, Iterable, Iterator, List, Optional, Union

from . import _core, _executors
from ._arguments import real_or_none, threads_of, whole, word
from ._loops import loops
from ._progress import told
from ._sources import read
from ._table import COLUMNS, Row, table

Path = Union[str, "os.PathLike[str]"]


def survey(
    paths: Iterable[Path],
    out: Optional[Path] = None,
    executor: Any = None,
    *,
    resume: bool = True,
    retry_errors: bool = False,
    timeout: Optional[float] = None,
    memory: Optional[int] = None,
    threads: Optional[int] = 1,
    basis: str = "pure",
    triangulate: bool = False,
    repair: bool = False,
    progress: Any = None,
) -> List[Row]:
    """Makes a table of many mesh files: genus, components, boundaries, sizes of the handles, times, errors.

    Parameters
    ----------
    paths : mesh files of any format that `read` reads
    out : a .csv or .jsonl file; each row is written as soon as it is computed. A .parquet file (needs pyarrow)
        is written at the end, from a .jsonl file beside it, which is kept. Two surveys cannot write one file
        at the same time (not checked on Windows)
    executor : a number of processes, a `dask.distributed.Client`, or any `concurrent.futures.Executor`. By
        default this process computes one mesh after the other. With a number of processes, a process that is
        killed, for example because memory runs out, is replaced and only its mesh fails; a script must then
        call survey() under ``if __name__ == "__main__":``
    resume : whether to skip meshes that have a row in ``out``, to continue a survey that was stopped
    retry_errors : whether to repeat those of them with an error; the new row replaces the old one
    timeout : the most seconds for one mesh, including reading and repair
    memory : the most bytes of address space of a worker during one mesh, as for ``ulimit -v``; Linux only.
        About 2 * 10**8 are used before the mesh is read. Workers must be processes, not threads
    threads : the number of threads for each mesh
    basis : as for `loops`
    triangulate, repair : as for `read`
    progress : True for a bar, or a callable that takes a number from 0 to 1

    Returns the rows in the order of the paths, including those already in ``out``. If a mesh is refused, or
    takes too much time or memory, only its own row fails, and ``error`` gives the reason.
    """
    if isinstance(paths, (str, bytes, os.PathLike)):
        raise TypeError(f"paths must be a list of paths, not a single path: [{paths!r}]")
    wanted = list(map(os.fsdecode, paths))
    compute = functools.partial(
        row_of,
        options=dict(
            timeout=real_or_none("timeout", timeout),
            memory=None if memory is None else whole("memory", memory, 1, 2**63 - 1),
            threads=threads_of(threads),
            basis=word("basis", basis, ("pure", "shortest")),
            triangulate=bool(triangulate),
            repair=bool(repair),
        ),
    )
    _executors.check(executor, memory is not None)
    again = set(wanted) if retry_errors else set()
    is_dropped = (lambda row: row["error"] and row["mesh"] in again) if resume else None
    with table(out, is_dropped) as kept, told(progress, "survey") as callback:
        rows = {row["mesh"]: row for row in kept.rows}
        missing = [path for path in dict.fromkeys(wanted) if path not in rows]
        with contextlib.closing(_executors.rows_of(missing, compute, executor)) as results:
            for number, row in enumerate(results, 1):
                rows[row["mesh"]] = row
                kept.add(row)
                if callback is not None and callback(number / len(missing)) is False:
                    break
    return [rows[path] for path in wanted if path in rows]


def row_of(path: str, options: Dict[str, Any]) -> Row:
    """The row of one mesh; never raises an error because of the mesh."""
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
        if limit is None:
            raise  # Python is about to exit
        row["error"] = f"it takes longer than {limit:g} s"
    except MemoryError:
        most = options["memory"]
        row["error"] = "it takes more memory than is available" + (f", or than {most} bytes" if most else "")
    except Exception as error:  # of any kind: the other meshes are computed
        row["error"] = str(error) or type(error).__name__
    row["seconds"] = time.monotonic() - start
    return row


@contextlib.contextmanager
def _memory_limit(size: Optional[int]) -> Iterator[None]:
    """Limits the address space of this process."""
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
