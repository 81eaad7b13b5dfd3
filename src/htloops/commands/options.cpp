// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/options.h"

#include "app/draw/pages.h"
#include "app/failure.h"
#include "app/file_names.h"
#include "app/read/mesh_list.h"
#include "app/read/meshes/mesh_formats.h"
#include "app/read/sources.h"
#include "app/solve/progress.h"
#include "app/system/files.h"
#include "app/write/files.h"
#include "app/write/mesh_writer.h"
#include "app/write/pair_listing.h"
#include "app/write/tables.h"
#include "commands/usage_messages.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace htloops {
namespace {

namespace fs = std::filesystem;

struct Named_file
{
  std::string option;
  std::string name;
};

using Named_files = std::vector<Named_file>;

void collect(const CLI::App& command, const char* type, Named_files& files) {
  for(const CLI::Option* option : command.get_options())
    if(option->get_type_name() == type)
      for(const std::string& word : option->results())
        for(const std::string& name : type == input_file ? files_of(word) : std::vector{word})
          files.push_back({option->get_name(), name});
  for(const CLI::App* subcommand : command.get_subcommands())
    collect(*subcommand, type, files);
}

std::string path_of_input(const std::string& name) { return name == "-" ? "/dev/stdin" : name; }
std::string path_of_output(const std::string& name) { return name == "-" ? "/dev/stdout" : name; }

// Of two files that do not exist yet, where they would be tells. A device is not overwritten: a
// terminal may be read from and written to.
bool is_same_file(const std::string& name, const std::string& other) {
  std::error_code error;
  if(name == other)
    return true;
  if(fs::is_character_file(path_of(name), error))
    return false;
  return fs::equivalent(path_of(name), path_of(other), error) ||
         destination_of(name) == destination_of(other);
}

void check_differ(const Named_file& file, const std::string& path, const Named_file& output) {
  if(is_same_file(path, path_of_output(output.name)))
    throw wrong_usage(file.option + " " + printable(file.name) + " and " + output.option + " " +
                      printable(output.name) + " name the same file, which would be overwritten");
}

// As of a variable of the shell that is not set.
void check_has_name(const Named_file& file) {
  if(file.name.empty())
    throw wrong_usage(file.option + ": the name of the file is empty");
}

// As what follows -o in "-o -q".
void check_is_no_option(const Named_file& output) {
  if(output.name.size() > 1 && output.name.front() == '-')
    throw wrong_usage(output.option + " " + words_of_dash(output.name));
}

void check_picture(const Picture_options& picture) {
  check_name(picture.file, "a PNG picture", {".png"});
  if((picture.has_labels || picture.has_legend) && !can_write_on_pictures())
    throw wrong_usage("--labels and --legend need a build with stb and the DejaVu fonts");
}

void add_word_options(CLI::App& command, Picture_options& picture) {
  command
      .add_flag("--labels", picture.has_labels,
                "with --picture: write numbers beside the visible lines, the smallest first; for\n"
                "handles, the diameters too")
      ->needs("--picture");
  command
      .add_flag("--legend", picture.has_legend,
                "with --picture: add a key to the colors of the lines, and a scale")
      ->needs("--picture");
}

} // namespace

void check_files(const CLI::App& app) {
  Named_files inputs, outputs;
  collect(app, input_file, inputs);
  collect(app, output_file, outputs);
  for(const Named_files* files : {&inputs, &outputs})
    std::for_each(files->begin(), files->end(), check_has_name);
  for(auto output = outputs.begin(); output != outputs.end(); ++output) {
    for(const Named_file& input : inputs)
      check_differ(input, path_of_input(input.name), *output);
    for(auto other = outputs.begin(); other != output; ++other)
      check_differ(*other, path_of_output(other->name), *output);
    check_is_no_option(*output);
    check_writable(output->name);
  }
}

void show_note_on_threads(const CLI::App& command) {
  const CLI::Option* const threads = command.get_option_no_throw("--threads");
  if(CGAL::Handle_tunnel_loops::internal::has_threads || threads == nullptr || threads->empty() ||
     threads->as<int>() == 1 || command.count("--quiet") > 0)
    return;
  std::fputs("htloops: built without threads: --threads changes nothing\n", stderr);
}

void add_mesh_argument(CLI::App& command, Mesh_options& options, const std::string& what) {
  add_input(command, "MESH", options.mesh_file, what);
  add_format_option(command, options);
}

