// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_CLEANING_H
#define HTLOOPS_SOUP_CLEANING_H

#include "clean/cleaning.h"
#include "mend/mending.h"
#include "mesh_types.h"

#include <optional>

namespace htloops {

/// A mesh made of a soup, and how.
struct Soup_as_mesh
{
  Mended_soup mended;
  Mesh mesh; ///< with the same numbers
  Clean_record record{Clean_step::REPAIR};
};

/// makes an oriented manifold of triangles of a soup: by all remedies, or, if that step is left
/// out, of what is one as it is. Points of open edges are welded within a length, or, if none is
/// given, where boundaries lie nearly on each other, as far as the result is a surface. Throws
/// `Failure` if there is no way.
Soup_as_mesh mesh_for_cleaning(Soup soup,
                               const Clean_options& options,
                               const std::optional<Relative_length>& weld);

/// the whole way: what became of the soup.
struct Cleaned_soup : Cleaned_mesh
{
  Mesh mended; ///< as it was before the steps that need a mesh
  std::size_t vertices_in_file, faces_in_file;
};

/// cleans a soup; numbers of what was before are those of the soup.
Cleaned_soup clean(Soup soup,
                   const Clean_options& options,
                   const std::optional<Relative_length>& weld,
                   Progress& progress);

} // namespace htloops

#endif // HTLOOPS_SOUP_CLEANING_H
