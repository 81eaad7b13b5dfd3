// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/clean/soup_cleaning.h"
#include "app/draw/pages.h"
#include "app/draw/scenes.h"
#include "app/failure.h"
#include "app/file_names.h"
#include "app/numbers.h"
#include "app/words.h"
#include "app/write/clean_report.h"
#include "app/write/documents.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/vertex_values.h"
#include "terminal/terminal.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace htloops {
namespace {

/// The mesh that is written is the result, the JSON the report.
struct Clean_command_options : Common_options
{
  std::string result_file;
  std::string map_file;
  std::vector<std::string> skipped;
  std::string channels, floaters; // empty: as by default
  std::optional<std::size_t> genus;
  std::string noise_below;
  bool is_dry_run = false;
  bool is_sure = false;
};

std::map<std::string, Clean_step> steps_by_name() {
  std::map<std::string, Clean_step> steps;
  for(std::size_t i = 0; i < number_of_clean_steps; ++i)
    steps[name_of(static_cast<Clean_step>(i))] = static_cast<Clean_step>(i);
  return steps;
}

std::optional<Relative_length> relative_length(const char* option, const std::string& text) {
  const std::optional<double> length = parse_length(option, text);
  return length ? std::optional(Relative_length{*length, text.back() == '%'}) : std::nullopt;
}

// "0.02%"; none is small if it is 0%.
double share_of(const std::string& text) {
  double percent = -1.;
  const bool has_sign = !text.empty() && text.back() == '%';
  if(!has_sign || !parse_number(std::string_view(text).substr(0, text.size() - 1), percent) ||
     !(percent >= 0. && percent <= 100.))
    throw wrong_usage("--floaters: '" + text + "' is not a percentage up to 100%, such as 0.02%");
  return percent / 100.;
}

Clean_options clean_options(const Clean_command_options& options) {
  Clean_options result;
  const std::map<std::string, Clean_step> steps = steps_by_name();
  for(const std::string& name : options.skipped)
    result.steps.reset(static_cast<std::size_t>(steps.at(name)));
  result.channel_length = relative_length("--channels", options.channels);
  if(!options.floaters.empty())
    result.floater_share = share_of(options.floaters);
  result.genus = options.genus;
  result.noise_below = relative_length("--noise-below", options.noise_below);
  result.is_sure = options.is_sure;
  result.is_dry_run = options.is_dry_run;
  result.number_of_threads = options.number_of_threads;
  return result;
}

bool is_skipped(const Clean_command_options& options, Clean_step step) {
  return std::count(options.skipped.begin(), options.skipped.end(), name_of(step)) > 0;
}

// Who leaves a step out has nothing to say of it.
void check_skipped(const Clean_command_options& options) {
  const std::pair<const char*, bool> said[] = {{"--weld", options.remedies.weld.has_value()},
                                               {"--channels", !options.channels.empty()},
                                               {"--floaters", !options.floaters.empty()},
                                               {"--genus", options.genus.has_value()},
                                               {"--noise-below", !options.noise_below.empty()}};
  const Clean_step steps[] = {Clean_step::REPAIR, Clean_step::CHANNELS, Clean_step::FLOATERS,
                              Clean_step::HANDLES, Clean_step::HANDLES};
  for(std::size_t i = 0; i < std::size(said); ++i)
    if(said[i].second && is_skipped(options, steps[i]))
      throw wrong_usage(std::string(said[i].first) +
                        " is for a step that --skip leaves out: " + name_of(steps[i]));
}

void check(const Clean_command_options& options) {
  check_skipped(options);
  if(options.result_file.empty() && !options.is_dry_run)
    throw wrong_usage("OUT, the file for the result, is needed after the mesh, or --dry-run");
  check_mesh_format(options.result_file);
  check_name(options.json_file, "a report as JSON", {".json"});
  check_name(options.map_file, "a map as JSON", {".json"});
  check_name(options.page_file, "a page", {".html", ".htm"});
  if(!options.map_file.empty() && options.is_dry_run)
    throw wrong_usage(
        "--map describes the vertices of the written mesh: it cannot be combined with "
        "--dry-run");
}

void check_lengths(const Clean_command_options& options, const std::vector<Point>& points) {
  if(options.is_sure || points.empty())
    return;
  const double diagonal = diagonal_of(CGAL::bbox_3(points.begin(), points.end()));
  check_length_of_mesh("--channels", options.channels, diagonal);
  check_length_of_mesh("--noise-below", options.noise_below, diagonal);
}

Cleaned_soup cleaned(Soup soup, const Clean_command_options& options) {
  Progress_bar bar(!options.is_quiet && is_terminal(stderr));
  try {
    return clean(std::move(soup), clean_options(options), options.remedies.weld, bar);
  } catch(const Failure& failure) {
    if(failure.code() != Exit_code::UNACCEPTABLE_MESH)
      throw;
    throw Failure(failure.code(), printable(options.mesh_file) + ": " + failure.what() +
                                      (is_skipped(options, Clean_step::REPAIR)
                                           ? "\nthe step 'repair' may help: do not skip it"
                                           : ""));
  }
}

// The vertices of the result may be anywhere among those of the file.
Vertex_properties values_of(const Cleaned_soup& result, Vertex_properties properties) {
  spread_properties(result, properties);
  return properties;
}

void write_files(const Clean_command_options& options,
                 const Input_file& file,
                 const std::array<std::size_t, 2>& sizes,
                 const File_facts& facts,
                 const Cleaned_soup& result) {
  if(!options.is_dry_run) {
    const Vertex_properties properties =
        values_to_keep(file, facts, options.result_file, options.is_quiet);
    write_mesh(options.result_file, result.mesh, values_of(result, properties), "", facts);
    show_note_on_unit(options, options.result_file, facts);
    if(!options.map_file.empty())
      write_map_json(options.map_file, sizes[0], sizes[1], result);
  }
  if(!options.json_file.empty())
    write_clean_json(options.json_file, result);
  if(!options.page_file.empty())
    write_page(options.page_file, scene_of_cleaning(options.mesh_file, result.mended, result,
                                                    table_of_cleaning(result)));
}

void run(const Clean_command_options& options) {
  check(options);
  const Stopwatch stopwatch;
  const Input_file file = input_of(options);
  Soup soup = read_whole_soup(file);
  const File_facts facts = soup.facts;
  const std::array<std::size_t, 2> sizes = {soup.points.size(), soup.faces.size()};
  const double read_seconds = stopwatch.seconds();
  check_lengths(options, soup.points);
  const Cleaned_soup result = cleaned(std::move(soup), options);
  write_files(options, file, sizes, facts, result);
  if(!options.is_quiet)
    show_text(table_of_cleaning(result) + words_of_unit(facts.unit) +
                  formatted("%.2f s after %.2f s of reading\n", stopwatch.seconds() - read_seconds,
                            read_seconds) +
                  (options.is_dry_run ? "this was a dry run: no mesh was written\n" : ""),
              options.result_file == "-" || options.json_file == "-" || options.page_file == "-" ||
                  options.map_file == "-");
  std::string missed;
  if(!result.is_closed())
    missed = "the result is not closed: " +
             counted(result.after.boundaries, "boundary curve is", "boundary curves are") + " left";
  if(const std::string words = words_of_missed_genus(options.genus, result.after.genus);
     !words.empty())
    missed += (missed.empty() ? "" : ", and ") + words;
  for(const Clean_record& record : result.records)
    if(record.undecided > 0)
      missed += (missed.empty() ? "" : ", and ") + words_of_undecided(record.undecided);
  if(!missed.empty())
    throw Failure(Exit_code::UNACCEPTABLE_MESH,
                  missed + (options.is_dry_run ? "" : "; it was written all the same"));
}

constexpr char clean_description[] =
    R"(Turns a mesh into a closed solid, for example for a 3D printer.

It changes only what it can justify, and lists what it leaves. No point moves, and no new
crossing is made. The steps, in order (leave some out with --skip):
  repair    triangulates, welds close points, orients, makes manifold
  holes     closes boundary curves where a cap fits
  orient    turns over parts that are inside out
  channels  fills channels between an outer and an inner wall if they are short
            around and the inner wall becomes separate; if the volume would change
            by more than 5%, only with --channels or --yes
  floaters  drops small parts that touch no other part
  shells    drops parts that lie inside another part and cannot be seen from outside;
            if the volume would change by more than 5%, only with --yes
  handles   removes handles, only with --genus or --noise-below
)";