std::string mesh_kinds(const std::string& what) {
  return what + ", packed by gzip (.gz) or not:\n" + words_of_mesh_endings();
}

void add_format_option(CLI::App& command, Mesh_options& options) {
  std::vector<std::string> formats; // as the endings, without the dot
  for(const std::string& ending : endings_of_meshes())
    formats.push_back(ending.substr(1));
  add_choice(command, "--format", "FORMAT", options.format,
             "format of the mesh, whatever its file name; required if MESH is - (standard\n"
             "input): " +
                 boost::algorithm::join(formats, " "),
             formats)
      ->group("What to read");
}

void add_repair_steps(CLI::App& command, const char* name, Remedies& remedies) {
  std::map<std::string, Repair_step> steps;
  for(std::size_t i = 0; i < number_of_repair_steps; ++i)
    steps[name_of(static_cast<Repair_step>(i))] = static_cast<Repair_step>(i);
  const auto take = [&remedies, steps](const std::vector<std::string>& names) {
    remedies.do_repair = true;
    remedies.steps.reset();
    for(const std::string& step : names)
      remedies.steps.set(static_cast<std::size_t>(steps.at(step)));
  };
  command
      .add_option_function<std::vector<std::string>>(
          name, take, "only these steps of the repair, separated by commas")
      ->option_text("STEP,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(steps));
}

void add_weld_option(CLI::App& command, Remedies& remedies) {
  const auto take = [&remedies](const std::string& text) {
    remedies.weld = {*parse_length("--weld", text), text.back() == '%'};
  };
  command
      .add_option_function<std::string>(
          "--weld", take,
          "merge vertices of open edges that are at most this far apart; a percentage is\n"
          "of the diagonal of the bounding box. Refused if the result\n"
          "would not be a surface")
      ->option_text("L|P%")
      ->check([](const std::string& text) -> std::string {
        try {
          return parse_length("the length", text) ? "" : "no length";
        } catch(const Failure& failure) {
          return failure.what();
        }
      });
}

void add_remedy_options(CLI::App& command, Mesh_options& options) {
  command.option_defaults()->group("If the mesh is not acceptable as it is");
  command.add_flag("--triangulate", options.remedies.do_triangulate,
                   "split faces with more than three corners into triangles");
  command.add_flag("--repair", options.remedies.do_repair,
                   "weld points, drop degenerate and duplicate faces, split non-manifold edges\n"
                   "and vertices, reorient faces; reports what it did");
  add_repair_steps(command, "--repair-steps", options.remedies);
  add_weld_option(command, options.remedies);
  add_output(command, "--write-mesh", "FILE", options.written_mesh_file,
             "the mesh after these steps, which the results refer to:" + words_of_written_meshes());
}

Input_file input_of(const Mesh_options& options) {
  if(options.mesh_file == "-" && options.format.empty())
    throw wrong_usage(
        "standard input has no file name: give its format, for example with --format off");
  return Input_file(options.mesh_file, options.format);
}

void show_note(const std::string& file, const Near_boundary& found) {
  if(!found.words().empty())
    std::fputs(("htloops: note: " + file + ": " + found.words() + "\n").c_str(), stderr);
}

void show_note_on_unit(const Mesh_options& options,
                       const std::string& file,
                       const File_facts& facts) {
  if(!options.is_quiet && facts.unit != Unit::NONE && !has_unit(file))
    std::fprintf(stderr, "htloops: note: %s: the format cannot store the unit (%s)%s\n",
                 file == "-" ? "the standard output" : printable(file).c_str(),
                 words_of(facts.unit).name,
                 boost::algorithm::iends_with(file, ".stl") && facts.unit != Unit::MILLIMETER
                     ? "; most programs take its numbers for millimeters; .3mf keeps the unit"
                     : "");
}

namespace {

void show_changes(const Mesh_options& options, const std::string& file, const Mended_mesh& mended) {
  if(options.is_quiet)
    return;
  if(options.remedies.any())
    std::fputs(table_of_changes(file, mended.changes).c_str(), stderr);
  show_note(file, near_boundary_of(mended.mesh));
}

} // namespace

Mended_mesh read_mended_mesh(const Mesh_options& options, Input_file file) {
  const std::string name = file.name();
  Mended_mesh mended = read_mesh(std::move(file), options.remedies);
  show_changes(options, name, mended);
  return mended;
}

Mended_mesh read_mended_mesh(const Mesh_options& options) {
  return read_mended_mesh(options, input_of(options));
}

void write_read_mesh(const Mesh_options& options, const Mended_mesh& mended) {
  if(options.written_mesh_file.empty())
    return;
  write_mesh(options.written_mesh_file, mended.mesh, {}, "", mended.facts);
  show_note_on_unit(options, options.written_mesh_file, mended.facts);
}

std::string quoted(const std::string& file) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("._/-+=,@%:", c) != nullptr;
  };
  if(std::all_of(file.begin(), file.end(), is_plain))
    return file;
  return "'" + boost::algorithm::replace_all_copy(file, "'", "'\\''") + "'";
}

