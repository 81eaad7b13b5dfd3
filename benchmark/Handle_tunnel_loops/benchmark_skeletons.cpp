// Measures curve skeletons, beside CGAL's mean curvature flow skeletons.
//
//   benchmark_skeletons [--limit SECONDS] [--faces N] [--same] [--random N [--seed N]]
//                       [KIND:FACES:GENUS | FILE | FOLDER]...
//
// A row for each closed mesh that does not cross itself and has at most N faces (or any number),
// and for N random surfaces. All is measured here by code that shares nothing with what makes or
// certifies skeletons:
//
//   inside    the share of the line that is inside, by length, cut where it crosses the surface
//   centred   the distance of a point of the line from the surface over the radius of the largest
//             ball that holds the point, lies inside and has its centre in the plane across the
//             line, found by walking uphill from the point: the median over the line, and the share
//             of the line where it is above 0.7; `section` is the latter with balls that need not
//             hold the point, which tells of a limb where it enters a body
//   same      the Hausdorff distance to the skeleton of the same mesh with its vertices and faces
//   in
//             another order and turned at random, turned back, over the diagonal of the mesh; and
//             `moved`, the share of both lines that is more than 1% of it from the other
//
// Seconds are those of the processor, with one thread. The mean curvature flow runs in a process of
// its own, for at most the time of --limit, and component by component; 0 leaves it out.

#include "Benchmark_meshes.h"
#include "Centredness.h"
#include "Command_line.h"
#include "Corpus_answer.h"
#include "Lines_in_space.h"
#include "Random_surfaces.h"
#include "Solid.h"
#ifdef CGAL_EIGEN3_ENABLED
#include "Mean_curvature_skeleton.h"
#endif

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/transform.h>
#include <CGAL/curve_skeleton.h>

#include <ctime>
#include <iostream>
#include <memory>
#include <optional>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

struct Settings
{
  unsigned limit = 0;
  std::size_t most_faces = 0;
  bool is_same_asked = false;
};

template <typename Function> double processor_seconds(const Function& f) {
  const std::clock_t began = std::clock();
  f();
  return double(std::clock() - began) / CLOCKS_PER_SEC;
}

/// What can be said of any skeleton.
struct Judgement
{
  std::size_t cycles = 0;
  double inside = 1., centred = 1., share_centred = 1., share_in_section = 1.;
};

Judgement judge(const Solid& solid, const Lines_in_space& lines) {
  Judgement judgement;
  judgement.cycles = number_of_cycles(lines);
  const double whole = length(lines);
  if(!(whole > 0.))
    return judgement;
  double inside = 0.;
  for(const auto& [a, b] : lines.edges)
    inside += solid.length_inside(lines.points[a], lines.points[b]);
  judgement.inside = inside / whole;
  const Centredness c = centredness(solid, lines);
  judgement.centred = corpus::quantile(c.of_holding_ball, 0.5);
  judgement.share_centred = Centredness::share_above(c.of_holding_ball, 0.7);
  judgement.share_in_section = Centredness::share_above(c.of_section, 0.7);
  return judgement;
}

/// How far two skeletons are from each other, over the diagonal.
struct Move
{
  double largest = 0.;
  double share_above = 0.; ///< of the line, that is moved by 1% or more
};

struct Row
{
  std::string name;
  CGAL::Handle_tunnel_loops::Skeleton_statistics statistics;
  std::size_t arcs = 0;
  double reading = 0., seconds = 0.;
  Judgement ours;
  std::optional<Move> moved;
  bool is_flow_asked = false;
  std::optional<Judgement> flow;
  double seconds_of_flow = 0.;

  bool is_certified() const { return bool(statistics.certificate); }

  double seconds_of_loops() const {
    const double all = statistics.seconds_of_loops + statistics.seconds_of_skeleton;
    return all > 0. ? seconds * statistics.seconds_of_loops / all : 0.;
  }
};

Lines_in_space skeleton_lines(const Solid_mesh& mesh,
                              CGAL::Handle_tunnel_loops::Skeleton_statistics& statistics) {
  CGAL::Curve_skeleton<Solid_mesh> skeleton;
  statistics = CGAL::curve_skeleton(mesh, skeleton);
  return lines_of(skeleton);
}

