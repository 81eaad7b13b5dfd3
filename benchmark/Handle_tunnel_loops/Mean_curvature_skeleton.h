// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_MEAN_CURVATURE_SKELETON_H
#define BENCHMARK_MEAN_CURVATURE_SKELETON_H

#include "Lines_in_space.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <cstddef>
#include <ctime>
#include <iterator>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

/// \file Mean_curvature_skeleton.h
/// `CGAL::extract_mean_curvature_flow_skeleton()`, in a process that may fail or be stopped.

struct Timed_lines
{
  Lines_in_space lines;
  double seconds = 0.;
};

/// bytes written and read one after the other.
class Byte_stream
{
public:
  explicit Byte_stream(std::string bytes = {})
      : bytes_(std::move(bytes)) {}

  template <typename T> void write(const T* values, std::size_t number) {
    bytes_.append(reinterpret_cast<const char*>(values), number * sizeof(T));
  }

  template <typename T> bool read(T* values, std::size_t number) {
    const std::size_t size = number * sizeof(T);
    if(bytes_.size() - at_ < size)
      return false;
    bytes_.copy(reinterpret_cast<char*>(values), size, at_);
    at_ += size;
    return true;
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
  std::size_t at_ = 0;
};

/// the bytes that a function makes in a process of its own, which may take so many seconds of the
/// processor; as many as there were if it takes longer, or fails.
template <typename Function>
std::string bytes_of_child(unsigned most_seconds, const Function& make_bytes) {
  int ends[2];
  if(pipe(ends) != 0)
    return {};
  const pid_t child = fork();
  if(child == 0) {
    const rlimit limit = {most_seconds, most_seconds};
    setrlimit(RLIMIT_CPU, &limit);
    try {
      const std::string bytes = make_bytes();
      for(std::size_t sent = 0; sent < bytes.size();) {
        const auto n = write(ends[1], bytes.data() + sent, bytes.size() - sent);
        if(n <= 0)
          _exit(1);
        sent += static_cast<std::size_t>(n);
      }
    } catch(...) {
      _exit(1);
    }
    _exit(0);
  }
  close(ends[1]);
  std::string bytes;
  char buffer[4096];
  for(ssize_t n = 0; child > 0 && (n = read(ends[0], buffer, sizeof(buffer))) > 0;)
    bytes.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  return bytes;
}

inline std::string bytes_of(const Timed_lines& answer) {
  const std::size_t sizes[] = {answer.lines.points.size(), answer.lines.edges.size()};
  Byte_stream stream;
  stream.write(&answer.seconds, 1);
  stream.write(sizes, 2);
  for(const Point& p : answer.lines.points) {
    const double xyz[] = {p.x(), p.y(), p.z()};
    stream.write(xyz, 3);
  }
  stream.write(answer.lines.edges.data(), sizes[1]);
  return stream.bytes();
}

inline std::optional<Timed_lines> lines_of_bytes(std::string bytes) {
  Byte_stream stream(std::move(bytes));
  Timed_lines answer;
  std::size_t sizes[2];
  if(!stream.read(&answer.seconds, 1) || !stream.read(sizes, 2))
    return std::nullopt;
  double xyz[3];
  for(std::size_t i = 0; i < sizes[0] && stream.read(xyz, 3); ++i)
    answer.lines.points.emplace_back(xyz[0], xyz[1], xyz[2]);
  answer.lines.edges.resize(sizes[1]);
  if(!stream.read(answer.lines.edges.data(), sizes[1]))
    return std::nullopt;
  return answer;
}

/// the skeletons of components, one by one, as the algorithm is for connected surfaces.
inline Timed_lines mean_curvature_lines(const std::vector<Solid_mesh>& components) {
  Timed_lines answer;
  for(const Solid_mesh& mesh : components) {
    CGAL::Mean_curvature_flow_skeletonization<Solid_mesh>::Skeleton skeleton;
    const std::clock_t began = std::clock();
    CGAL::extract_mean_curvature_flow_skeleton(mesh, skeleton);
    answer.seconds += double(std::clock() - began) / CLOCKS_PER_SEC;
    const Lines_in_space lines = lines_of(skeleton);
    const std::size_t first = answer.lines.points.size();
    answer.lines.points.insert(answer.lines.points.end(), lines.points.begin(), lines.points.end());
    for(const auto& [a, b] : lines.edges)
      answer.lines.edges.push_back({first + a, first + b});
  }
  return answer;
}

/// the same, unless it fails or takes longer.
inline std::optional<Timed_lines>
mean_curvature_lines_within(unsigned seconds, const std::vector<Solid_mesh>& components) {
  return lines_of_bytes(
      bytes_of_child(seconds, [&] { return bytes_of(mean_curvature_lines(components)); }));
}

#endif // BENCHMARK_MEAN_CURVATURE_SKELETON_H
