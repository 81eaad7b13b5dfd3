// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/failure.h"
#include "app/file_names.h"
#include "app/interrupt.h"
#include "app/read/soup_diagnosis.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace htloops {
namespace {

struct Repair_options : Mesh_options // the mesh that is written is the result
{
  bool is_dry_run = false;
};

CGAL::Handle_tunnel_loops::generators::Soup triangles_of(const Soup& soup) {
  CGAL::Handle_tunnel_loops::generators::Soup triangles;
  for(const Point& p : soup.points)
    triangles.points.push_back({p.x(), p.y(), p.z()});
  for(const Soup_face& face : soup.faces)
    triangles.triangles.push_back({face[0], face[1], face[2]});
  return triangles;
}

bool are_triangles(const Soup& soup) {
  return std::all_of(soup.faces.begin(), soup.faces.end(),
                     [](const Soup_face& face) { return face.is_triangle(); });
}

// What is wrong in the end is said after what was done.
void require_fit(const std::string& file,
                 const std::vector<Defect>& defects,
                 bool are_triangles,
                 const std::string& what_was_written) {
  if(defects.empty())
    return;
  std::string text =
      printable(file) + " is still not an oriented triangle manifold after the repair:";
  for(const Defect& defect : defects)
    text += "\n  " + defect.message;
  if(!are_triangles)
    text += "\nadd --triangulate";
  text += what_was_written;
  throw Failure(Exit_code::UNACCEPTABLE_MESH, text);
}

void run(const Repair_options& options) {
  if(options.written_mesh_file.empty() && !options.is_dry_run)
    throw wrong_usage("-o OUT is needed, or --dry-run");
  check_mesh_format(options.written_mesh_file);
  const Input_file file = input_of(options);
  const Mended_soup mended = mend(read_whole_soup(file), options.remedies);
  const Built_mesh built = build_mesh(mended.soup);
  const std::vector<Defect>& defects = built.defects;
  throw_if_interrupted();
  if(!options.is_quiet && !(mended.changes.empty() && !defects.empty()))
    std::fputs(table_of_changes(file.name(), mended.changes, options.is_dry_run).c_str(), stderr);
  const bool are_all_triangles = are_triangles(mended.soup);
  const bool is_written = !options.is_dry_run && are_all_triangles && !mended.soup.faces.empty();
  if(is_written) {
    write_mesh(options.written_mesh_file, triangles_of(mended.soup), mended.soup.facts);
    show_note_on_unit(options, options.written_mesh_file, mended.soup.facts);
  }
  require_fit(file.name(), defects, are_all_triangles,
              options.is_dry_run ? ""
              : is_written       ? "\nit was written all the same"
                                 : "\nnothing was written");
  if(!options.is_quiet)
    show_note(file.name(), near_boundary_of(built.mesh));
}

constexpr char repair_description[] =
    R"(Turns any mesh into an oriented manifold: reports what it did, and writes the mesh.

The steps, in order (choose some of them with --steps):
  degenerate  drop faces that use a vertex twice (also done by the steps after 'weld')
  weld        merge vertices at exactly the same place, along open edges
  duplicates  drop repeated faces, and flaps without thickness
  one-sided   drop components that are not orientable, if there are others
  pillows     drop components of two faces
  orient      turn faces over until neighbors agree
  split       split edges with more than two faces, vertices with more than one fan
              of faces, and edges beside others

Vertices keep their numbers; new ones follow them, and unused ones stay. The report compares
the two meshes: a vertex that is welded and split again as before is not counted.
)";

constexpr char repair_examples[] =
    R"(Exit codes: 0 all commands accept the result; 4 they do not: it is written all the same
if it has only triangles.

Examples:
  htloops repair soup.stl -o sound.off            all steps
  htloops repair soup.obj --triangulate --dry-run report only
  htloops repair soup.off --steps weld,orient -o welded.off
  htloops repair scan.stl --weld 0.001% -o sound.stl
                                                  also weld points that are close together
)";

} // namespace

void add_repair_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Repair_options>();
  options->remedies.do_repair = true;
  CLI::App* repair = app.add_subcommand("repair", repair_description)->group("Commands");
  add_mesh_argument(*repair, *options, mesh_kinds("any mesh"));
  repair->option_defaults()->group("What to do");
  add_output(*repair, "-o,--output", "OUT", options->written_mesh_file,
             "the repaired mesh:" + words_of_written_meshes());
  repair->add_flag("--dry-run", options->is_dry_run, "report what would be done, write nothing");
  repair->add_flag("--triangulate", options->remedies.do_triangulate,
                   "also split faces with more than three corners into triangles");
  add_repair_steps(*repair, "--steps", options->remedies);
  add_weld_option(*repair, options->remedies);
  repair->add_flag("-q,--quiet", options->is_quiet, "print only errors")->group("What to show");
  complete_help(*repair, repair_examples);
  repair->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
