// Prints the two tables of the paper with what is measured here beside them.
//
//   benchmark_paper [-n RUNS] [--faces LIMIT] [FOLDER]
//
// Each row is computed on the mesh NAME.off, .ply or .obj in the folder, where NAME is that of the
// row in small letters with _ for spaces, if there is one; otherwise on a generated mesh with as
// many faces and handles, which is named. Times are medians of the runs, in seconds, from arrays in
// memory to certified loops, by all threads, and by a CUDA device where there is one.

#include "Benchmark_meshes.h"
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
#include <thread>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using HTL::Stage;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;

struct Options
{
  int runs = 3;
  std::size_t limit = static_cast<std::size_t>(-1);
  std::filesystem::path folder;
};

Options parse(int argc, char* argv[]) {
  Options options;
  for(int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if(word == "-n" && i + 1 < argc)
      options.runs = std::stoi(argv[++i]);
    else if(word == "--faces" && i + 1 < argc)
      options.limit = std::stoul(argv[++i]);
    else
      options.folder = word;
  }
  return options;
}

Mesh mesh_of(const HTL::generators::Soup& soup) {
  Mesh mesh;
  for(const auto& [x, y, z] : soup.points)
    mesh.add_vertex({x, y, z});
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  return mesh;
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

Subject subject_of(const paper::Row& row, const std::filesystem::path& folder) {
  Subject subject;
  for(const char* const extension : {".off", ".ply", ".obj"}) {
    const std::filesystem::path file = folder / (file_name(row.mesh) + extension);
    if(!folder.empty() && CGAL::IO::read_polygon_mesh(file.string(), subject.mesh)) {
      subject.name = "the same";
      return subject;
    }
  }
  subject.name = row.kind;
  subject.mesh = mesh_of(
      generate(row.kind + ":" + std::to_string(row.faces) + ":" + std::to_string(row.genus)));
  return subject;
}

// Medians, in seconds: of the whole, of the passes that the paper has, and of what follows them.
struct Times
{
  double total, initial, tunnel, handle;
};

template <typename ConcurrencyTag> Times times_of(const Mesh& mesh, int runs) {
  std::array<std::vector<double>, 4> seconds;
  for(int i = 0; i < runs; ++i) {
    const double start = seconds_now();
    Solver solver(ConcurrencyTag(), mesh, params::default_values());
    std::vector<Solver::Pair> pairs;
    solver.template find_loops<ConcurrencyTag>(std::back_inserter(pairs), params::default_values());
    seconds[0].push_back(seconds_now() - start);
    const auto of = [&](Stage stage) { return solver.statistics().seconds_of(stage); };
    seconds[1].push_back(of(Stage::INITIAL));
    seconds[2].push_back(of(Stage::TUNNEL));
    seconds[3].push_back(of(Stage::REFINE));
  }
  return {median(seconds[0]), median(seconds[1]), median(seconds[2]), median(seconds[3])};
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

} // namespace

int main(int argc, char* argv[]) {
  const Options options = parse(argc, argv);
  std::printf("%u threads; paper: RTX 2080 Ti, and Dey, Fan and Wang 2013 on a Core i7-7700\n\n",
              std::thread::hardware_concurrency());
  std::printf(
      "| mesh | faces | genus | paper: total | initial | tunnel | handle | Dey 2013 | here: mesh "
      "| faces | genus | total | initial | tunnel | handle | paper/here | device: total | initial "
      "| tunnel | handle | paper: MB | Dey 2013: MB | here: MB | bytes per face |\n|");
  for(int i = 0; i < 24; ++i)
    std::printf(i == 0 || i == 8 ? "---|" : "---:|");
  std::printf("\n");
  double least = HUGE_VAL;
  for(const paper::Row& row : paper::rows()) {
    if(row.faces > options.limit)
      continue;
    const Subject subject = subject_of(row, options.folder);
    const Times here = times_of<CGAL::Parallel_if_available_tag>(subject.mesh, options.runs);
    const double bytes = double(bytes_of(subject.mesh)),
                 faces = double(subject.mesh.number_of_faces());
    const auto device = times_on_device(subject.mesh, options.runs);
    const double ratio = row.total / here.total;
    least = (std::min)(least, ratio);
    std::printf(
        "| %s | %zu | %zu | %s | %s | %s | %.0f | %zu | %s | %.0f | %s | %s | %s | %.0f | %.0f |\n",
        row.mesh.c_str(), row.faces, row.genus,
        cells({row.total, row.initial, row.tunnel, row.handle}).c_str(),
        number(row.others_total, "%.2f").c_str(), subject.name.c_str(), faces,
        Solver(CGAL::Sequential_tag(), subject.mesh, params::default_values()).genus(),
        cells(here).c_str(), ratio, device ? cells(*device).c_str() : "- | - | - | -",
        number((std::max)(row.initial_megabytes, row.passes_megabytes), "%.0f").c_str(),
        number(row.others_megabytes, "%.0f").c_str(), bytes / 1e6, bytes / faces);
    std::fflush(stdout);
  }
  std::printf("\nleast ratio of the paper's total to that here: %.1f\n", least);
}
