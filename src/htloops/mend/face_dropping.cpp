// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/face_dropping.h"

#include "mend/change_counter.h"
#include "mend/duplicate_faces.h"
#include "mend/polygons.h"
#include "read/soup_words.h"

#include <algorithm>
#include <utility>

namespace htloops {
namespace {

bool repeats_corner(const Corners& corners) {
  bool is_repeated = corners.size() < 3;
  for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) { is_repeated |= u == v; });
  return is_repeated;
}

bool is_degenerate(const Soup_face& face) {
  return face.size() < 3 || face[0] == face[1] || face[1] == face[2] ||
         (face.size() == 3 && face[2] == face[0]);
}

// Most soups have no such face, and need not be copied.
bool has_degenerate_faces(const Soup& soup) {
  if(soup.further_corners.empty())
    return std::any_of(soup.faces.begin(), soup.faces.end(), is_degenerate);
  bool has_any = false;
  for_each_polygon(
      soup, [&](std::size_t, const Corners& corners) { has_any |= repeats_corner(corners); });
  return has_any;
}

Corners without_repetitions(Corners corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while(corners.size() > 1 && corners.front() == corners.back())
    corners.pop_back();
  return corners;
}

} // namespace

void drop_degenerate_faces(Mended_soup& mended) {
  if(!has_degenerate_faces(mended.soup))
    return;
  Soup kept;
  std::vector<std::uint32_t> face_in_file;
  Change_counter dropped, shortened;
  for_each_polygon(mended.soup, [&](std::size_t f, const Corners& corners) {
    const auto name = [&] { return name_of_face(mended.face_in_file[f]); };
    const Corners rest = without_repetitions(corners);
    if(rest.size() < 3) {
      dropped.add(name);
      return;
    }
    if(rest.size() < corners.size())
      shortened.add(name);
    add_face(kept, rest);
    face_in_file.push_back(mended.face_in_file[f]);
  });
  kept.points = std::move(mended.soup.points);
  mended.soup = std::move(kept);
  mended.face_in_file = std::move(face_in_file);
  dropped.report(mended, "degenerate face dropped", "degenerate faces dropped");
  shortened.report(mended, "face relieved of corners that repeat a vertex",
                   "faces relieved of corners that repeat a vertex");
}

void drop_duplicate_faces(Mended_soup& mended) {
  const Duplicate_faces found = find_duplicate_faces(mended.soup);
  if(found.duplicates.empty() && found.of_flaps.empty())
    return;
  Change_counter duplicates, flaps;
  std::size_t kept = 0;
  for(std::uint32_t f = 0; f < mended.soup.faces.size(); ++f) {
    const auto name = [&] { return name_of_face(mended.face_in_file[f]); };
    if(std::binary_search(found.duplicates.begin(), found.duplicates.end(), f)) {
      duplicates.add(name);
    } else if(std::binary_search(found.of_flaps.begin(), found.of_flaps.end(), f)) {
      flaps.add(name);
    } else {
      mended.soup.faces[kept] = mended.soup.faces[f];
      mended.face_in_file[kept++] = mended.face_in_file[f];
    }
  }
  mended.soup.faces.resize(kept);
  mended.face_in_file.resize(kept);
  duplicates.report(mended, "duplicate face dropped", "duplicate faces dropped");
  flaps.report(mended, "face of a flap without thickness dropped",
               "faces of flaps without thickness dropped");
}

} // namespace htloops