double diagonal(const Solid_mesh& mesh) {
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

/// how far the skeleton lies from that of the mesh in another order and turned.
Move moved_when_turned(const Solid_mesh& mesh, const Lines_in_space& lines) {
  CGAL::Random order(1);
  CGAL::Handle_tunnel_loops::generators::Random dice(1);
  const auto r = random_surfaces::random_rotation(dice);
  const CGAL::Aff_transformation_3<Kernel> rotation(r[0][0], r[0][1], r[0][2], r[1][0], r[1][1],
                                                    r[1][2], r[2][0], r[2][1], r[2][2]);
  Solid_mesh other = corpus::permuted(mesh, order);
  PMP::transform(rotation, other);
  CGAL::Handle_tunnel_loops::Skeleton_statistics unused;
  Lines_in_space turned = skeleton_lines(other, unused);
  for(Point& p : turned.points)
    p = rotation.inverse()(p);
  const double size = diagonal(mesh);
  const auto distances = distances_between(lines, turned, 1e-3 * size);
  if(distances.empty())
    return {};
  return {corpus::quantile(distances, 1.) / size, Centredness::share_above(distances, 0.01 * size)};
}

#ifdef CGAL_EIGEN3_ENABLED
void measure_flow(unsigned limit,
                  const std::vector<Solid_mesh>& components,
                  const Solid& solid,
                  Row& row) {
  row.is_flow_asked = limit > 0;
  if(limit == 0)
    return;
  if(const auto answer = mean_curvature_lines_within(limit, components)) {
    row.flow = judge(solid, answer->lines);
    row.seconds_of_flow = answer->seconds;
  }
}
#else
void measure_flow(unsigned, const std::vector<Solid_mesh>&, const Solid&, Row&) {}
#endif

const char* reason_to_skip(const Solid_mesh& mesh, std::size_t most_faces) {
  if(mesh.is_empty() || !CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh))
    return "not closed";
  if(most_faces != 0 && mesh.number_of_faces() > most_faces)
    return "too many faces";
  return PMP::does_self_intersect(mesh) ? "crosses itself" : nullptr;
}

std::optional<Row>
measure(const std::string& name, const std::string& file, const Settings& settings) {
  Row row;
  row.name = name;
  Solid_mesh mesh;
  bool is_read = false;
  row.reading = processor_seconds([&] { is_read = CGAL::IO::read_polygon_mesh(file, mesh); });
  if(!is_read)
    throw std::runtime_error("cannot be read");
  if(const char* reason = reason_to_skip(mesh, settings.most_faces)) {
    std::printf("| %s | %s |\n", name.c_str(), reason);
    return std::nullopt;
  }
  std::vector<Solid_mesh> components;
  PMP::split_connected_components(mesh, components);
  Lines_in_space lines;
  row.seconds = processor_seconds([&] { lines = skeleton_lines(mesh, row.statistics); });
  row.arcs = number_of_arcs(lines);
  const auto solid = components.size() == 1 ? std::make_unique<Solid>(mesh)
                                            : std::make_unique<Solid>(mesh, components);
  row.ours = judge(*solid, lines);
  if(settings.is_same_asked)
    row.moved = moved_when_turned(mesh, lines);
  measure_flow(settings.limit, components, *solid, row);
  return row;
}

void print_head() {
  std::printf(
      "| mesh | faces | genus | certified | arcs | inside %% | centred | > 0.7 %% | in section "
      "%% | reading s | loops s | skeleton s | all / reading | same %% | moved %% | flow: cycles | "
      "inside "
      "%% | centred | > 0.7 %% | in section %% | s | ours / flow |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
      "\n");
}

void print(const Judgement& j) {
  std::printf(" %.1f | %.2f | %.0f | %.0f |", 100. * j.inside, j.centred, 100. * j.share_centred,
              100. * j.share_in_section);
}

void print(const Row& row) {
  const auto& s = row.statistics;
  std::printf("| %s | %zu | %zu | %s | %zu |", row.name.c_str(), s.number_of_faces, s.genus,
              row.is_certified() ? "yes" : "**no**", row.arcs);
  print(row.ours);
  std::printf(" %.3f | %.3f | %.3f | %.1f |", row.reading, row.seconds_of_loops(),
              row.seconds - row.seconds_of_loops(), row.seconds / row.reading);
  if(row.moved)
    std::printf(" %.2f | %.1f |", 100. * row.moved->largest, 100. * row.moved->share_above);
  else
    std::printf(" | |");
  if(row.flow) {
    std::printf(" %zu |", row.flow->cycles);
    print(*row.flow);
    std::printf(" %.2f | %.3f |\n", row.seconds_of_flow, row.seconds / row.seconds_of_flow);
  } else
    std::printf("%s\n", row.is_flow_asked ? " none | | | | | | |" : " | | | | | | |");
  if(!s.certificate.failure.empty())
    std::cerr << row.name << ": " << s.certificate.failure << '\n';
  std::fflush(stdout);
}

/// What is said of all rows at the end.
class Summary
{
public:
  explicit Summary(const std::vector<Row>& rows)
      : rows_(rows) {}

  void print() const {
    std::printf("\n%zu meshes, %zu certified, %zu with all cycles\n", rows_.size(),
                number([](const Row& r) { return r.is_certified(); }),
                number([](const Row& r) { return r.ours.cycles == r.statistics.genus; }));
    print("skeletons", [](const Row& r) { return &r.ours; });
    std::printf("over reading: median %.1f, most %.1f\n", at(&Row::reading, 0.5),
                at(&Row::reading, 1.));
    if(number([](const Row& r) { return r.moved.has_value(); }) > 0)
      std::printf(
          "same: below 1%% on %zu, median %.2f%%; moved by more: median %.1f%% of the line\n",
          number([](const Row& r) { return r.moved && r.moved->largest < 0.01; }),
          100. * moved(&Move::largest), 100. * moved(&Move::share_above));
    print_flow();
    print_worst();
  }

private:
  template <typename Condition> std::size_t number(const Condition& holds) const {
    return static_cast<std::size_t>(std::count_if(rows_.begin(), rows_.end(), holds));
  }

