// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/file_names.h"
#include "app/interrupt.h"
#include "app/read/skeleton_reader.h"
#include "app/solve/backends.h"
#include "app/solve/certification.h"
#include "app/words.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"
#include "commands/claims.h"
#include "commands/command.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <cstddef>
#include <memory>
#include <string_view>

namespace htloops {
namespace {

struct Check_options : Mesh_options
{
  std::string loops_file;
};

// The names of handles and tunnels are wrong, and nothing else.
bool has_wrong_types_only(const Certificate& c) {
  return c.closed_on_surface && c.basis && c.pairing && !c.types;
}

// What has been found to be right, and what is no failure but should be known.
std::string praise(const Certificate& certificate, bool has_boundary, bool is_boundary_of_solid) {
  const std::size_t number_of_loops = certificate.linking.size();
  if(number_of_loops == 0)
    return has_boundary ? "no loops; all boundary curves except one per component are a basis of "
                          "H1(S; Z)"
                        : "no loops, as the genus is 0";
  const std::string text =
      "the " + std::to_string(number_of_loops) +
      " loops are closed, lie on the surface and are a basis of H1(S; Z)" +
      (has_boundary ? " with all boundary curves except one per component" : "");
  std::vector<std::string> remarks;
  if(!is_boundary_of_solid)
    remarks.push_back(
        "the surface touches or crosses itself: there is no inside or outside there, and "
        "linking numbers alone decide which loops bound");
  for(const auto& lines : {lines_of(certificate.failure), remarks_on_sides(certificate)})
    remarks.insert(remarks.end(), lines.begin(), lines.end());
  return text + (certificate.pairing ? "; each tunnel loop crosses its handle loop once\n" : "\n") +
         summary_of_sides(certificate) + indented(remarks);
}

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

// The worst first: loops that are no basis, then what the file says that is not so.
std::vector<std::string> findings(const Loops_record& record,
                                  const Mesh& mesh,
                                  const Bound_loops& loops,
                                  const Certificate& certificate,
                                  bool is_boundary_of_solid) {
  std::vector<std::string> all;
  // Names mean nothing where there is no inside.
  if(!certificate && (is_boundary_of_solid || !has_wrong_types_only(certificate)))
    append(all, lines_of(certificate.failure));
  if(loops.has_boundaries)
    append(all, problems_of_boundaries(mesh, loops.curves, loops.waists));
  append(all, loops.problems);
  append(all, false_claims_on_surface(record, mesh));
  append(all, false_claims_on_loops(record, mesh, loops.pairs, certificate));
  return all;
}

void check_loops(const Check_options& options, const Mesh& mesh, const Input_file& file) {
  const Loops_record record = read_loops_json(file);
  const Bound_loops loops = bind_loops(record, mesh);
  if(!loops.are_placed) { // so nothing can be said of them
    std::vector<std::string> all = loops.problems;
    append(all, false_claims_on_surface(record, mesh));
    require_none(options.loops_file, all);
  }
  const Certificate certificate = certify(mesh, loops.pairs, loops.basis_kind, true);
  const bool is_boundary_of_solid =
      loops.pairs.empty() || !touches_itself(mesh, throw_if_interrupted);
  require_none(options.loops_file,
               findings(record, mesh, loops, certificate, is_boundary_of_solid));
  if(!options.is_quiet)
    show_text(printable(options.loops_file) + ": " +
                  praise(certificate, !CGAL::is_closed(mesh), is_boundary_of_solid) + "\n",
              false);
}

std::string praise_of_skeleton(const Skeleton_lines& skeleton, std::size_t genus) {
  return "the skeleton (" + counted(skeleton.points.size(), "point", "points") + ", " +
         counted(skeleton.edges.size(), "edge", "edges") +
         ") lies inside and does not intersect itself; " +
         (genus == 0   ? "it has no cycles, as there are no handles"
          : genus == 1 ? "its cycle is a basis of H1 of the solid"
                       : "its " + std::to_string(genus) + " cycles are a basis of H1 of the solid");
}

void check_skeleton(const Check_options& options, const Mesh& mesh, const Input_file& file) {
  const Skeleton_record record = read_skeleton(file);
  const std::array<std::size_t, 2> size = {mesh.number_of_vertices(), mesh.number_of_faces()};
  if(record.mesh_size && *record.mesh_size != size)
    require_none(options.loops_file, {mesh_difference(*record.mesh_size, size)});
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Answer loops = host_backend.solve(mesh, Solve_options(), bar);
  const auto certificate = certify_skeleton(mesh, record.lines, loops.pairs, throw_if_interrupted);
  const std::string taken_alone =
      certificate.taken_alone + (certificate.taken_alone.empty() ? "" : "\n");
  if(!certificate)
    require_none(options.loops_file, lines_of(taken_alone + certificate.failure));
  if(!options.is_quiet)
    show_text(taken_alone + printable(options.loops_file) + ": " +
                  praise_of_skeleton(record.lines, loops.statistics.genus) + "\n",
              false);
}

void run(const Check_options& options) {
  check_mesh_format(options.written_mesh_file);
  const Mended_mesh mended = read_mended_mesh(options);
  const Mesh& mesh = mended.mesh;
  write_read_mesh(options, mended);
  const Input_file file(options.loops_file);
  const std::size_t first = file.content().find_first_not_of(" \t\r\n");
  if(is_skeleton_file(file))
    check_skeleton(options, mesh, file);
  else if(first == std::string_view::npos || file.content()[first] != '{')
    fail_to_read(file.name(), "it is not JSON, and has none of the endings of skeletons: " +
                                  endings_of_skeletons());
  else
    check_loops(options, mesh, file);
}

constexpr char check_description[] =
    R"(Checks the loops or the curve skeleton in a file.

Loops must be a basis of H1(S; Z) of their mesh, and each tunnel loop must cross its handle loop
once (except in a shortest basis). The report counts the loops that bound inside and outside.

The certificate is computed from the two files alone. Everything else in the JSON must agree with
it: points, lengths, sizes, sides, linking numbers, the genus. All errors are listed, the worst
first. A loop that bounds on neither side is named, but is not an error. It is an error if the
handle loop and the tunnel loop of a pair are swapped.

A skeleton must lie strictly inside, except for ends in the middle of boundary curves. It must not
cross itself, and its cycles must be a basis of H1 of the solid, in each component separately. All
of this is decided exactly. The file is a .json of 'htloops skeleton', or any .obj (lines), .vtp
(text or uncompressed base64), .swc, .graphml (x, y, z) or .polylines.txt. Edges that leave the
solid are named by their points in the file, with the face, counted from 0, that they cross.
)";

constexpr char check_examples[] =
    R"(Exit codes: 0 certified, 1 the loops or the skeleton fail, 3 a file cannot be read, 4 the mesh is
not accepted.

Examples:
  htloops check cup.off cup.json && echo 'a basis'
  htloops check vessel.stl centerlines.vtp
)";

} // namespace

void add_check_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Check_options>();
  CLI::App* check = app.add_subcommand("check", check_description)->group("Commands");
  add_mesh_argument(*check, *options, "the mesh of the loops or the skeleton");
  add_input(*check, "FILE", options->loops_file,
            "loops written by 'htloops loops MESH -o', or a skeleton");
  add_remedy_options(*check, *options);
  check->add_flag("-q,--quiet", options->is_quiet, "print only errors")->group("What to show");
  complete_help(*check, check_examples);
  check->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