namespace {

// A file with such a name would be taken for an option.
std::string quoted_name(const std::string& file) {
  return quoted(file[0] == '-' ? "./" + file : file);
}

// What 'htloops remove' is told of a mesh: its name, its format, and what is done to it first.
std::string words_of_mesh(const Mesh_options& options) {
  const Remedies& remedies = options.remedies;
  std::string text = quoted_name(options.mesh_file);
  if(!options.format.empty())
    text += " --format " + options.format;
  if(remedies.do_triangulate)
    text += " --triangulate";
  if(remedies.do_repair && remedies.steps.all())
    text += " --repair";
  else if(remedies.do_repair) {
    std::vector<std::string> steps;
    for(std::size_t i = 0; i < number_of_repair_steps; ++i)
      if(remedies.steps.test(i))
        steps.emplace_back(name_of(static_cast<Repair_step>(i)));
    text += " --repair-steps " + boost::algorithm::join(steps, ",");
  }
  if(remedies.weld)
    text += remedies.weld->is_share ? formatted(" --weld %.15g%%", 100. * remedies.weld->value)
                                    : formatted(" --weld %.17g", remedies.weld->value);
  return text;
}

} // namespace

Choice command_to_remove(const Mesh_options& options, const std::string& choice) {
  if(options.mesh_file == "-") // nobody knows where the mesh came from
    return {choice + ' ', ""};
  const std::filesystem::path mesh = path_of(options.mesh_file);
  return {"htloops remove " + words_of_mesh(options) + ' ' + choice + ' ',
          " -o " + quoted_name(printable(mesh.stem().string()) + "_without_them.ply")};
}

View view_of(const Common_options& options) {
  View view = options.view;
  view.is_for_rows = !options.page_file.empty();
  view.number_of_threads = options.number_of_threads;
  return view;
}

bool is_looked_at(const Common_options& options) {
  return !options.picture.file.empty() || !options.page_file.empty();
}

void show_scene(const Common_options& options, htl_scene::Scene scene, Unit unit) {
  const Thread_limit limit(options.number_of_threads);
  if(unit != Unit::NONE)
    scene.unit = words_of(unit).sign;
  if(!options.picture.file.empty()) {
    Picture_options picture = options.picture;
    picture.is_view_given = !options.view.from.empty();
    export_picture(picture, scene);
  }
  if(!options.page_file.empty())
    write_page(options.page_file, scene);
}

CLI::Option* add_numbers(CLI::App& command,
                         const char* name,
                         const char* text,
                         std::vector<double>& numbers,
                         int count,
                         const std::string& what) {
  return command.add_option(name, numbers, what)
      ->option_text(text)
      ->delimiter(',')
      ->expected(count)
      ->check(why_not_finite);
}

CLI::Option* add_part(CLI::App& command,
                      const char* name,
                      std::optional<double>& part,
                      const std::string& what) {
  return command.add_option(name, part, what)
      ->option_text("PART")
      ->check(CLI::Range(0., 1.))
      ->check(why_not_finite);
}

CLI::Option*
add_length(CLI::App& command, const char* name, std::string& length, const std::string& what) {
  return command.add_option(name, length, what)
      ->option_text("L|P%")
      ->check([](const std::string& text) { return std::string(text.empty() ? "no length" : ""); });
}

void add_json_option(CLI::App& command, Common_options& options, const std::string& what) {
  add_output(command, "-o,--output", "FILE.json", options.json_file,
             what + " as JSON; - is standard output");
}

void add_lines_option(CLI::App& command,
                      Common_options& options,
                      const std::string& what,
                      const std::string& formats) {
  add_output(command, "--lines", "FILE", options.lines_files,
             what + " as lines: " + formats + "; repeatable");
}

