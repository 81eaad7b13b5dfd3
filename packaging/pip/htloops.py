"""The command htloops: runs the program in the package handle_tunnel_loops, without importing the package."""

import os
import subprocess
import sys


def program():
    name = "htloops.exe" if os.name == "nt" else "htloops"
    return os.path.join(os.path.dirname(os.path.abspath(__file__)), "handle_tunnel_loops", "bin", name)


def main():
    command = [program(), *sys.argv[1:]]
    if os.name == "nt":
        sys.exit(subprocess.run(command).returncode)
    os.execv(command[0], command)


if __name__ == "__main__":
    main()
