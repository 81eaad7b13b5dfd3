#!/usr/bin/env bash
# Makes a folder with the tests, the benchmark and the tool for CUDA devices, and all the shared
# libraries that they need but those of the C library and of the driver: to be copied to a machine
# that has a driver, a C library no older than that of this machine's libraries, and nothing else,
# and there started with its run.sh.
#
#   scripts/make_gpu_folder.sh [FOLDER [CMake option...]]
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-htloops-gpu}
shift || true

programs=(bin/htloops test/Handle_tunnel_loops/test_gpu
  test/Handle_tunnel_loops/test_device_passes benchmark/Handle_tunnel_loops/benchmark_device)
for program in "${programs[@]}"; do
  scripts/build.sh "$(basename "$program")" "$@"
done

# Where a library of the C library or of the driver would be, that of the other machine belongs.
is_of_the_system() {
  [[ "$(basename "$1")" =~ ^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|cuda|nvidia.*))\.so ]]
}

rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/lib"
for program in "${programs[@]}"; do
  cp "build/$program" "$folder/bin/"
  ldd "build/$program" | awk '$2 == "=>" && $3 ~ "^/" { print $3 }' | while read -r library; do
    is_of_the_system "$library" || cp -fL "$library" "$folder/lib/"
  done
done
git describe --always --abbrev=40 --dirty >"$folder/commit"
objdump -T "$folder"/bin/* "$folder"/lib/* | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1 |
  cut -d_ -f2 >"$folder/glibc"

cat >"$folder/run.sh" <<'RUN'
#!/usr/bin/env bash
# Runs the tests and the benchmark on this machine's device; what they print goes to results/ too.
#
#   run.sh [tests|sanitizers|benchmark]...
set -euo pipefail
cd "$(dirname "$0")"
export LD_LIBRARY_PATH=$PWD/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export HTL_REQUIRE_GPU=1
mkdir -p results

here=$(getconf GNU_LIBC_VERSION | cut -d' ' -f2)
if [ "$(printf '%s\n' "$(cat glibc)" "$here" | sort -V | head -n 1)" != "$(cat glibc)" ]; then
  echo "The programs need version $(cat glibc) of the C library; this machine has $here." >&2
  exit 1
fi

# What fails does not keep the rest from running.
failed=0
run() {
  local name=$1
  shift
  echo "== $name: $*"
  "$@" 2>&1 | tee "results/$name.txt" || failed=1
}

[ $# -gt 0 ] || set -- tests sanitizers benchmark
{
  echo "commit $(cat commit)"
  date -u +%F
  grep -m 1 'model name' /proc/cpuinfo || uname -m
  echo "$(nproc) cores"
} | tee results/machine.txt
nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv 2>/dev/null |
  tee -a results/machine.txt || true
for what in "$@"; do
  case "$what" in
    tests)
      run test_device_passes bin/test_device_passes
      run test_gpu bin/test_gpu
      ;;
    sanitizers)
      if command -v compute-sanitizer >/dev/null; then
        filter='--gtest_filter=Gpu.AgreesWithTheHostOnRandomSurfaces:Gpu.LabelsFronts*'
        # racecheck looks at shared memory only, of which there is what the barriers use.
        for tool in memcheck initcheck synccheck racecheck; do
          run "$tool" compute-sanitizer --tool "$tool" --error-exitcode 1 bin/test_gpu "$filter"
        done
      else
        echo "== sanitizers: compute-sanitizer is not in the PATH"
      fi
      ;;
    benchmark)
      run benchmark_device bin/benchmark_device
      bin/htloops generate gyroid --faces 1000000 --genus 250 -o results/gyroid.off --quiet
      for backend in cuda host; do
        run "htloops_$backend" bin/htloops loops results/gyroid.off --backend "$backend" \
          --threads 2 -o "results/gyroid.$backend.json"
      done
      rm results/gyroid.off
      ;;
    *)
      echo "usage: $0 [tests|sanitizers|benchmark]..." >&2
      exit 2
      ;;
  esac
done
exit "$failed"
RUN
chmod +x "$folder/run.sh"
echo "Written to $folder: $(du -sh "$folder" | cut -f1)"