void add_picture_options(CLI::App& command,
                         Common_options& options,
                         const std::string& what,
                         const std::string& opacity) {
  if(!has_pictures)
    return;
  add_output(command, "--picture", "FILE.png", options.picture.file,
             "a picture of the mesh and " + what);
  command
      .add_option("--size", options.picture.size,
                  "size of the picture in pixels, also as WxH; default: 1600,1200")
      ->option_text("W,H")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(16, 16384))
      ->check(why_not_finite)
      ->needs("--picture");
  add_part(command, "--opacity", options.picture.opacity,
           "opacity of the surface in front of lines, 0 to 1 (1 hides them);\ndefault: " + opacity)
      ->needs("--picture");
  add_word_options(command, options.picture);
}

void add_closeup_option(CLI::App& command, Common_options& options) {
  if(has_pictures)
    command
        .add_option(
            "--closeup", options.picture.closeup,
            "with --picture: show one pair enlarged, with what hides it cut away, and where\n"
            "it is on the mesh")
        ->option_text("PAIR")
        ->check(why_no_count)
        ->needs("--picture");
}

void add_page_option(CLI::App& command, Common_options& options, const std::string& what) {
  add_output(command, "--html", "FILE.html", options.page_file,
             "a page for a browser that shows " + what);
}

void add_gltf_option(CLI::App& command, Common_options& options, const std::string& what) {
  add_output(command, "--gltf", "FILE.glb", options.gltf_file,
             what + " as tubes, with the mesh, as glTF");
}

void add_view_options(CLI::App& command, Common_options& options) {
  add_numbers(command, "--view", "X,Y,Z", options.view.from, 3,
              "direction to look from; default: the one that shows the loops best, the small\n"
              "ones above all, or spreads the arcs most");
  add_numbers(command, "--up", "X,Y,Z", options.view.up, 3,
              "upward direction; default: z, or another axis on which the mesh stands");
}

void add_threads_option(CLI::App& command, Common_options& options) {
  constexpr int largest_number_of_threads = 1024;
  command
      .add_option("--threads", options.number_of_threads,
                  "threads to use, 1 to " + std::to_string(largest_number_of_threads) +
                      "; default: one per core")
      ->option_text("N")
      ->check(CLI::Range(1, largest_number_of_threads));
}

void check_common_options(const Common_options& options, void (*check_lines)(const std::string&)) {
  check_mesh_format(options.written_mesh_file);
  for(const auto& [name, direction] :
      {std::pair("--view", options.view.from), std::pair("--up", options.view.up)})
  {
    if(direction.empty())
      continue;
    if(is_zero(direction))
      throw wrong_usage(std::string(name) + " 0,0,0 is not a direction");
    if(!is_looked_at(options))
      throw wrong_usage(std::string(name) + " sets the direction of view: it needs " +
                        (has_pictures ? "--picture or --html" : "--html"));
  }
  check_name(options.json_file, "JSON", {".json"});
  check_name(options.page_file, "a page in HTML", {".html", ".htm"});
  check_picture(options.picture);
  check_picture_size(options.picture);
  for(const std::string& file : options.lines_files)
    check_lines(file);
  check_suffix(options.gltf_file, ".glb");
}

void check_name(const std::string& file, const char* what, const std::vector<std::string>& ends) {
  const std::string extension = name_of_path(path_of(file).extension());
  const auto is_extension = [&extension](const std::string& end) {
    return boost::algorithm::iequals(extension, end);
  };
  if(!extension.empty() && std::none_of(ends.begin(), ends.end(), is_extension))
    throw wrong_usage("cannot write " + printable(file) + ": the content is " + what +
                      ", so the name must end in " + boost::algorithm::join(ends, " or ") +
                      ", or have no ending");
}

std::string why_no_count(const std::string& text) {
  const bool is_count = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isdigit(c) != 0;
  });
  return !is_count          ? text + " is not a non-negative integer"
         : text.size() < 19 ? ""
                            : text + " is too large";
}

std::string why_not_finite(const std::string& text) {
  double number;
  const bool is_finite = CLI::detail::lexical_cast(text, number) && std::isfinite(number);
  return is_finite ? "" : text + " is not a finite number";
}

std::string why_negative(const std::string& text) {
  std::string why = why_not_finite(text);
  if(double number; why.empty() && CLI::detail::lexical_cast(text, number) && number < 0.)
    why = text + " is negative";
  return why;
}

