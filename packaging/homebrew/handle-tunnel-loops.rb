# A formula for a tap: brew install --build-from-source ./handle-tunnel-loops.rb
class HandleTunnelLoops < Formula
  desc "Handle and tunnel loops of triangle meshes"
  homepage "https://example.org/handle_tunnel_loops"
  url "https://example.org/handle_tunnel_loops/handle-tunnel-loops-0.9.0-source.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000" # of the archive of the release
  license "GPL-3.0-or-later"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "doxygen" => :build
  depends_on "eigen" => :build
  depends_on "nlohmann-json" => :build
  depends_on "cgal"
  depends_on "gmp"
  depends_on "libpng"
  depends_on "mpfr"
  depends_on "tbb"

  uses_from_macos "expat"
  uses_from_macos "zlib"

  def install
    system "cmake", "-S", ".", "-B", "build", "-DHTL_CUDA=OFF", "-DHTL_PYTHON=OFF",
                    "-DHTL_BUILD_TESTS=OFF", "-DHTL_BUILD_EXAMPLES=OFF", "-DHTL_BUILD_BENCHMARKS=OFF",
                    *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"htloops", "generate", "torus", "-o", "torus.off"
    system bin/"htloops", "loops", "torus.off", "-o", "loops.json"
    system bin/"htloops", "check", "torus.off", "loops.json"
  end
end
