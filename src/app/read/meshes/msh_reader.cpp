// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/readers.h"
#include "read/sources.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

namespace htloops {
namespace {

// The kinds of elements, by their numbers.
struct Msh_type
{
  int number;
  int nodes;
  int corners;   // which come first
  int dimension; // that of a volume is 3
};

constexpr Msh_type msh_types[] = {
    {1, 2, 2, 1},   {2, 3, 3, 2},   {3, 4, 4, 2},   {4, 4, 4, 3},   {5, 8, 8, 3},   {6, 6, 6, 3},
    {7, 5, 5, 3},   {8, 3, 2, 1},   {9, 6, 3, 2},   {10, 9, 4, 2},  {11, 10, 4, 3}, {12, 27, 8, 3},
    {13, 18, 6, 3}, {14, 14, 5, 3}, {15, 1, 1, 0},  {16, 8, 4, 2},  {17, 20, 8, 3}, {18, 15, 6, 3},
    {19, 13, 5, 3}, {20, 9, 3, 2},  {21, 10, 3, 2}, {22, 12, 3, 2}, {23, 15, 3, 2}, {24, 15, 3, 2},
    {25, 21, 3, 2}, {26, 4, 2, 1},  {27, 5, 2, 1},  {28, 6, 2, 1},  {29, 20, 4, 3}, {30, 35, 4, 3},
    {31, 56, 4, 3}, {36, 16, 4, 2}, {37, 25, 4, 2}, {92, 64, 8, 3}, {93, 125, 8, 3}};

// The content, as text or as bytes.
class Msh_content
{
public:
  explicit Msh_content(const Input_file& file)
      : file_(file)
      , text_(file.name(), file.content()) {}

  /// goes to the next section and says what it is called; empty if there is none.
  std::string_view next_section() {
    while(text_.skip_to_content()) {
      const std::string_view word = text_.word();
      text_.skip_line();
      if(word.substr(0, 4) != "$End" && word.substr(0, 1) == "$")
        return word.substr(1);
      if(word.substr(0, 1) != "$")
        text_.fail(in_quotes(word) + " is not an MSH section");
    }
    return {};
  }

  void skip_section(std::string_view name) {
    const std::size_t end = file_.content().find("$End" + std::string(name), text_.position());
    if(end == std::string_view::npos)
      text_.fail_incomplete("expected $End" + std::string(name));
    text_.go_to(end);
  }

  void read_format() {
    if(!text_.read(version_) ||
       !((2. <= version_ && version_ < 3.) || (4. <= version_ && version_ < 5.)))
      text_.fail("this MSH version is not supported: save the file as 2.2 or 4.1");
    long long is_binary = 0, size_of_real = 0;
    if(!text_.read(is_binary) || !text_.read(size_of_real) || size_of_real != sizeof(double))
      text_.fail("expected the file type (0 or 1) and the data size (8)");
    text_.skip_line();
    is_text_ = is_binary == 0;
    if(is_text_)
      return;
    if(is_of_version_4() && !has_long_numbers())
      text_.fail("binary MSH 4.0 is not supported: save the file as 4.1");
    std::int32_t one = 0;
    Binary_source bytes(file_.name(), file_.content(), text_.position(), true);
    bytes.read(one);
    is_little_endian_ = one == 1;
    text_.go_to(text_.position() +
                (std::min)(sizeof one, file_.content().size() - text_.position()));
  }

  bool is_text() const { return is_text_; }
  bool is_of_version_4() const { return version_ >= 4.; }
  bool has_long_numbers() const { return version_ >= 4.1; }

  /// begins the data of a section.
  void begin_data() {
    bytes_.emplace(file_.name(), file_.content(), text_.position(), is_little_endian_);
  }

  void end_data() {
    if(!is_text_)
      text_.go_to(file_.content().size() - bytes_->bytes_left());
  }

