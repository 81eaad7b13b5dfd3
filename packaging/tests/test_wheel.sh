#!/usr/bin/env bash
# Makes a source archive, and of it a wheel; installs that in an empty environment, and uses it from an empty
# folder: the command, and the tests of the module.
#
#   packaging/tests/test_wheel.sh PYTHON FOLDER [WHEEL]
#
# FOLDER is made anew; a WHEEL that is there already is tried in its place.
set -euo pipefail

python=$1 folder=$2 wheel=${3:-}
source=$(cd "$(dirname "$0")/../.." && pwd)
version=$(<"$source/VERSION")
for module in pip setuptools wheel venv ensurepip numpy pytest; do
  "$python" -c "import $module" 2>/dev/null || { echo "SKIPPED: $python has no $module" && exit 77; }
done
rm -rf "$folder"
mkdir -p "$folder/empty"
folder=$(cd "$folder" && pwd)

if [ -z "$wheel" ]; then
  "$source/scripts/make_wheel.sh" "$python" "$folder/made"
  wheel=$(echo "$folder"/made/*.whl)
fi
tag=$("$python" -c 'import sys, sysconfig
print("cp%d%d" % sys.version_info[:2], sysconfig.get_platform().replace("-", "_").replace(".", "_"))')
expected=handle_tunnel_loops-$version-${tag% *}-${tag% *}-${tag#* }.whl
[ "$(basename "$wheel")" = "$expected" ] || { echo "The wheel is $wheel, not $expected" >&2; exit 1; }

# NumPy and pytest are those of the system.
"$python" -m venv --system-site-packages "$folder/environment"
cd "$folder/empty"
unset PYTHONPATH PYTHONHOME LD_LIBRARY_PATH
environment=$folder/environment/bin
"$environment/pip" install --quiet --no-index --no-deps "$wheel"

installed=$(echo "$folder"/environment/lib/python*/site-packages/handle_tunnel_loops)
for licence in LICENSE NOTICES; do
  [ -s "$installed-$version.dist-info/$licence" ] || { echo "The wheel lacks $licence" >&2; exit 1; }
done

# What is loaded lies in the environment, or is what every system has.
strangers=$(ldd "$installed/bin/htloops" "$installed"/_core*.so | awk '$2 == "=>" { print $3 }' |
  grep -vE "^$installed/|/(lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s)\.so\.[0-9]+)$" | sort -u || true)
[ -z "$strangers" ] || { echo "The wheel needs what it does not bring: $strangers" >&2; exit 1; }

"$environment/htloops" --version | grep -F "htloops $version,"
"$environment/htloops" generate multi-torus --genus 3 --faces 4000 -o mesh.off
"$environment/htloops" loops mesh.off -o loops.json --picture loops.png
"$environment/htloops" check mesh.off loops.json
[ "$(head -c 4 loops.png | tail -c 3)" = PNG ] || { echo "There is no picture" >&2; exit 1; }
"$environment/htloops" loops absent.off && status=0 || status=$?
[ "$status" -eq 3 ] || { echo "A file that is not there ends with $status, not 3" >&2; exit 1; }

HTLOOPS="$environment/htloops" PYTHONDONTWRITEBYTECODE=1 "$environment/python" -m pytest -q -p no:cacheprovider \
  "$source/python/tests"
"$environment/pip" uninstall --quiet --yes handle_tunnel_loops
left=$(find "$folder/environment" -path '*handle_tunnel_loops*' -o -name 'htloops*')
[ -z "$left" ] || { echo "Left when the wheel is removed: $left" >&2; exit 1; }
