// Writes pages in which a surface can be turned, beside reading the mesh with CGAL: how long that
// takes, and how large they are. Where there is a Chromium, they are opened in it, without a
// graphics card: how long they take to load, and to draw once.
//
//   benchmark_page [-n RUNS] [KIND:FACES:GENUS|FILE...]

#include "Benchmark_meshes.h"
#include "Browser.h"

#include "app/draw/pages.h"
#include "app/draw/scenes.h"
#include "app/mend/mesh_reader.h"
#include "app/solve/backends.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Seconds to load a page; to draw it once, in full and while it moves; and from a click on a row to
// the end of the flight, to the first frame with all triangles, and to the one with smooth rims.
std::string in_browser(Browser* browser, const std::string& page) {
  if(browser == nullptr)
    return "| | | | | | |";
  browser->open(page, "document.body?.classList.contains('ready') === true");
  const double load = browser->evaluate("htloops.loadMilliseconds");
  browser->evaluate("htloops.viewer.settled()");
  const auto frame = [&](const std::string& is_moving) -> double {
    return browser->evaluate("(() => { const { viewer } = htloops, n = 3;"
                             "const draw = () => { viewer.isMoving = " +
                             is_moving +
                             "; viewer.camera.turn(0.1, 0.05); viewer.drawNow();"
                             "  viewer.renderer.wait(); };"
                             "draw(); const began = performance.now(); for(let i = 0; i < n; ++i) "
                             "draw(); viewer.isMoving = false; viewer.isAtHome = false;"
                             "return (performance.now() - began) / n; })()");
  };
  const double full = frame("false"), coarse = frame("true");
  const auto row = [&](const std::string& until) -> double {
    return browser->evaluate("(async () => { const { viewer, page, scene } = htloops;"
                             "await viewer.settled(); const began = performance.now();"
                             "page.light(Math.floor(scene.rows.length / 2), true); " +
                             until +
                             " const time = performance.now() - began; await viewer.settled();"
                             "viewer.goHome(); await viewer.settled(); return time; })()");
  };
  const double there = row("while(viewer.flight) await new Promise(requestAnimationFrame);");
  const double drawn = row("while(viewer.flight || viewer.isDue) await new Promise("
                           "requestAnimationFrame); viewer.renderer.wait();");
  const double smooth = row("await viewer.settled();");
  char text[120];
  std::snprintf(text, sizeof text, "| %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |", load / 1000.,
                full / 1000., coarse / 1000., there / 1000., drawn / 1000., smooth / 1000.);
  return text;
}

void measure(const std::string& input, int number_of_runs, Browser* browser) {
  const Off_file off(input);
  const std::string page = off.name() + ".html";
  htloops::Answer answer;
  htloops::Pair_listing listing;
  std::vector<double> reading, writing, ratio;
  double bytes = 0., faces = 0.;
  for(int run = 0; run < number_of_runs; ++run) {
    Mesh read;
    const double t0 = seconds_now();
    if(!CGAL::IO::read_polygon_mesh(off.name(), read))
      throw std::runtime_error("cannot read " + off.name());
    const double t1 = seconds_now();
    const htloops::Mesh mesh = htloops::read_mesh(htloops::Input_file(off.name()));
    htloops::Progress told;
    answer = htloops::host_backend.solve(mesh, {}, told);
    listing = htloops::list_pairs(mesh, answer);
    const double t2 = seconds_now();
    htloops::write_page(page, htloops::scene_of_loops({}, input, mesh, answer, listing, ""));
    const double t3 = seconds_now();
    bytes = double(std::filesystem::file_size(page));
    faces = double(mesh.number_of_faces());
    reading.push_back(t1 - t0);
    writing.push_back(t3 - t2);
    ratio.push_back((t3 - t2) / (t1 - t0));
  }
  const std::string shown = in_browser(browser, std::filesystem::absolute(page).string());
  std::filesystem::remove(page);
  std::printf("| %s | %.0f | %zu | %.2f | %.2f | **%.2f** | %.2f | %.1f %s\n", input.c_str(), faces,
              answer.pairs.size(), median(reading), median(writing), median(ratio), bytes / 1e6,
              bytes / faces, shown.c_str());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[]) {
  const Requested_runs runs(
      argc, argv, 3,
      {"torus:1000000:1", "multi-torus:1000000:250", "gyroid:1000000:250", "lattice:1000000:250"});
  try {
    std::printf("| mesh | faces | pairs | reading s | page s | ratio | MB | bytes per face | load "
                "s | frame s | moving s | row: there s | row: drawn s | row: smooth s |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::unique_ptr<Browser> browser;
    if(!Browser::program().empty())
      browser = std::make_unique<Browser>(1200, 800);
    for(const std::string& input : runs.inputs)
      measure(input, runs.number, browser.get());
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