  double real(const char* what) {
    double number = 0.;
    if(is_text_ ? !(text_.skip_to_content() && text_.read(number)) : !bytes_->read(number))
      fail_to_find(what);
    return number;
  }

  long long integer(const char* what) { return whole_number<std::int32_t>(what); }

  /// a number of things, or of a thing, which later versions give more room.
  long long number(const char* what) {
    return has_long_numbers() ? whole_number<std::int64_t>(what) : integer(what);
  }

  /// the same, counted when the file begins with them: in version 4.0 they are long, too.
  long long count(const char* what) {
    const long long count =
        is_of_version_4() ? whole_number<std::int64_t>(what) : whole_number<std::int32_t>(what);
    if(count < 0)
      fail_to_find(what);
    return count;
  }

  /// a whole line of text with a count, as version 2 has before its bytes.
  long long count_in_text(const char* what) {
    long long count = 0;
    if(!text_.skip_to_content() || !text_.read(count) || count < 0)
      fail_to_find(what);
    text_.skip_line();
    begin_data();
    return count;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    if(is_text_ || !bytes_)
      text_.fail(problem);
    bytes_->fail(problem);
  }

private:
  template <typename T> long long whole_number(const char* what) {
    long long value = 0;
    T bits = 0;
    if(is_text_ ? !(text_.skip_to_content() && text_.read(value)) : !bytes_->read(bits))
      fail_to_find(what);
    return is_text_ ? value : static_cast<long long>(bits);
  }

  [[noreturn]] void fail_to_find(const char* what) const {
    if(is_text_)
      text_.fail_incomplete("expected " + std::string(what));
    fail("expected " + std::string(what) + "; the file may end here");
  }

  const Input_file& file_;
  Text_source text_;
  std::optional<Binary_source> bytes_;
  bool is_text_ = true, is_little_endian_ = true;
  double version_ = 0.;
};

class Msh_reader
{
public:
  explicit Msh_reader(const Input_file& file)
      : file_(file)
      , content_(file) {}

  Soup read() {
    bool has_format = false;
    for(std::string_view section; !(section = content_.next_section()).empty();) {
      if(section == "MeshFormat") {
        content_.read_format();
        has_format = true;
      } else if(!has_format)
        fail_to_read(file_.name(), "an MSH file must begin with $MeshFormat");
      else if(section == "Nodes")
        content_.is_of_version_4() ? read_nodes() : read_nodes_of_version_2();
      else if(section == "Elements")
        content_.is_of_version_4() ? read_elements() : read_elements_of_version_2();
      content_.skip_section(section);
    }
    if(!has_format)
      fail_to_read(file_.name(), "an MSH file must begin with $MeshFormat");
    if(soup_.faces.empty())
      fail_to_read(file_.name(), has_volumes_ ? "it has volume elements but no surface elements: "
                                                "save its surface, too"
                                              : "it has no triangles");
    if(has_volumes_)
      soup_.facts.unread = {"volume elements"};
    return std::move(soup_);
  }

private:
  void add_node(long long tag, const std::array<double, 3>& x) {
    if(!numbers_.emplace(tag, soup_.points.size()).second)
      content_.fail("node " + std::to_string(tag) + " appears twice");
    soup_.points.emplace_back(x[0], x[1], x[2]);
  }

  std::array<double, 3> read_point() {
    std::array<double, 3> point{};
    for(double& x : point)
      x = content_.real("three coordinates");
    return point;
  }

  void read_nodes_of_version_2() {
    const long long count = content_.count_in_text("the number of nodes");
    for(long long i = 0; i < count; ++i) {
      const long long tag = content_.integer("a node number");
      add_node(tag, read_point());
    }
    content_.end_data();
  }

