// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OPTIONS_H
#define HTLOOPS_OPTIONS_H

#include "app/draw/lines.h"
#include "app/draw/pictures.h"
#include "app/draw/scenes.h"
#include "app/draw/view.h"
#include "app/mend/mesh_reader.h"
#include "app/mend/near_points.h"
#include "app/mesh_types.h"
#include "app/read/loops_reader.h"
#include "scene/scene.h"

#include <CGAL/Bbox_3.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

// The type, for `CLI::Option::type_name()`, of every option or argument that names a file.
constexpr char input_file[] = "input file";
constexpr char output_file[] = "output file";

/// throws `Failure` if an output of the commands that were asked for cannot be written, or would
/// overwrite an input or another output.
void check_files(const CLI::App& app);

/// says on the standard error that threads were asked for in vain, if they were.
void show_note_on_threads(const CLI::App& command);

// Options that are declared here stand in the help where `CLI::App::option_defaults()` says.

/// Options of all commands that read a mesh.
struct Mesh_options
{
  std::string mesh_file;
  std::string format; ///< of the file; empty if its name tells
  Remedies remedies;
  std::string written_mesh_file;
  bool is_quiet = false;

  bool is_mesh_on_standard_output() const { return written_mesh_file == "-"; }
};

/// what the mesh of most commands is: "triangle mesh", and the endings that are read.
std::string mesh_kinds(const std::string& what = "triangle mesh");

/// declares the mesh, which comes first, `what` it is.
void add_mesh_argument(CLI::App& command, Mesh_options& options, const std::string& what);

/// declares how its format is told if its name does not.
void add_format_option(CLI::App& command, Mesh_options& options);

/// declares which steps of the repair are to be done; asking for some asks for the repair.
void add_repair_steps(CLI::App& command, const char* name, Remedies& remedies);

/// declares within which length points are welded.
void add_weld_option(CLI::App& command, Remedies& remedies);

/// says on the standard error that a mesh is nearly welded, if it is.
void show_note(const std::string& file, const Near_boundary& found);

/// declares what may be done to it.
void add_remedy_options(CLI::App& command, Mesh_options& options);

/// the file that has the mesh; throws `Failure` if it cannot be read.
Input_file input_of(const Mesh_options& options);

/// reads the mesh and, unless it is to be quiet, says what has been done to it.
Mended_mesh read_mended_mesh(const Mesh_options& options, Input_file file);
Mended_mesh read_mended_mesh(const Mesh_options& options);

/// says on the standard error that a file of a mesh has no place for the unit of its lengths.
void show_note_on_unit(const Mesh_options& options,
                       const std::string& file,
                       const File_facts& facts);

/// writes the mesh that was read if that is asked for.
void write_read_mesh(const Mesh_options& options, const Mended_mesh& mended);

/// Options that the commands have that compute something on a mesh.
struct Common_options : Mesh_options
{
  std::string json_file;
  std::vector<std::string> lines_files;
  Picture_options picture;
  std::string page_file;
  std::string gltf_file;
  View view;
  int number_of_threads = 0;
};

/// a name as a shell takes it.
std::string quoted(const std::string& file);

/// a command that removes the handles of chosen pairs; `choice` is what precedes their numbers.
Choice command_to_remove(const Mesh_options& options, const std::string& choice = "--pairs");

/// that which was asked for; a row is flown to on pages only.
View view_of(const Common_options& options);

/// whether a picture or a page is asked for.
bool is_looked_at(const Common_options& options);

/// writes those that are asked for. The unit is that of the mesh, if the scene does not have it.
void show_scene(const Common_options& options, htl_scene::Scene scene, Unit unit = Unit::NONE);

// In each, `text` stands for the value in the help.

/// declares an option that names a file that is written; of several it takes one at a time.
template <typename Files>
CLI::Option* add_output(
    CLI::App& command, const char* name, const char* text, Files& files, const std::string& what) {
  return command.add_option(name, files, what)
      ->option_text(text)
      ->type_name(output_file)
      ->allow_extra_args(false);
}

/// declares the name of a file that is read, or of several, as what comes without the name of an
/// option.
template <typename Files>
void add_input(CLI::App& command, const char* name, Files& files, const std::string& what) {
  command.add_option(name, files, what)->option_text(" ")->type_name(input_file)->required();
}

