import json
import os
import pathlib
import subprocess
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).parent))


class Tool:
    """The tool, in a folder of its own."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, *words, code=0, **options):
        """Any exit code will do if none is given."""
        done = subprocess.run([os.environ["HTLOOPS"], *map(str, words)], cwd=self.folder, capture_output=True,
                              text=True, timeout=300, check=False, **options)
        assert code in (done.returncode, None), f"{words}: {done.returncode}\n{done.stdout}\n{done.stderr}"
        return done

    def facts(self, mesh, *options):
        """What `loops` says of a mesh, as JSON."""
        answer = self.folder / "facts.jsonl"
        self.run("loops", mesh, "--jsonl", answer, "-q", *options)
        return json.loads(answer.read_text())

    def as_off(self, mesh, *options):
        """The points and faces of a mesh, by way of OFF."""
        import mesh_files

        result = self.folder / "as.off"
        self.run("repair", mesh, "-o", result, "-q", *options)
        return mesh_files.read_off(result)


@pytest.fixture
def tool(tmp_path):
    if "HTLOOPS" not in os.environ:
        pytest.skip("HTLOOPS names no tool")
    return Tool(tmp_path)
