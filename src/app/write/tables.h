// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TABLES_H
#define HTLOOPS_TABLES_H

#include "mend/mending.h"
#include "solve/answer.h"
#include "solve/boundaries.h"
#include "solve/reeb_solver.h"
#include "solve/removal_solver.h"
#include "solve/skeleton_solver.h"
#include "words.h"
#include "write/pair_listing.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// A column of a table for a person.
struct Table_column
{
  const char* name;
  int width;                          ///< 0: the last one
  bool is_number;                     ///< these stand to the right
  std::optional<Loop_type> kind = {}; ///< of the loops that it tells of
  const char* about = "";             ///< a sentence, without its point, for pages
};

/// a table for a person; nothing if there are no rows. The middle of a long one is left out, unless
/// all is to be shown.
std::string table_of(const std::vector<Table_column>& columns,
                     const std::vector<std::vector<std::string>>& rows,
                     bool show_all);

/// what was done to the mesh of a file before anything was computed: a line for each kind.
std::string table_of_changes(const std::string& file,
                             const std::vector<Change>& changes,
                             bool is_dry_run = false);

/// the word for the side on which a loop bounds: inside, outside, neither or undecided.
const char* word_for_side(const Loop_linking& linking);

/// the same if the other components were not there.
const char* word_for_side_alone(const Loop_linking& linking);

/// how many loops bound where; empty if linking numbers were not computed.
std::string summary_of_sides(const Certificate& certificate);

/// why loops bound on neither side: a line for each two linked components, and for each loop that
/// would not bound without the others either, or of which it is undecided. `components` are those
/// of the pairs; none if there is only one.
std::vector<std::string> remarks_on_sides(const Certificate& certificate,
                                          const std::vector<std::size_t>& components);

struct Table_options
{
  bool show_all = false; ///< otherwise the middle of a long table is left out
  bool use_colour = false;
  bool is_verbose = false; ///< why no device was used, too
};

/// Which columns a table of pairs has beside those that all have.
struct Pair_columns
{
  bool measures, costs;

  /// what is known of any of the pairs.
  explicit Pair_columns(const Pair_listing& listing);
};

/// those of a table of pairs.
std::vector<Table_column> columns_of(const Pair_columns& wanted);

/// what stands in the columns.
std::vector<std::string> cells_of(const Listed_pair& pair, const Pair_columns& wanted);

/// whether any of them was measured.
bool has_measures(const Pair_listing& listing);

/// a positive number with three digits that count: 6.00, 12.0, 120.
std::string three_digits(double number);

/// a diameter that is known up to a hundredth, or else between what it is, as printed by \p print.
template <typename Print>
std::string words_of(const Range_of_diameters& range, const Print& print) {
  return range.most - range.least <= 0.02 * range.most
             ? print((range.least + range.most) / 2.)
             : print(range.least) + " to " + print(range.most);
}

/// a table of pairs for a person: how long the loops are, and where the handles are.
std::string table_of_pairs(const Pair_listing& listing, const Table_options& options);

/// lines that sum up an answer and what it took, and why loops do not bound, if there are such.
std::string words_of_unit(Unit unit);

std::string summary(const Answer& answer, double read_seconds, const Table_options& options);

/// a table of the boundary curves for a person, the shortest first: how long they and their waists
/// are, and where. The middle of a long one is left out, unless all is to be shown.
std::string table_of_boundaries(const Boundaries& boundaries, bool show_all);

/// What is told of an arc.
struct Listed_arc
{
  std::size_t arc; ///< its number
  double length;
  double girth; ///< the length of the contour half way
  std::size_t number_of_vertices;
  std::string from, to; ///< its lower node and its upper one: what they are, and their numbers
};

/// the arcs, the longest first.
std::vector<Listed_arc> list_arcs(const Mesh& mesh, const Reeb_answer& answer);

constexpr Table_column arc_columns[] = {
    {"arc", 5, true, {}, "The number of the arc"},
    {"length", 12, true, {}, "The length of the drawn line of the arc"},
    {"girth",
     12,
     true,
     {},
     "The length of the contour halfway along the arc, if it crosses a face"},
    {"vertices", 9, true, {}, "The number of vertices in its part of the surface"},
    {"from", 14, false, {}, "The node with the smallest value, and its number: saddles are joints"},
    {"to", 0, false, {}, "The node with the largest value, and its number: saddles are joints"}};

