// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SVG_H
#define BENCHMARK_SVG_H

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Svg.h
/// Figures as SVG files.

namespace svg {

using Place = std::pair<double, double>; ///< in pixels, from the upper left corner

constexpr const char* orange = "#e8761c"; // handles
constexpr const char* blue = "#1c68b8";   // tunnels
constexpr const char* purple = "#8a2bb0"; // seeds
constexpr const char* dark = "#30363f";
constexpr const char* grey = "#8a93a0";
constexpr const char* pale = "#d4d9e0";

/// a number with so many digits after the point, none of which is zero at the end.
inline std::string number(double x, int digits = 1) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, x);
  std::string s = text;
  if(s.find('.') != std::string::npos)
    s.erase(s.find_last_not_of('0') + 1);
  if(s.back() == '.')
    s.pop_back();
  return s == "-0" ? "0" : s;
}

/// A figure; what is added later lies above.
class Figure
{
public:
  Figure(double width, double height)
      : width_(width)
      , height_(height) {}

  void add(const std::string& element) {
    elements_ += element + '\n';
    last_style_.clear();
  }

  void line(const std::vector<Place>& places, const std::string& colour, double width = 1.5) {
    path(places, "", "fill:none;stroke:" + colour + ";stroke-width:" + number(width));
  }

  /// with a border of its own colour, so that no gap is seen between neighbours.
  void area(const std::vector<Place>& places, const std::string& colour) {
    path(places, "z", "fill:" + colour + ";stroke:" + colour);
  }

  void dot(const Place& p, const std::string& colour, double radius = 2.5, double opacity = 1.) {
    add("<circle cx='" + number(p.first) + "' cy='" + number(p.second) + "' r='" + number(radius) +
        "' fill='" + colour + "' fill-opacity='" + number(opacity, 2) + "'/>");
  }

  void text(const Place& p,
            const std::string& words,
            const std::string& anchor = "middle",
            int size = 12,
            const std::string& colour = dark) {
    add("<text x='" + number(p.first) + "' y='" + number(p.second) + "' font-size='" +
        std::to_string(size) + "' fill='" + colour + "' text-anchor='" + anchor + "'>" + words +
        "</text>");
  }

  void write(const std::string& file) const {
    std::ofstream out(file);
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width_ << "' height='" << height_
        << "' viewBox='0 0 " << width_ << ' ' << height_
        << "' font-family='Helvetica,Arial,sans-serif'>\n<style>path{stroke-linecap:round;"
           "stroke-linejoin:round}";
    for(const auto& [style, name] : names_)
      out << "\n." << name << '{' << style << '}';
    out << "</style>\n<rect width='100%' height='100%' fill='#fff'/>\n" << elements_ << "</svg>\n";
    if(!out.flush())
      throw std::runtime_error("cannot write " + file);
  }

private:
  // Styles are written once, and paths of one style that follow each other are one element.
  void path(const std::vector<Place>& places, const char* end, const std::string& style) {
    const auto [it, is_new] = names_.emplace(style, "s" + std::to_string(names_.size()));
    if(style == last_style_)
      elements_.erase(elements_.rfind("'/>"));
    else
      elements_ += "<path class='" + it->second + "' d='";
    elements_ += steps(places) + end + "'/>\n";
    last_style_ = style;
  }

  // The way from place to place. What is rounded to tenths are the places: errors do not add up.
  static std::string steps(const std::vector<Place>& places) {
    std::string data;
    long x = 0, y = 0;
    for(std::size_t i = 0; i < places.size(); ++i) {
      const long qx = std::lround(10. * places[i].first), qy = std::lround(10. * places[i].second);
      data += i == 0 ? "M" : i == 1 ? "l" : " ";
      data += number(double(qx - x) / 10.) + ' ' + number(double(qy - y) / 10.);
      x = qx;
      y = qy;
    }
    return data;
  }

  double width_, height_;
  std::string elements_;
  std::map<std::string, std::string> names_; // of styles
  std::string last_style_;
};

/// A part of a figure with two axes.
class Chart
{
public:
  Chart(Figure& figure, Place corner, Place size, Place x_range, Place y_range)
      : figure_(figure)
      , corner_(std::move(corner))
      , size_(std::move(size))
      , x_(std::move(x_range))
      , y_(std::move(y_range)) {}

  Place place(double x, double y) const {
    return {corner_.first + size_.first * (x - x_.first) / (x_.second - x_.first),
            corner_.second + size_.second * (y_.second - y) / (y_.second - y_.first)};
  }

  /// a line across at a value, with words at its left end.
  void mark_y(double y, const std::string& words) {
    figure_.line({place(x_.first, y), place(x_.second, y)}, pale, 1.);
    const Place p = place(x_.first, y);
    figure_.text({p.first - 6., p.second + 4.}, words, "end", 11);
  }

  /// a line upwards at a value, with words below it.
  void mark_x(double x, const std::string& words) {
    figure_.line({place(x, y_.first), place(x, y_.second)}, pale, 1.);
    const Place p = place(x, y_.first);
    figure_.text({p.first, p.second + 16.}, words, "middle", 11);
  }

  void curve(const std::vector<Place>& values, const std::string& colour, double width = 1.5) {
    std::vector<Place> places;
    for(const auto& [x, y] : values)
      places.push_back(place(x, y));
    figure_.line(places, colour, width);
  }

private:
  Figure& figure_;
  Place corner_, size_, x_, y_;
};

} // namespace svg

#endif // BENCHMARK_SVG_H
