// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/check/claims.h"
#include "app/file_names.h"
#include "app/words.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"
#include "terminal/terminal.h"

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace htloops {
namespace {

struct Check_options : Mesh_options
{
  std::string loops_file;
};

// What has been found to be right, and what is no failure but should be known.
std::string praise(const Checked_loops& checked, bool has_boundary) {
  const Certificate& certificate = checked.certificate;
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
  if(!checked.is_boundary_of_solid)
    remarks.push_back(
        "the surface touches or crosses itself: there is no inside or outside there, and "
        "linking numbers alone decide which loops bound");
  for(const auto& lines :
      {lines_of(certificate.failure), remarks_on_sides(certificate, checked.components)})
    remarks.insert(remarks.end(), lines.begin(), lines.end());
  return text + (certificate.pairing ? "; each tunnel loop crosses its handle loop once\n" : "\n") +
         summary_of_sides(certificate) + indented(remarks);
}

// What nobody has looked at, by the reason.
std::string words_on(const std::map<std::string, std::set<std::string>>& not_compared) {
  std::string words;
  for(const auto& [reason, keys] : not_compared) {
    words += words.empty() ? "\nnot checked: " : "; ";
    const char* separator = "";
    for(const std::string& key : keys)
      words += std::exchange(separator, ", ") + printable(key);
    words += " (" + reason + ")";
  }
  return words;
}

void check_loops_in(const Check_options& options,
                    const Mended_mesh& mended,
                    const Input_file& file) {
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Checked_loops checked = check_loops(file, mended, bar);
  bar.end();
  require_none(options.loops_file, checked.problems);
  if(!options.is_quiet)
    show_text(printable(options.loops_file) + ": " +
                  praise(checked, !CGAL::is_closed(mended.mesh)) + words_on(checked.not_compared) +
                  "\n",
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

void check_skeleton_in(const Check_options& options, const Mesh& mesh, const Input_file& file) {
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  const Checked_skeleton checked = check_skeleton(file, mesh, bar);
  bar.end();
  require_none(options.loops_file, checked.problems);
  if(!options.is_quiet)
    show_text(checked.taken_alone + printable(options.loops_file) + ": " +
                  praise_of_skeleton(checked.lines, checked.genus) +
                  words_on(checked.not_compared) + "\n",
              false);
}

void run(const Check_options& options) {
  check_mesh_format(options.written_mesh_file);
  const Mended_mesh mended = read_mended_mesh(options);
  write_read_mesh(options, mended);
  const Input_file file(options.loops_file);
  const std::size_t first = file.content().find_first_not_of(" \t\r\n");
  if(is_skeleton_file(file))
    check_skeleton_in(options, mended.mesh, file);
  else if(first == std::string_view::npos || file.content()[first] != '{')
    fail_to_read(file.name(), "it is not JSON, and has none of the endings of skeletons: " +
                                  endings_of_skeletons());
  else
    check_loops_in(options, mended, file);
}

constexpr char check_description[] =
    R"(Checks the loops or the curve skeleton in a file.

Loops must be a basis of H1(S; Z) of their mesh, and each tunnel loop must cross its handle loop
once (except in a shortest basis). The report counts the loops that bound inside and outside.

The certificate is computed from the two files alone. Every other value in the JSON is computed
again from the loops and the mesh, and must agree. The keys that the mesh does not determine, such
as timings, are listed as not checked. All errors are listed, the worst first. A loop that bounds
on neither side is named, but is not an error. It is an error if the handle loop and the tunnel
loop of a pair are swapped.

A skeleton must lie strictly inside, except for ends in the middle of boundary curves. It must not
cross itself, and its cycles must be a basis of H1 of the solid, in each piece separately. All of
this is decided exactly. The file is a .json of 'htloops skeleton', or any .obj (lines), .vtp
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
