"""What is in the guides of the manual: commands, and programs in Python."""

import pathlib
import re

ROOT = pathlib.Path(__file__).parent.parent.parent
DATA = ROOT / "examples/Handle_tunnel_loops/data"
GUIDES = sorted((ROOT / "doc/Handle_tunnel_loops/guides").glob("*.txt"))


def commands_of(guide):
    """Its lines that call the tool, with the exit code that they announce: `# exit code 4`."""
    for block in re.findall(r"<pre>\n(.*?)</pre>", guide.read_text(encoding="utf-8"), re.DOTALL):
        for line in block.splitlines():
            if line.startswith("htloops "):
                code = re.search(r"# exit code (\d+)", line)
                yield line, int(code.group(1)) if code else 0


def programs_of(guide):
    """Its blocks of Python, in their order, as one program."""
    return "\n".join(re.findall(r"\\code\{\.py\}\n(.*?)\\endcode", guide.read_text(encoding="utf-8"), re.DOTALL))
