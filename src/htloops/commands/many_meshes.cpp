// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/loops_options.h"

#include "app/failure.h"
#include "app/file_names.h"
#include "app/interrupt.h"
#include "app/read/meshes/mesh_formats.h"
#include "app/solve/progress.h"
#include "app/system/files.h"
#include "commands/command.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace htloops {
namespace {

Mesh_line solve_one(Loops_options options, const std::string& file) {
  options.mesh_file = file;
  return line_of(file, [&] {
    std::error_code error;
    if(std::filesystem::is_directory(path_of(file), error))
      throw Failure(Exit_code::UNREADABLE_FILE, "the folder " + printable(file) +
                                                    " has no mesh files, which end in " +
                                                    words_of_mesh_endings());
    return read_and_solve(options, false).second;
  });
}

// Those of which nothing has been told, or not all.
std::vector<std::string> untold(const std::vector<std::string>& files, const Line_files& lines) {
  std::vector<std::string> rest;
  std::copy_if(files.begin(), files.end(), std::back_inserter(rest),
               [&lines](const std::string& file) { return !lines.has(file); });
  return rest;
}

// Whether there are files that another call can go on with.
bool has_lasting_lines(const Loops_options& options) {
  const auto lasts = [](const std::string& file) { return !file.empty() && file != "-"; };
  return lasts(options.csv_file) || lasts(options.jsonl_file);
}

// Tells of meshes, in their order, as soon as those before are there.
class Line_printer
{
public:
  Line_printer(const Loops_options& options, Line_files& lines)
      : options_(options)
      , lines_(lines) {}

  void add(std::size_t position, Mesh_line line) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_[position] = std::move(line);
    for(; next_ < waiting_.size() && waiting_[next_]; ++next_) {
      print(*waiting_[next_]);
      waiting_[next_].reset(); // loops take memory
    }
  }

  void finish() const {
    if(number_of_failures_ > 0)
      throw Failure(static_cast<Exit_code>(exit_code_),
                    std::to_string(number_of_failures_) + " of " + std::to_string(waiting_.size()) +
                        " meshes failed");
  }

private:
  bool is_output_taken() const { return options_.jsonl_file == "-" || options_.csv_file == "-"; }

  void print(const Mesh_line& line) {
    if(line.exit_code != 0 && number_of_failures_++ == 0)
      exit_code_ = line.exit_code;
    lines_.add(line);
    const Row_kind kind = options_.kind_of_rows();
    if(!options_.is_quiet && !is_output_taken())
      show_text((next_ == 0 ? header_of_lines(options_.mesh_files, kind) : "") +
                    row_of(line, options_.mesh_files, kind),
                false);
    if(line.exit_code != 0)
      std::fputs(("htloops: " + printable_lines(line.error) + "\n").c_str(), stderr);
  }

  const Loops_options& options_;
  Line_files& lines_;
  std::mutex mutex_;
  std::vector<std::optional<Mesh_line>> waiting_ =
      std::vector<std::optional<Mesh_line>>(options_.mesh_files.size());
  std::size_t next_ = 0; // to be printed
  std::size_t number_of_failures_ = 0;
  int exit_code_ = 0; // of the first that failed
};

// As many as can be had: the system, or what there is in its place, may refuse to start one.
std::vector<std::thread> started_threads(std::size_t number, const std::function<void()>& work) {
  std::vector<std::thread> threads;
  try {
    while(threads.size() < number)
      threads.emplace_back(work);
  } catch(const std::system_error&) {
  }
  return threads;
}

// A mesh at a time in each of some threads, which share what threads there are besides.
void solve_all(Loops_options options, Line_printer& printer) {
  const std::size_t count = options.mesh_files.size();
  if(count == 0)
    return;
  const auto jobs = static_cast<int>((std::min)(std::size_t(options.number_of_jobs), count));
  if(jobs > 1)
    options.number_of_threads =
        (std::max)(1, Thread_limit(options.number_of_threads).number_of_threads() - jobs + 1);
  std::atomic<std::size_t> next{0};
  Outcome first_failure;
  std::mutex mutex;
  const auto work = [&] {
    const Outcome outcome = outcome_of([&] {
      for(std::size_t i; (i = next++) < count;) {
        throw_if_interrupted();
        Mesh_line line = solve_one(options, options.mesh_files[i]);
        throw_if_interrupted(); // then it is no answer about the mesh
        printer.add(i, std::move(line));
      }
    });
    const std::lock_guard<std::mutex> lock(mutex);
    if(outcome.exit_code != 0) {
      next = count;
      first_failure = outcome;
    }
  };
  std::vector<std::thread> threads = started_threads(static_cast<std::size_t>(jobs - 1), work);
  if(!options.is_quiet && threads.size() + 1 < static_cast<std::size_t>(jobs))
    std::fprintf(stderr,
                 "htloops: only %zu of %d threads could be started: fewer meshes at a time\n",
                 threads.size() + 1, jobs);
  work();
  for(std::thread& thread : threads)
    thread.join();
  throw_if_interrupted();
  if(first_failure.exit_code != 0)
    throw Failure(static_cast<Exit_code>(first_failure.exit_code), first_failure.message);
}

} // namespace

void run_on_many_meshes(Loops_options options) {
  Line_files lines(options.csv_file, options.jsonl_file, options.kind_of_rows());
  const std::size_t number_of_all = options.mesh_files.size();
  if(options.do_resume) {
    lines.resume();
    options.mesh_files = untold(options.mesh_files, lines);
    if(!options.is_quiet)
      std::fprintf(stderr, "htloops: %zu of %zu meshes are already in the files\n",
                   number_of_all - options.mesh_files.size(), number_of_all);
  }
  Line_printer printer(options, lines);
  try {
    solve_all(options, printer);
  } catch(const Interrupted&) {
    if(!options.is_quiet && has_lasting_lines(options))
      std::fputs("htloops: use --resume to continue after the meshes that are in the files\n",
                 stderr);
    throw;
  }
  printer.finish();
}

} // namespace htloops