/// declares one that takes one of some words.
template <typename Words = std::vector<std::string>>
CLI::Option* add_choice(CLI::App& command,
                        const char* name,
                        const char* text,
                        std::string& choice,
                        const std::string& what,
                        const Words& words) {
  return command.add_option(name, choice, what)->option_text(text)->check(CLI::IsMember(words));
}

/// declares one that takes so many numbers, with commas between them.
CLI::Option* add_numbers(CLI::App& command,
                         const char* name,
                         const char* text,
                         std::vector<double>& numbers,
                         int count,
                         const std::string& what);

/// declares one that takes a part of a whole, 0 to 1.
CLI::Option*
add_part(CLI::App& command, const char* name, std::optional<double>& part, const std::string& what);

/// declares one that takes what `parse_length()` understands.
CLI::Option*
add_length(CLI::App& command, const char* name, std::string& length, const std::string& what);

// Each declares some of them; `what` is "the loops", say.
void add_json_option(CLI::App& command, Common_options& options, const std::string& what);
void add_lines_option(CLI::App& command,
                      Common_options& options,
                      const std::string& what,
                      const std::string& formats = ".ply .obj .vtp .binary.vtp .polylines.txt");
void add_picture_options(CLI::App& command,
                         Common_options& options,
                         const std::string& what,
                         const std::string& opacity = "0.5, and more the more lines there are");
void add_closeup_option(CLI::App& command, Common_options& options);
void add_page_option(CLI::App& command, Common_options& options, const std::string& what);
void add_gltf_option(CLI::App& command, Common_options& options, const std::string& what);
void add_view_options(CLI::App& command, Common_options& options);
void add_threads_option(CLI::App& command, Common_options& options);

/// throws `Failure` if there are lines in no known format, as `check_lines` says, or if something
/// is to be seen from no direction.
void check_common_options(const Common_options& options,
                          void (*check_lines)(const std::string&) = check_lines_format);

/// throws `Failure` if the name of an output says that it is something else than it is: that is a
/// mistake.
void check_name(const std::string& file, const char* what, const std::vector<std::string>& ends);

/// for `CLI::Option::check()`: empty for a number without a sign, else what is wrong. Without it -5
/// would be a very large one.
std::string why_no_count(const std::string& text);

/// the same for a finite number. A range lets pass what is not a number, as it is neither below nor
/// above.
std::string why_not_finite(const std::string& text);

/// the same for one that is not negative.
std::string why_negative(const std::string& text);

/// the vertex that a number stands for; throws `Failure` if there is none, or if it has no face.
Mesh::Vertex_index vertex_of_mesh(const Mesh& mesh, std::uint32_t number);

/// prints a text on the standard output, or, if that is taken, on the other one.
void show_text(const std::string& text, bool is_output_taken);

/// whether a direction is none.
bool is_zero(const std::vector<double>& direction);

/// declares `--box`.
CLI::Option* add_box_option(CLI::App& command, std::vector<double>& box, const std::string& what);

/// the box that was given, if one was; throws `Failure` if its corners are in the wrong order.
std::optional<CGAL::Bbox_3> box_of(const std::vector<double>& box);

/// understands "0.25" and "3%", which is of the whole; throws `Failure`, naming the option, if the
/// text is no positive length. Nothing if there is none.
std::optional<double>
parse_length(const std::string& option, const std::string& text, double whole = 1.);

/// throws `Failure` if a length that `parse_length()` understands is more than the diagonal of a
/// mesh: often a percentage without its sign. `--yes` of `add_yes_option()` is for those who mean
/// it.
void check_length_of_mesh(const std::string& option, const std::string& text, double diagonal);
void add_yes_option(CLI::App& command,
                    bool& is_sure,
                    const std::string& options,
                    const std::string& more = "");

/// that more handles are left than `--genus` asks for; empty if there are not.
std::string words_of_missed_genus(const std::optional<std::size_t>& wanted, std::size_t genus);

/// says that so many handles may be below `--noise-below`.
std::string words_of_undecided(std::size_t number);

/// the lines, indented, each after a line break; not too many of them.
std::string indented(const std::vector<std::string>& lines);

/// throws the `Failure` of a file of loops if there are problems.
void require_none(const std::string& loops_file, const std::vector<std::string>& problems);

/// reads loops that lie on the mesh; throws `Failure` with all that speaks against it.
Bound_loops read_loops_on(const Mesh& mesh, const std::string& loops_file);

} // namespace htloops

#endif // HTLOOPS_OPTIONS_H
