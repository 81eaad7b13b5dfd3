// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "encoding.h"

#include "packing.h"

namespace htl_window {
namespace {

// The triangles around each vertex: those of v are from begin[v] to begin[v + 1].
struct Stars
{
  explicit Stars(const Surface& surface)
      : begin(surface.points.size() + 1)
      , triangles(3 * surface.triangles.size()) {
    for(const Triangle& triangle : surface.triangles)
      for(const std::uint32_t v : triangle)
        ++begin[v];
    std::size_t sum = 0;
    for(std::size_t& end : begin)
      end = sum += end;
    // From the last on, so that each begins where it ends, and ends in order.
    for(std::size_t t = surface.triangles.size(); t-- > 0;)
      for(const std::uint32_t v : surface.triangles[t])
        triangles[--begin[v]] = static_cast<std::uint32_t>(t);
  }

  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> triangles;
};

class Surface_encoder
{
public:
  Surface_encoder(const Surface& surface, const Grid& grid)
      : surface_(surface)
      , grid_(grid)
      , stars_(surface)
      , number_(surface.points.size(), unmet)
      , is_done_(surface.triangles.size(), false) {}

  Encoded_surface encode() {
    std::size_t next = 0; // number whose triangles come next
    for(const Triangle& triangle : surface_.triangles)
      for(const std::uint32_t v : triangle)
        if(number_[v] == unmet) {
          meet(v, next == 0 ? Grid::Place{} : places_[next - 1]);
          for(; next < met_.size(); ++next)
            add_star(static_cast<std::uint32_t>(next));
        }
    std::vector<const Stream*> streams = {&counts_, &corners_, &places_of_met_[0],
                                          &places_of_met_[1], &places_of_met_[2]};
    if(!surface_.triangle_parts.empty())
      streams.push_back(&parts_);
    return {met_.size(), packed(streams)};
  }

private:
  static constexpr std::uint32_t unmet = 0xffffffffu;

  void meet(std::uint32_t v, Grid::Place near) {
    number_[v] = static_cast<std::uint32_t>(met_.size());
    met_.push_back(v);
    places_.push_back(grid_.place_of(surface_.points[v]));
    add_difference(places_of_met_, places_.back(), near);
  }

  void add_star(std::uint32_t number) {
    std::uint32_t count = 0;
    const std::uint32_t v = met_[number];
    for(std::size_t i = stars_.begin[v]; i < stars_.begin[v + 1]; ++i)
      if(const std::uint32_t t = stars_.triangles[i]; !is_done_[t]) {
        is_done_[t] = true;
        ++count;
        add_triangle(t, number);
      }
    counts_.add(count);
  }

  void add_triangle(std::uint32_t t, std::uint32_t number) {
    const Triangle& corners = surface_.triangles[t];
    const int first = number_[corners[0]] == number ? 0 : number_[corners[1]] == number ? 1 : 2;
    for(int i = 1; i < 3; ++i)
      number = add_corner(corners[(first + i) % 3], number);
    if(!surface_.triangle_parts.empty()) {
      parts_.add_signed(static_cast<std::int32_t>(surface_.triangle_parts[t] - last_part_));
      last_part_ = surface_.triangle_parts[t];
    }
  }

  std::uint32_t add_corner(std::uint32_t v, std::uint32_t near) {
    if(number_[v] == unmet) {
      corners_.add(0);
      meet(v, places_[near]);
    } else
      corners_.add(static_cast<std::uint32_t>(met_.size()) - number_[v]);
    return number_[v];
  }

  const Surface& surface_;
  const Grid& grid_;
  const Stars stars_;
  std::vector<std::uint32_t> number_; // by vertex
  std::vector<bool> is_done_;         // by triangle
  std::vector<std::uint32_t> met_;    // vertices by number
  std::vector<Grid::Place> places_;   // by number
  std::uint32_t last_part_ = 0;
  Stream counts_, corners_, parts_;
  Place_streams places_of_met_;
};

} // namespace

Packed packed(const std::vector<const Stream*>& streams) {
  Packed result;
  std::string bytes;
  for(const Stream* stream : streams) {
    bytes += stream->bytes();
    result.lengths.push_back(stream->bytes().size());
  }
  result.text = base64_of(deflated(bytes));
  return result;
}

Encoded_surface encode_surface(const Surface& surface, const Grid& grid) {
  return Surface_encoder(surface, grid).encode();
}

} // namespace htl_window
