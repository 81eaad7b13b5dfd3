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
#include "app/interrupt.h"
#include "app/solve/progress.h"
#include "commands/command.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace htloops {
namespace {

Mesh_line solve_one(Loops_options options, const std::string& file) {
  options.mesh_file = file;
  return line_of(file, [&] { return read_and_solve(options, false).second; });
}

// Where lines go, in the order of the meshes, as soon as those before are there.
class Line_printer
{
public:
  explicit Line_printer(const Loops_options& options)
      : options_(options) {
    if(!options.jsonl_file.empty())
      objects_.emplace(options.jsonl_file);
    if(!options.csv_file.empty())
      rows_.emplace(options.csv_file) << header_of_rows(options.kind_of_rows());
  }

  void add(std::size_t position, Mesh_line line) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_[position] = std::move(line);
    for(; next_ < waiting_.size() && waiting_[next_]; ++next_) {
      print(*waiting_[next_]);
      waiting_[next_].reset(); // loops take memory
    }
  }

  void finish() {
    if(objects_)
      objects_->finish();
    if(rows_)
      rows_->finish();
    if(number_of_failures_ > 0)
      throw Failure(static_cast<Exit_code>(exit_code_),
                    std::to_string(number_of_failures_) + " of " + std::to_string(waiting_.size()) +
                        " meshes have no answer");
  }

private:
  bool is_output_taken() const { return options_.jsonl_file == "-" || options_.csv_file == "-"; }

  void print(const Mesh_line& line) {
    if(line.exit_code != 0 && number_of_failures_++ == 0)
      exit_code_ = line.exit_code;
    if(objects_)
      write_mesh_line(*objects_, line);
    if(rows_)
      write_rows(*rows_, line, options_.kind_of_rows());
    if(!options_.is_quiet && !is_output_taken())
      show_text((next_ == 0 ? header_of_lines(options_.mesh_files) : "") +
                    row_of(line, options_.mesh_files),
                false);
    if(line.exit_code != 0)
      std::fputs(("htloops: " + line.error + "\n").c_str(), stderr);
  }

  const Loops_options& options_;
  std::mutex mutex_;
  std::vector<std::optional<Mesh_line>> waiting_ =
      std::vector<std::optional<Mesh_line>>(options_.mesh_files.size());
  std::size_t next_ = 0; // to be printed
  std::size_t number_of_failures_ = 0;
  int exit_code_ = 0; // of the first that failed
  std::optional<Text_writer> objects_, rows_;
};

// A mesh at a time in each of some threads, which share what threads there are besides.
void solve_all(Loops_options options, Line_printer& printer) {
  const std::size_t count = options.mesh_files.size();
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
  std::vector<std::thread> threads;
  for(int i = 1; i < jobs; ++i)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
  throw_if_interrupted();
  if(first_failure.exit_code != 0)
    throw Failure(static_cast<Exit_code>(first_failure.exit_code), first_failure.message);
}

} // namespace

void run_on_many_meshes(const Loops_options& options) {
  Line_printer printer(options);
  solve_all(options, printer);
  printer.finish();
}

} // namespace htloops
