"""Files of rows, with which a stopped survey can be continued."""

from __future__ import annotations

import csv
import io
import json
import os
from typing import Any, Callable, Dict, List, Optional, Set

try:
    import fcntl
except ImportError:  # on Windows; files are not locked there
    fcntl = None  # type: ignore[assignment]

Row = Dict[str, Any]

#: the columns; sizes are those of `Loops.table`, the smallest first
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

_locks: Set[int] = set()


def _locked(path: str) -> int:
    """A handle of a file that only this process writes; -1 if there are no locks."""
    if fcntl is None:
        return -1
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        is_free = os.path.samestat(os.fstat(handle), os.stat(path))  # or else it was replaced
    except BlockingIOError:
        is_free = False
    except OSError:  # a file system without locks
        is_free = True
    if not is_free:
        os.close(handle)
        raise BlockingIOError(f"another survey is writing {path}")
    _locks.add(handle)
    return handle


def _unlock(handle: int) -> None:
    if handle in _locks:
        _locks.remove(handle)
        os.close(handle)


def _leave_to_parent() -> None:
    """A forked process can outlive the survey, and must not hold its file."""
    for handle in list(_locks):
        _unlock(handle)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_to_parent)


class Table:
    """A file of rows, one line each; an incomplete last line is dropped."""

    def __init__(self, path: Optional[str], is_dropped: Optional[Callable[[Row], bool]]):
        """Without a path, no file. Rows for which ``is_dropped`` holds are removed; all rows if it is None."""
        self.rows: List[Row] = []
        self._path = path
        self._is_dropped = is_dropped
        self._file: Any = None
        self._lock = -1

    def parsed(self, text: str) -> List[Row]:
        raise NotImplementedError

    def line(self, row: Row) -> str:
        raise NotImplementedError

    def header(self) -> str:
        return ""

    def __enter__(self) -> "Table":
        if self._path is not None:
            self._lock = _locked(self._path)
            try:
                self._take_over(self._path)
                self._file = self._opened(self._path, "a")
                if self._file.tell() == 0:
                    self._file.write(self.header())
            except BaseException:
                self._release()
                raise
        return self

    def add(self, row: Row) -> None:
        if self._file is not None:
            self._file.write(self.line(row))
            self._file.flush()

    def __exit__(self, *reason: Any) -> None:
        try:
            if self._file is not None:
                self._file.close()
                self.finish(reason[0] is None)
        finally:
            self._release()

    def finish(self, is_whole: bool) -> None:
        pass

    def _release(self) -> None:
        _unlock(self._lock)

    def _opened(self, path: str, mode: str) -> Any:
        return open(path, mode, encoding="utf-8", errors="surrogateescape", newline="")

    def _take_over(self, path: str) -> None:
        if not os.path.exists(path):
            return
        if self._is_dropped is None:
            os.truncate(path, 0)
            return
        rows = self._read(path)
        self.rows = [row for row in rows if not self._is_dropped(row)]
        if len(self.rows) < len(rows):
            self._replace(path)

    def _read(self, path: str) -> List[Row]:
        with open(path, "rb") as file:
            content = file.read()
        whole = content[: content.rfind(b"\n") + 1]
        rest = content[len(whole) :].decode("utf-8", "surrogateescape")
        text = whole.decode("utf-8", "surrogateescape")
        expected = self.header() or '{"mesh": '
        if not text and not (expected.startswith(rest) or rest.startswith(expected)):
            raise ValueError(f"{path} is not a table of survey()")
        try:
            rows = self.parsed(text)
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{path} is not a table of survey()") from error
        if rest:
            os.truncate(path, len(whole))
        return rows

    def _replace(self, path: str) -> None:
        """In one step, so that nothing is lost, and without releasing the lock."""
        new = path + ".new"
        lock = _locked(new)
        with self._opened(new, "w") as file:
            file.write(self.header())
            file.writelines(map(self.line, self.rows))
        os.replace(new, path)
        self._release()
        self._lock = lock


class _Jsonl(Table):
    def parsed(self, text: str) -> List[Row]:
        rows = [json.loads(line) for line in text.split("\n") if line]
        for row in rows:
            row["mesh"]  # every row has it
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


class _Csv(Table):
    def header(self) -> str:
        return ",".join(COLUMNS) + "\n"

    def parsed(self, text: str) -> List[Row]:
        if text and not text.startswith(self.header()):
            raise ValueError("another header")
        csv.field_size_limit(max(csv.field_size_limit(), len(text)))  # a row of genus 10,000 is long
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
    """Written at the end; until then, rows are kept as lines of JSON beside it."""

    def __init__(self, path: str, is_dropped: Optional[Callable[[Row], bool]]):
        import pyarrow  # noqa: F401  fails at once if it is missing

        self._parquet = path
        self._lines = path + ".jsonl"
        super().__init__(self._lines, is_dropped)

    def finish(self, is_whole: bool) -> None:
        if is_whole:
            import pyarrow
            import pyarrow.parquet

            with open(self._lines, encoding="utf-8") as file:
                rows = self.parsed(file.read())
            pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), self._parquet)


def table(out: Any, is_dropped: Optional[Callable[[Row], bool]]) -> Table:
    if out is None:
        return Table(None, None)
    path = os.fsdecode(out)
    kinds = {".csv": _Csv, ".jsonl": _Jsonl, ".parquet": _Parquet}
    extension = os.path.splitext(path)[1].lower()
    if extension not in kinds:
        raise ValueError(f"out must end in .csv, .jsonl or .parquet, not {path!r}")
    return kinds[extension](path, is_dropped)
