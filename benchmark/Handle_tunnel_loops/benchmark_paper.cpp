// Prints the two tables of the paper with what is measured here beside them.
//
//   benchmark_paper [-n RUNS] [--from FACES] [--faces LIMIT] [--only paper|hard] [FOLDER]
//
// Rows with fewer faces than the first number, or more than the second, are left out: the largest
// take long. After the rows of the paper come those with harder triangulations: Paper_rows.h says
// what stands for what.
//
// Each row is computed on the mesh NAME.off, .ply or .obj in the folder, where NAME is that of the
// row in small letters with _ for spaces, if there is one; otherwise on a generated mesh with as
// many faces and at least as many handles, which is named. Times are medians of the runs, in
// seconds, from arrays in memory to certified loops, by all threads, and by a CUDA device where
// there is one: of everything, and of what the paper does as well (its three passes and the naming
// of the loops, without making them shorter and looking for others; still with their certificate).

#include "Benchmark_meshes.h"
#include "Command_line.h"
#include "Counting_allocation.h"
#include "Paper_rows.h"

#include <CGAL/handle_tunnel_loops.h>
#ifdef BENCHMARK_HAS_CUDA
#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>
#endif

#include <array>
#include <cctype>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <thread>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using HTL::Stage;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

struct Options
{
  int runs;
  std::size_t least, limit;
  std::string only;
  std::vector<std::filesystem::path> files;
};

Options options_of(const corpus::Command_line& line) {
  Options options;
  options.runs = static_cast<int>(line.number("-n", 3));
  options.least = line.number("--from", 0);
  options.limit = line.number("--faces", static_cast<std::size_t>(-1));
  options.only = line.text("--only");
  options.files = line.files();
  return options;
}

