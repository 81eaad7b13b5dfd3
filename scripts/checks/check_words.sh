#!/usr/bin/env bash
# How many words the manual has, and whether they say all that they have to: see check_words.py.
set -euo pipefail
exec python3 "$(dirname "$0")/check_words.py"
