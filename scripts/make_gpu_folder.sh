#!/usr/bin/env bash
# Makes a folder with the tests, the benchmark and the tool for CUDA devices, and all the shared
# libraries that they need but those of the C library and of the driver: to be copied to a machine
# that has a driver, a C library no older than that of this machine's libraries, and nothing else,
# and there started with its run.sh.
#
#   scripts/make_gpu_folder.sh [FOLDER [CMake option...]]
#
# It has a build folder of its own, build-gpu: the programs look for their libraries beside
# themselves, and profilers find the lines of the source.
set -euo pipefail
cd "$(dirname "$0")/.."

folder=${1:-htloops-gpu}
shift || true

programs=(bin/htloops test/Handle_tunnel_loops/test_gpu
  test/Handle_tunnel_loops/test_fronts benchmark/Handle_tunnel_loops/benchmark_device
  benchmark/Handle_tunnel_loops/benchmark_threads)
cmake -S . -B build-gpu -DCMAKE_BUILD_TYPE=Release -DCMAKE_CUDA_FLAGS=-lineinfo \
  -DCMAKE_EXE_LINKER_FLAGS=-Wl,--disable-new-dtags -DCMAKE_BUILD_RPATH='$ORIGIN/../lib' "$@"
cmake --build build-gpu --parallel "$(nproc)" --target "${programs[@]##*/}"

# Where a library of the C library or of the driver would be, that of the other machine belongs.
is_of_the_system() {
  [[ "$(basename "$1")" =~ ^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|cuda|nvidia.*))\.so ]]
}

rm -rf "$folder"
mkdir -p "$folder/bin" "$folder/lib"
for program in "${programs[@]}"; do
  cp "build-gpu/$program" "$folder/bin/"
  ldd "build-gpu/$program" | awk '$2 == "=>" && $3 ~ "^/" { print $3 }' | while read -r library; do
    is_of_the_system "$library" || cp -fL "$library" "$folder/lib/"
  done
done
git describe --always --abbrev=40 --dirty >"$folder/commit"
objdump -T "$folder"/bin/* "$folder"/lib/* | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1 |
  cut -d_ -f2 >"$folder/glibc"

cat >"$folder/run.sh" <<'RUN'
#!/usr/bin/env bash
# Runs the tests and the benchmarks on this machine's device; what they print goes to the folder
# results/, or to the one named by the environment variable RESULTS. Nothing runs for ever.
#
#   run.sh [tests|sanitizers|benchmark|threads|knobs|profile]...
set -euo pipefail
cd "$(dirname "$0")"
export HTL_REQUIRE_GPU=1
results=${RESULTS:-$PWD/results}
mkdir -p "$results"

here=$(getconf GNU_LIBC_VERSION | cut -d' ' -f2)
if [ "$(printf '%s\n' "$(cat glibc)" "$here" | sort -V | head -n 1)" != "$(cat glibc)" ]; then
  echo "The programs need version $(cat glibc) of the C library; this machine has $here." >&2
  exit 1
fi

# What fails, or takes longer than so many seconds, does not keep the rest from running.
failed=0
run() {
  local name=$1 seconds=$2
  shift 2
  echo "== $name: $*"
  timeout --kill-after=5 "$seconds" "$@" 2>&1 | tee "$results/$name.txt" || failed=1
}

[ $# -gt 0 ] || set -- tests sanitizers benchmark
{
  echo "commit $(cat commit)"
  date -u +%F
  grep -m 1 'model name' /proc/cpuinfo || uname -m
  echo "$(nproc) cores"
} | tee "$results/machine.txt"
nvidia-smi --query-gpu=name,driver_version,memory.total --format=csv 2>/dev/null |
  tee -a "$results/machine.txt" || true
few='Gpu_smoke.*:Gpu.AgreesWithTheHostOnRandomSurfaces:Gpu.LabelsFronts*:Gpu.FindsTheCells*'
for what in "$@"; do
  case "$what" in
    tests)
      run test_device_passes 120 bin/test_fronts --gtest_filter='*Device_backend.*'
      for name in 'Gpu_smoke.*' 'Gpu.Labels*' 'Gpu.*RandomSurfaces' 'Gpu.*SmoothSurfaces' \
        'Gpu.FindsTheLoops*' 'Gpu.Finds*Cells*' 'On_a_device*' 'Gpu.*Reference' 'Gpu.*Thread*:Gpu.*Stream:Gpu.*Memory'; do
        run "test_gpu_${name//[^A-Za-z]/}" 120 bin/test_gpu --gtest_filter="$name"
      done
      run test_gpu_again 120 bin/test_gpu --gtest_filter='Gpu.*RandomSurfaces' --gtest_repeat=10
      ;;
    sanitizers)
      if command -v compute-sanitizer >/dev/null; then
        # racecheck looks at shared memory only, of which there is what the barriers use.
        for tool in memcheck initcheck synccheck racecheck; do
          options=(--tool "$tool" --error-exitcode 1)
          [ "$tool" != memcheck ] || options+=(--track-stream-ordered-races all)
          run "$tool" 150 compute-sanitizer "${options[@]}" bin/test_gpu --gtest_filter="$few"
        done
      else
        echo "== sanitizers: compute-sanitizer is not in the PATH"
      fi
      ;;
    benchmark)
      run benchmark_device 400 bin/benchmark_device --kernels
      bin/htloops generate gyroid --faces 1000000 --genus 250 -o "$results/gyroid.off" --quiet
      for backend in cuda host; do
        run "htloops_$backend" 60 bin/htloops loops "$results/gyroid.off" --backend "$backend" \
          --threads 2 -o "$results/gyroid.$backend.json"
      done
      rm "$results/gyroid.off"
      ;;
    threads) # of the host, beside the device
      run threads 300 bin/benchmark_threads
      ;;
    knobs)
      run knobs 300 bin/benchmark_device -n 1 --knobs --no-host
      ;;
    profile)
      if command -v ncu >/dev/null; then
        for domain in Whole_mesh_domain Paged_domain; do
          run "profile_$domain" 60 ncu --clock-control none --kernel-name-base demangled \
            -k "regex:Field_steps.*$domain" -s 3 -c 1 --section SpeedOfLight --section LaunchStats \
            --section WarpStateStats --section SourceCounters \
            bin/benchmark_device -n 1 --no-host --no-sweep gyroid:1000000:250
        done
      else
        echo "== profile: ncu is not in the PATH"
      fi
      ;;
    *)
      echo "usage: $0 [tests|sanitizers|benchmark|threads|knobs|profile]..." >&2
      exit 2
      ;;
  esac
done
exit "$failed"
RUN
chmod +x "$folder/run.sh"
echo "Written to $folder: $(du -sh "$folder" | cut -f1)"
