"""The commands that the manual tells are those that its script calls."""

import pathlib
import re

ROOT = pathlib.Path(__file__).parent.parent.parent


def test_the_script_of_the_journeys_calls_the_commands_of_the_manual():
    manual = (ROOT / "doc/Handle_tunnel_loops/Journeys.txt").read_text(encoding="utf-8")
    script = (ROOT / "scripts/make_journeys.sh").read_text(encoding="utf-8").splitlines()
    called = {line.split(" || ")[0] for line in script}
    told = re.findall(r"^htloops [a-z].*", manual, re.MULTILINE)
    assert len(told) >= 8
    assert [command for command in told if command not in called] == []
