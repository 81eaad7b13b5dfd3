"""What is in the guides of the manual: commands, and programs in Python."""

import pathlib
import re

ROOT = pathlib.Path(__file__).parent.parent.parent
DATA = ROOT / "examples/Handle_tunnel_loops/data"
GUIDES = sorted((ROOT / "doc/Handle_tunnel_loops/guides").glob("*.txt"))


BLOCKS = re.compile(r"<pre>\n(?P<lines>.*?)</pre>|\\code\{\.py\}\n(?P<program>.*?)\\endcode", re.DOTALL)


class Step:
    """Commands of the tool, or a program in Python, and the lines that the guide shows below them."""

    def __init__(self, commands, program):
        self.commands = commands  # with the exit code that each announces: `# exit code 4`
        self.program = program
        self.shown = []


def steps_of(guide):
    """What the reader of a guide does, in order. What follows commands for another program is not theirs to check."""
    steps = []
    for block in BLOCKS.finditer(guide.read_text(encoding="utf-8")):
        lines = (block["lines"] or "").splitlines()
        if block["program"] or any(line.startswith(("htloops ", "$ ", "  htloops ")) for line in lines):
            steps.append(Step(list(commands_in(lines)), block["program"] or ""))
        elif steps:
            steps[-1].shown += lines
    return [step for step in steps if step.commands or step.program]


def commands_in(lines):
    for line in lines:
        if line.startswith("htloops "):
            code = re.search(r"# exit code (\d+)", line)
            yield line, int(code.group(1)) if code else 0


def first_line_not_in(shown, text):
    """The first of the lines shown that does not come, in their order, in the text; `...` stands for any lines."""
    found = iter([without_times(line) for line in text.splitlines()])
    for line in shown:
        if line.strip() and line.strip() != "..." and without_times(line) not in found:
            return line
    return None


def without_times(line):
    """The words of a line, without what differs from run to run: seconds, and how many threads there are."""
    line = re.sub(r"\d+\.\d\d s\b|(?<=  )\d+\.\d\d$", "TIME", line.replace("&amp;", "&").replace("&lt;", "<").replace("&gt;", ">"))
    return re.sub(r"\d+ threads?\b", "THREADS", line).split()
