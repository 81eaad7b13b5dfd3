#!/usr/bin/env bash
# Shows what the pages of the tool look like: loops, removal and skeletons of 12 meshes and an answer
# without loops, in a large, a small and a narrow window, light and dark, all on one sheet. For who changes the
# pages, not for users. Builds htloops first, unless HTLOOPS names one; needs Chromium, Python, or PYTHON, with
# Pillow, and what scripts/install_dependencies.sh web_tests installs, or HTL_NODE_MODULES names.
#
#   scripts/make_contact_sheet.sh [OPTION...] OUT [FOLDER]
#
#   --only KIND       loops, removal, skeleton, reeb, measures, dry-run or empty, which is of a sphere
#   --mesh NAME       a kind that is generated, or a file of FOLDER without .off
#   --size WxH        of the window, in points; 400x800 is a phone, with fingers
#   --scheme SCHEME   light or dark
#   --click SELECTOR  what is clicked before the picture is taken, such as "#rows tr"
#   --height PIXELS   of a picture on the sheet, 260 by default
#   --colours N       of the sheet, for a smaller file
#
# All but the last two can be given several times. Writes OUT/sheet.png, the
# pictures in full size in OUT/shots, the pages, and what browsers complained of. Meshes stay in OUT, and are not
# made again. Those that FOLDER does not have are named and left out.
set -euo pipefail
cd "$(dirname "$0")/.."

export HTL_NODE_MODULES="${HTL_NODE_MODULES:-$PWD/build/web_tests/node_modules}"
if [ ! -d "$HTL_NODE_MODULES/puppeteer-core" ]; then
  echo "There is no puppeteer-core in $HTL_NODE_MODULES: scripts/install_dependencies.sh web_tests" >&2
  exit 1
fi
if [ -z "${HTLOOPS:-}" ]; then
  scripts/build.sh htloops >/dev/null
  export HTLOOPS="$PWD/build/bin/htloops"
fi

exec node test/web/contact_sheet.mjs "$@"