  /// of the values of rows that have one.
  template <typename Value> double quantile(const Value& value, double part) const {
    std::vector<double> values;
    for(const Row& row : rows_)
      if(const std::optional<double> v = value(row))
        values.push_back(*v);
    return corpus::quantile(std::move(values), part);
  }

  double moved(double Move::*member) const {
    return quantile(
        [member](const Row& r) {
          return r.moved ? std::optional<double>((*r.moved).*member) : std::nullopt;
        },
        0.5);
  }

  /// of the time for a skeleton over another one.
  double at(double Row::*other, double part) const {
    return quantile(
        [other](const Row& r) {
          return r.*other > 0. ? std::optional<double>(r.seconds / (r.*other)) : std::nullopt;
        },
        part);
  }

  template <typename Judged> void print(const char* what, const Judged& judged) const {
    const auto median_of = [&](double Judgement::*member) {
      return quantile(
          [&](const Row& r) {
            const Judgement* j = judged(r);
            return j ? std::optional<double>(j->*member) : std::nullopt;
          },
          0.5);
    };
    const auto good = number([&](const Row& r) {
      const Judgement* j = judged(r);
      return j && j->share_centred >= 0.9;
    });
    const auto wholly = number([&](const Row& r) {
      const Judgement* j = judged(r);
      return j && j->inside > 1. - 1e-9;
    });
    std::printf("%s: wholly inside %zu, inside median %.1f%%; centred median %.2f; above 0.7 on "
                "%.0f%% of the line (median; in section %.0f%%), on 90%% of it or more for %zu\n",
                what, wholly, 100. * median_of(&Judgement::inside), median_of(&Judgement::centred),
                100. * median_of(&Judgement::share_centred),
                100. * median_of(&Judgement::share_in_section), good);
  }

  void print_flow() const {
    const auto asked = number([](const Row& r) { return r.is_flow_asked; });
    if(asked == 0)
      return;
    std::printf("flow: %zu answers of %zu, %zu with all cycles; time of ours over it: median %.3f, "
                "most %.3f\n",
                number([](const Row& r) { return r.flow.has_value(); }), asked,
                number([](const Row& r) { return r.flow && r.flow->cycles == r.statistics.genus; }),
                at(&Row::seconds_of_flow, 0.5), at(&Row::seconds_of_flow, 1.));
    print("flow", [](const Row& r) { return r.flow ? &*r.flow : nullptr; });
    print("skeletons there", [](const Row& r) { return r.flow ? &r.ours : nullptr; });
  }

  void print_worst() const {
    const auto print_ten = [&](const char* what, const auto& goodness) {
      std::vector<const Row*> order;
      for(const Row& row : rows_)
        order.push_back(&row);
      std::stable_sort(order.begin(), order.end(),
                       [&](const Row* a, const Row* b) { return goodness(*a) < goodness(*b); });
      order.resize((std::min)(order.size(), std::size_t(10)));
      std::printf("%s:", what);
      for(const Row* row : order)
        std::printf(" %s (%.2f)", row->name.c_str(), goodness(*row));
      std::printf("\n");
    };
    print_ten("least centred", [](const Row& r) {
      return r.is_certified() ? r.ours.share_centred : r.ours.share_centred - 1.;
    });
    if(!rows_.empty() && rows_.front().moved)
      print_ten("least the same", [](const Row& r) { return r.moved ? -r.moved->largest : 0.; });
  }

  const std::vector<Row>& rows_;
};

void measure_all(const corpus::Command_line& line) {
  const Settings settings{static_cast<unsigned>(line.number("--limit", 0)),
                          line.number("--faces", 0), line.has("--same")};
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, const std::string& input) {
    try {
      const Off_file file(input);
      if(auto row = measure(name, file.name(), settings)) {
        print(*row);
        rows.push_back(std::move(*row));
      }
    } catch(const std::exception& e) {
      std::printf("| %s | %s |\n", name.c_str(), e.what());
    }
  };
  print_head();
  for(const auto& input : line.files())
    add(input.stem().string(), input.string());
  for(std::size_t i = 0; i < line.number("--random", 0); ++i) {
    const auto surface = random_surfaces::random_surface(i, line.number("--seed", 0));
    const std::string scratch =
        (std::filesystem::temp_directory_path() / "benchmark_skeletons.off").string();
    write_off(surface.soup, scratch);
    add(std::to_string(i) + " " + surface.words, scratch);
    std::filesystem::remove(scratch);
  }
  Summary(rows).print();
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    measure_all(
        corpus::Command_line(argc, argv, {"--same"}, {"--limit", "--faces", "--random", "--seed"}));
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