  // In blocks, each of a part of the model; places on curves and surfaces may follow the
  // coordinates. Version 4.1 has the numbers of all nodes of a block before their places.
  void read_nodes() {
    content_.begin_data();
    const long long blocks = content_.count("the number of node blocks");
    content_.count("the number of nodes");
    if(content_.has_long_numbers()) {
      content_.count("the smallest node number");
      content_.count("the largest node number");
    }
    for(long long block = 0; block < blocks; ++block)
      read_block_of_nodes();
    content_.end_data();
  }

  void read_block_of_nodes() {
    const bool are_tags_first = content_.has_long_numbers();
    const long long first = content_.integer("an entity"), second = content_.integer("an entity");
    const long long dimension = are_tags_first ? first : second;
    const bool is_parametric = content_.integer("the parametric flag") != 0;
    const long long count = content_.count("the number of nodes in a block");
    std::vector<long long> tags;
    for(long long i = 0; are_tags_first && i < count; ++i)
      tags.push_back(content_.number("a node number"));
    for(long long i = 0; i < count; ++i) {
      const long long tag =
          are_tags_first ? tags[static_cast<std::size_t>(i)] : content_.integer("a node number");
      add_node(tag, read_point());
      for(long long k = 0; is_parametric && k < dimension; ++k)
        content_.real("a parameter");
    }
  }

  const Msh_type& type_of(long long number) const {
    const auto type = std::find_if(std::begin(msh_types), std::end(msh_types),
                                   [number](const Msh_type& t) { return t.number == number; });
    if(type == std::end(msh_types))
      content_.fail("unknown element type " + std::to_string(number));
    return *type;
  }

  void read_element(const Msh_type& type) {
    std::vector<std::size_t> corners;
    for(int i = 0; i < type.nodes; ++i) {
      const long long tag = content_.number("a node of an element");
      if(type.dimension == 2 && i < type.corners)
        corners.push_back(number_of(tag));
    }
    if(type.dimension == 2)
      soup_.add_face(corners);
    has_volumes_ = has_volumes_ || type.dimension == 3;
  }

  std::size_t number_of(long long tag) const {
    const auto found = numbers_.find(tag);
    if(found == numbers_.end())
      content_.fail("an element uses node " + std::to_string(tag) + ", which does not exist");
    return found->second;
  }

  // Tags say of which parts of the model an element is. As bytes there is a head before elements of
  // one type.
  void read_elements_of_version_2() {
    const long long count = content_.count_in_text("the number of elements");
    long long of_block = 1, tags = 0;
    for(long long i = 0; i < count; i += of_block) {
      const auto head = [this] { return content_.integer("the header of an element block"); };
      if(content_.is_text())
        head(); // the number of the element
      const Msh_type& type = type_of(head());
      if(!content_.is_text())
        of_block = head();
      tags = head();
      if(of_block < 1 || tags < 0)
        content_.fail("an element block has an invalid header");
      for(long long k = 0; k < of_block; ++k) {
        for(long long t = content_.is_text() ? 0 : -1; t < tags; ++t)
          content_.integer("an element tag");
        read_element(type);
      }
    }
    content_.end_data();
  }

  void read_elements() {
    content_.begin_data();
    const long long blocks = content_.count("the number of element blocks");
    content_.count("the number of elements");
    if(content_.has_long_numbers()) {
      content_.count("the smallest element number");
      content_.count("the largest element number");
    }
    for(long long block = 0; block < blocks; ++block) {
      content_.integer("an entity");
      content_.integer("an entity");
      const Msh_type& type = type_of(content_.integer("the element type"));
      const long long count = content_.count("the number of elements in a block");
      for(long long i = 0; i < count; ++i) {
        content_.number("an element number");
        read_element(type);
      }
    }
    content_.end_data();
  }

  const Input_file& file_;
  Msh_content content_;
  Soup soup_;
  std::unordered_map<long long, std::size_t> numbers_; // of nodes, by their tags
  bool has_volumes_ = false;
};

} // namespace

Soup read_msh(const Input_file& file) { return Msh_reader(file).read(); }

} // namespace htloops