/// what stands in the columns.
std::vector<std::string> cells_of(const Listed_arc& arc);

std::string table_of_arcs(const std::vector<Listed_arc>& arcs, bool show_all);

/// writes a header and a row for each arc, as RFC 4180 has it.
void write_arc_csv(const std::string& target, const std::vector<Listed_arc>& arcs);

constexpr Table_column skeleton_columns[] = {
    {"arc", 5, true, {}, "The number of the arc"},
    {"length", 12, true, {}, "The length along the arc"},
    {"smallest radius",
     15,
     true,
     {},
     "The radius of the smallest maximal inscribed ball along the arc"},
    {"mean radius", 12, true, {}, "The mean radius of the maximal inscribed balls along the arc"},
    {"tortuosity",
     10,
     true,
     {},
     "The length divided by the distance between the ends: 1 if straight"},
    {"cycle", 5, false, {}, "Whether the arc is part of a cycle"},
    {"from",
     12,
     false,
     {},
     "The joint, end or inlet where the arc begins, with its number (a bend for a ring)"},
    {"to",
     0,
     false,
     {},
     "The joint, end or inlet where the arc ends, with its number (a bend for a ring)"}};

/// the numbers of the arcs, the longest first.
std::vector<std::size_t> arcs_by_length(const Skeleton_answer& answer);

/// what stands in the columns.
std::vector<std::string> cells_of(const Skeleton_answer& answer, std::size_t arc);

std::string table_of_arcs(const Skeleton_answer& answer, bool show_all);

/// lines that sum up a skeleton, what has been proved of it, and what it took.
std::string summary(const Skeleton_answer& answer, double read_seconds);

/// writes a header and a row for each arc, as RFC 4180 has it.
void write_arc_csv(const std::string& target, const Skeleton_answer& answer);

/// the word for how a handle was removed, as it stands in files and messages: of what was taken out
/// with its surroundings, whether material went, or closed the hole.
const char* name_of(const Removed_handle& handle);

constexpr Table_column removal_columns[] = {
    {"pair", 5, true, {}, "The number of the pair of loops; a neck has none"},
    {"by",
     5,
     false,
     {},
     "cut: along the handle loop; fill: along the tunnel loop; both loops with their surroundings "
     "were replaced by a cap, out: material was removed, plug: material closed the hole"},
    {"length", 12, true, {}, "The length of the loop along which the handle was removed"},
    {"area", 10, true, {}, "The area of the caps, the new faces that close the surface"},
    {"removes", 9, true, {}, "The volume of solid that was removed"},
    {"adds", 9, true, {}, "The volume of solid that was added"},
    {"cap",
     6,
     true,
     {},
     "The area of the largest cap divided by that of a disk with the same perimeter"},
    {"moved",
     7,
     true,
     {},
     "The largest distance of a cap from the old surface, divided by the loop length"},
    {"angle",
     5,
     true,
     {},
     "The sharpest angle between faces at an edge of a cap, in degrees: 180 is flat"},
    {"note", 0, false, {}, "What to look at: a sharp edge at a cap, or a large displacement"}};

/// what stands in the columns; `name` is the number of a pair, or neck, `diagonal` that of the
/// mesh.
std::vector<std::string>
cells_of(const Removed_handle& handle, const std::string& name, double diagonal);

/// tables of the handles and necks that were removed, and of those that were refused, for a person.
std::string table_of_removals(const Removal_report& report, double diagonal, bool show_all);

/// lines that sum them up.
std::string summary(const Removal_report& report, bool is_dry_run = false);

/// the colour of what is new of a surface.
constexpr Colour colour_of_caps = {110, 202, 168};

/// the colour (red, green, blue) of a kind of loops, in exports and pictures alike. People who do
/// not see all colours tell these apart (Okabe and Ito, Color Universal Design, 2008).
constexpr Colour colour_of(Loop_type type) {
  return type == Loop_type::HANDLE   ? Colour{213, 94, 0}
         : type == Loop_type::TUNNEL ? Colour{0, 114, 178}
                                     : Colour{0, 158, 115};
}

/// that of the boundary of the surface itself.
constexpr Colour colour_of_boundary_curve = {60, 60, 60};

} // namespace htloops

#endif // HTLOOPS_TABLES_H
