# nix-build packaging/nix: the tool, the library and its manual, from the sources beside this file.
{ pkgs ? import <nixpkgs> { } }:

pkgs.stdenv.mkDerivation {
  pname = "handle-tunnel-loops";
  version = pkgs.lib.fileContents ../../VERSION;
  src = pkgs.lib.cleanSource ../..;

  nativeBuildInputs = with pkgs; [ cmake ninja doxygen pkg-config ];
  buildInputs = with pkgs; [ cli11 nlohmann_json zlib libpng expat stb eigen ];
  # Whoever links the library needs these, too.
  propagatedBuildInputs = with pkgs; [ cgal boost gmp mpfr tbb_2021_11 ];

  cmakeFlags = [
    "-DHTL_CUDA=OFF"
    "-DHTL_PYTHON=OFF"
    "-DHTL_BUILD_TESTS=OFF"
    "-DHTL_BUILD_EXAMPLES=OFF"
    "-DHTL_BUILD_BENCHMARKS=OFF"
    "-DHTL_FONT=${pkgs.dejavu_fonts}/share/fonts/truetype/DejaVuSans-Bold.ttf"
  ];

  doInstallCheck = true;
  installCheckPhase = ''
    $out/bin/htloops generate torus -o torus.off
    $out/bin/htloops loops torus.off -o loops.json
    $out/bin/htloops check torus.off loops.json
  '';

  meta = {
    description = "Handle and tunnel loops of triangle meshes";
    license = pkgs.lib.licenses.gpl3Plus;
    mainProgram = "htloops";
    platforms = pkgs.lib.platforms.unix;
  };
}