std::string file_name(std::string name) {
  for(char& c : name)
    c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// A mesh, and which it is.
struct Subject
{
  Mesh mesh;
  std::string name;
};

Subject subject_of(const paper::Row& row, const std::vector<std::filesystem::path>& files) {
  Subject subject;
  for(const std::filesystem::path& file : files)
    if(file.stem() == file_name(row.mesh) &&
       CGAL::IO::read_polygon_mesh(file.string(), subject.mesh)) {
      subject.name = "the same";
      return subject;
    }
  subject.name = row.kind;
  const std::size_t faces = // which its noise takes
      row.kind == "scan" ? (std::max)(row.faces, 15000 + 4000 * row.genus) : row.faces;
  subject.mesh = mesh_of<Mesh>(
      generate(row.kind + ":" + std::to_string(faces) + ":" + std::to_string(row.genus)));
  return subject;
}

// Medians, in seconds: of the whole, of the passes that the paper has, and of a run that does no
// more than the paper.
struct Times
{
  double total, initial, tunnel, handle, as_paper;
};

// Seconds from a mesh to loops.
template <typename ConcurrencyTag, typename Parameters>
double seconds_of(const Mesh& mesh, const Parameters& np, HTL::Statistics& statistics) {
  const double start = seconds_now();
  Solver solver(ConcurrencyTag(), mesh, params::default_values());
  std::vector<Solver::Pair> pairs;
  solver.template find_loops<ConcurrencyTag>(std::back_inserter(pairs), np);
  const double seconds = seconds_now() - start;
  if(pairs.size() != solver.genus() || !solver.certificate())
    throw std::runtime_error("there are not as many certified pairs as handles");
  statistics = solver.statistics();
  return seconds;
}

template <typename ConcurrencyTag> Times times_of(const Mesh& mesh, int runs) {
  std::array<std::vector<double>, 5> seconds;
  HTL::Solver_options as_traced;
  as_traced.do_tighten = false;
  for(int i = 0; i < runs; ++i) {
    HTL::Statistics statistics;
    seconds[4].push_back(
        seconds_of<ConcurrencyTag>(mesh, params::solver_options(as_traced), statistics));
    seconds[0].push_back(seconds_of<ConcurrencyTag>(mesh, params::default_values(), statistics));
    const auto of = [&](Stage stage) { return statistics.seconds_of(stage); };
    seconds[1].push_back(of(Stage::INITIAL));
    seconds[2].push_back(of(Stage::TUNNEL));
    seconds[3].push_back(of(Stage::REFINE));
  }
  return {median(seconds[0]), median(seconds[1]), median(seconds[2]), median(seconds[3]),
          median(seconds[4])};
}

std::size_t bytes_of(const Mesh& mesh) {
  return counting_allocation::peak_bytes([&] {
    std::vector<Solver::Pair> pairs;
    CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  });
}

std::optional<Times> times_on_device(const Mesh& mesh, int runs) {
#ifdef BENCHMARK_HAS_CUDA
  try {
    return times_of<CGAL::Cuda_tag>(mesh, runs);
  } catch(const HTL::Device_exception&) { // none, or too little memory
  }
#else
  (void)mesh;
  (void)runs;
#endif
  return std::nullopt;
}

std::string number(double value, const char* format) {
  if(value == paper::unknown)
    return "-";
  char text[40];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

std::string cells(const Times& t) {
  return number(t.total, "%.2f") + " | " + number(t.initial, "%.2f") + " | " +
         number(t.tunnel, "%.2f") + " | " + number(t.handle, "%.2f");
}

// Small meshes take a few milliseconds.
std::string cells_of_ours(const Times& t) {
  std::string cells;
  for(const double seconds : {t.total, t.initial, t.tunnel, t.handle, t.as_paper})
    cells += (cells.empty() ? "" : " | ") + number(seconds, seconds < 1. ? "%.3f" : "%.2f");
  return cells;
}

// Of the rows that were computed, the least ratios of the paper's time to that here.
struct Least
{
  double total = HUGE_VAL, as_paper = HUGE_VAL;
};

void print_head() {
  std::printf(
      "| mesh | faces | genus | paper: total | initial | tunnel | handle | Dey 2013 | here: mesh "
      "| faces | genus | total | initial | tunnel | handle | as the paper | paper/here: total | as "
      "the paper | device: total | initial | tunnel | handle | as the paper | paper: MB | Dey "
      "2013: "
      "MB | here: MB | bytes per face |\n|");
  for(int i = 0; i < 27; ++i)
    std::printf(i == 0 || i == 8 ? "---|" : "---:|");
  std::printf("\n");
}

void print(const paper::Row& row, const Options& options, Least& least) {
  const Subject subject = subject_of(row, options.files);
  const Times here = times_of<CGAL::Parallel_if_available_tag>(subject.mesh, options.runs);
  const double bytes = double(bytes_of(subject.mesh)),
               faces = double(subject.mesh.number_of_faces());
  const auto device = times_on_device(subject.mesh, options.runs);
  const double ratio = row.total / here.total, ratio_as_paper = row.total / here.as_paper;
  least = {(std::min)(least.total, ratio), (std::min)(least.as_paper, ratio_as_paper)};
  std::printf(
      "| %s | %zu | %zu | %s | %s | %s | %.0f | %zu | %s | %.1f | %.1f | %s | %s | %s | %.0f | "
      "%.0f |\n",
      row.mesh.c_str(), row.faces, row.genus,
      cells({row.total, row.initial, row.tunnel, row.handle, paper::unknown}).c_str(),
      number(row.others_total, "%.2f").c_str(), subject.name.c_str(), faces,
      Solver(CGAL::Sequential_tag(), subject.mesh, params::default_values()).genus(),
      cells_of_ours(here).c_str(), ratio, ratio_as_paper,
      device ? cells_of_ours(*device).c_str() : "- | - | - | - | -",
      number((std::max)(row.initial_megabytes, row.passes_megabytes), "%.0f").c_str(),
      number(row.others_megabytes, "%.0f").c_str(), bytes / 1e6, bytes / faces);
  std::fflush(stdout);
}

void print(const char* title, const std::vector<paper::Row>& rows, const Options& options) {
  std::printf("%s\n\n", title);
  print_head();
  Least least;
  for(const paper::Row& row : rows)
    if(options.least <= row.faces && row.faces <= options.limit)
      print(row, options, least);
  std::printf(
      "\nleast ratio of the paper's total to that here: %.1f; to that of what the paper does: "
      "%.1f\n\n",
      least.total, least.as_paper);
}

} // namespace

int main(int argc, char* argv[]) {
  const Options options =
      options_of(corpus::Command_line(argc, argv, {}, {"-n", "--from", "--faces", "--only"}));
  std::printf("%u threads; paper: RTX 2080 Ti, and Dey, Fan and Wang 2013 on a Core i7-7700\n\n",
              std::thread::hardware_concurrency());
  if(options.only != "hard")
    print("The rows of the paper", paper::rows(), options);
  if(options.only != "paper")
    print("Rows with harder triangulations", paper::hard_rows(), options);
}