Mesh::Vertex_index vertex_of_mesh(const Mesh& mesh, std::uint32_t number) {
  const std::string name = "vertex " + std::to_string(number);
  if(number >= mesh.number_of_vertices())
    throw wrong_usage(name + " does not exist: the mesh has " +
                      std::to_string(mesh.number_of_vertices()) + " vertices, numbered from 0");
  const Mesh::Vertex_index v(number);
  if(mesh.is_isolated(v))
    throw wrong_usage(name + " belongs to no face");
  return v;
}

void show_text(const std::string& text, bool is_output_taken) {
  if(is_output_taken)
    std::fputs(text.c_str(), stderr);
  else
    write_text("-", text);
}

bool is_zero(const std::vector<double>& direction) {
  return std::all_of(direction.begin(), direction.end(), [](double x) { return x == 0.; });
}

CLI::Option* add_box_option(CLI::App& command, std::vector<double>& box, const std::string& what) {
  return add_numbers(command, "--box", "x,y,z,X,Y,Z", box, 6,
                     what + " with a loop that lies in a box");
}

std::optional<CGAL::Bbox_3> box_of(const std::vector<double>& box) {
  if(box.empty())
    return std::nullopt;
  for(std::size_t i = 0; i < 3; ++i)
    if(!(box[i] <= box[i + 3]))
      throw wrong_usage("--box: the lower corner comes first, then the upper one");
  return CGAL::Bbox_3(box[0], box[1], box[2], box[3], box[4], box[5]);
}

std::optional<double>
parse_length(const std::string& option, const std::string& text, double whole) {
  if(text.empty())
    return std::nullopt;
  std::string_view number = text;
  const bool is_percentage = number.back() == '%';
  number.remove_suffix(is_percentage ? 1 : 0);
  double length = 0.;
  Text_source cursor(option, number);
  if(!cursor.read(length) || cursor.skip_to_content() || !(length > 0.) || !std::isfinite(length))
    throw wrong_usage(option + " " + text +
                      ": neither a length, such as 0.25, nor a percentage of the " +
                      "diagonal of the bounding box, such as 3%");
  return is_percentage ? length / 100. * whole : length;
}

void check_length_of_mesh(const std::string& option, const std::string& text, double diagonal) {
  const auto length = parse_length(option, text, diagonal);
  if(!length || !(*length > diagonal)) // as also where it is not a number
    return;
  const bool has_sign = text.back() == '%';
  throw wrong_usage(option + " " + text + " is more than the diagonal of the bounding box, " +
                    formatted("%.6g", diagonal) + ". " +
                    (has_sign || *length > 100. ? "" : "Did you mean " + text + "%? ") +
                    "Use --yes to do it anyway");
}

void add_yes_option(CLI::App& command,
                    bool& is_sure,
                    const std::string& options,
                    const std::string& more) {
  command.add_flag("--yes", is_sure,
                   more + "accept a length of " + options + " that is\n" +
                       "more than the diagonal of the bounding box, or of --noise-below above\n"
                       "5% of it (usually a forgotten %) or across a wide gap between sizes");
}

std::string indented(const std::vector<std::string>& lines) {
  constexpr std::size_t largest_number_of_lines = 10;
  std::string text;
  for(std::size_t i = 0; i < lines.size() && i < largest_number_of_lines; ++i)
    text += "\n  " + lines[i];
  if(lines.size() > largest_number_of_lines)
    text += "\n  and " + std::to_string(lines.size() - largest_number_of_lines) + " more";
  return text;
}

void require_none(const std::string& loops_file, const std::vector<std::string>& problems) {
  if(!problems.empty())
    throw Failure(Exit_code::NOT_CERTIFIED,
                  printable(loops_file) + " fails its certificate:" + indented(problems));
}

std::string words_of_undecided(std::size_t number) {
  return "it is undecided whether " + counted(number, "handle is", "handles are") +
         " below --noise-below";
}

std::string words_of_missed_genus(const std::optional<std::size_t>& wanted, std::size_t genus) {
  return !wanted || genus <= *wanted
             ? ""
             : "genus " + std::to_string(genus) + " is left, not " + std::to_string(*wanted);
}

Bound_loops read_loops_on(const Mesh& mesh, const std::string& loops_file) {
  Bound_loops loops = bind_loops(read_loops_json(loops_file), mesh);
  require_none(loops_file, loops.problems);
  return loops;
}

} // namespace htloops
