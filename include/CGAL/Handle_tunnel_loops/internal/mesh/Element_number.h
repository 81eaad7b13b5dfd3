// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_ELEMENT_NUMBER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_ELEMENT_NUMBER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/Iterator_range.h>

#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <ostream>

namespace CGAL::Handle_tunnel_loops::internal {

/// A vertex, a halfedge, an edge or a face, as the kind says, by its number.
template <typename Kind> class Element_number
{
public:
  constexpr Element_number() = default; ///< none
  constexpr explicit Element_number(Index number)
      : number_(number) {}

  constexpr Index idx() const { return number_; }

  friend constexpr bool operator==(Element_number a, Element_number b) {
    return a.number_ == b.number_;
  }
  friend constexpr bool operator!=(Element_number a, Element_number b) { return !(a == b); }
  friend constexpr bool operator<(Element_number a, Element_number b) {
    return a.number_ < b.number_;
  }
  friend std::size_t hash_value(Element_number a) { return a.number_; }
  friend std::ostream& operator<<(std::ostream& out, Element_number a) { return out << a.number_; }

  /// gives each element its number.
  struct Map
  {
    using key_type = Element_number;
    using value_type = Index;
    using reference = Index;
    using category = boost::readable_property_map_tag;

    friend Index get(const Map&, Element_number a) { return a.idx(); }
    Index operator[](Element_number a) const { return a.idx(); }
  };

  /// Goes from number to number.
  class Iterator : public boost::iterator_facade<Iterator,
                                                 Element_number,
                                                 std::random_access_iterator_tag,
                                                 Element_number>
  {
  public:
    Iterator() = default;
    explicit Iterator(std::size_t number)
        : number_(static_cast<Index>(number)) {}

  private:
    friend class boost::iterator_core_access;
    Element_number dereference() const { return Element_number(number_); }
    bool equal(const Iterator& other) const { return number_ == other.number_; }
    void increment() { ++number_; }
    void decrement() { --number_; }
    void advance(std::ptrdiff_t n) { number_ = static_cast<Index>(number_ + n); }
    std::ptrdiff_t distance_to(const Iterator& other) const {
      return std::ptrdiff_t(other.number_) - std::ptrdiff_t(number_);
    }

    Index number_ = 0;
  };

  /// those of the numbers below \p bound.
  static Iterator_range<Iterator> range(std::size_t bound) {
    return {Iterator(0), Iterator(bound)};
  }

private:
  Index number_ = no_index;
};

/// An edge that knows by which of its halfedges it was come upon. Its number is the smaller one of
/// theirs; so it is the same edge, whichever that was.
template <typename Halfedge> class Edge_number
{
public:
  constexpr Edge_number() = default; ///< none
  constexpr Edge_number(Halfedge halfedge, Halfedge opposite)
      : halfedge_(halfedge)
      , number_(halfedge < opposite ? halfedge.idx() : opposite.idx()) {}

  constexpr Index idx() const { return number_; }
  constexpr Halfedge halfedge() const { return halfedge_; }

  friend constexpr bool operator==(Edge_number a, Edge_number b) { return a.number_ == b.number_; }
  friend constexpr bool operator!=(Edge_number a, Edge_number b) { return !(a == b); }
  friend constexpr bool operator<(Edge_number a, Edge_number b) { return a.number_ < b.number_; }
  friend std::size_t hash_value(Edge_number a) { return a.number_; }
  friend std::ostream& operator<<(std::ostream& out, Edge_number a) { return out << a.number_; }

private:
  Halfedge halfedge_;
  Index number_ = no_index;
};

} // namespace CGAL::Handle_tunnel_loops::internal

namespace std {

template <typename Kind> struct hash<CGAL::Handle_tunnel_loops::internal::Element_number<Kind>>
{
  size_t operator()(CGAL::Handle_tunnel_loops::internal::Element_number<Kind> a) const {
    return a.idx();
  }
};

template <typename Halfedge> struct hash<CGAL::Handle_tunnel_loops::internal::Edge_number<Halfedge>>
{
  size_t operator()(CGAL::Handle_tunnel_loops::internal::Edge_number<Halfedge> a) const {
    return a.idx();
  }
};

} // namespace std

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_ELEMENT_NUMBER_H