constexpr char clean_examples[] =
    R"(Exit codes: 0 the result is closed; 2 wrong usage; 3 the file cannot be read; 4 the result is
not closed, or --genus is not reached (it is written all the same), or the mesh cannot be repaired.

Examples:
  htloops clean model.glb solid.stl               remove inner walls and small parts
  htloops clean model.glb solid.stl --channels 3% also fill hollows that channels lead to
  htloops clean scan.stl clean.3mf --noise-below 0.5%
                                                  also remove small handles
  htloops clean part.stl --dry-run --html look.html
                                                  preview the changes
  htloops clean vase.obj vase.stl --yes           also fill closed hollows
)";

void add_options(CLI::App& clean, Clean_command_options& options) {
  add_mesh_argument(clean, options, mesh_kinds("any mesh"));
  CLI::Option* result =
      add_output(clean, "OUT", " ", options.result_file, "the solid:" + words_of_written_meshes());
  clean.option_defaults()->group("What to do");
  clean.add_option("--skip", options.skipped, "steps to leave out, separated by commas")
      ->option_text("STEP,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(steps_by_name()));
  add_weld_option(clean, options.remedies);
  add_length(
      clean, "--channels", options.channels,
      "largest circumference of a channel; %: of the diagonal of the\nbounding box; default: 3%");
  clean
      .add_option("--floaters", options.floaters,
                  "drop parts with less than this share of the volume, if together\n"
                  "they have less than five times that share; default: 0.02%")
      ->option_text("P%");
  CLI::Option* genus = clean
                           .add_option("--genus", options.genus,
                                       "remove the smallest handles, until genus G is left")
                           ->option_text("G")
                           ->check(why_no_count);
  add_length(clean, "--noise-below", options.noise_below,
             "remove handles whose thickness or clear width is less than this")
      ->excludes(genus);
  add_yes_option(clean, options.is_sure, "--channels or --noise-below",
                 "fill hollows that are more than 5% of the volume; ");
  add_threads_option(clean, options);
  clean.option_defaults()->group("What to write");
  add_output(clean, "-o,--output", "OUT", options.result_file, "the same as OUT after the mesh")
      ->excludes(result);
  clean.add_flag("--dry-run", options.is_dry_run, "do everything except writing the mesh");
  add_output(clean, "--report", "FILE.json", options.json_file, "what was done, as JSON");
  add_output(clean, "--map", "FILE.json", options.map_file,
             "the original vertex or face of each vertex and face, as JSON");
  add_page_option(clean, options, "the mesh before and after");
  clean.add_flag("-q,--quiet", options.is_quiet, "print only errors")->group("What to show");
}

} // namespace

void add_clean_command(CLI::App& app, Command& command) {
  const auto options = std::make_shared<Clean_command_options>();
  CLI::App* clean = app.add_subcommand("clean", clean_description)->group("Commands");
  add_options(*clean, *options);
  complete_help(*clean, clean_examples);
  clean->callback([options, &command] { command = [options] { run(*options); }; });
}

} // namespace htloops
