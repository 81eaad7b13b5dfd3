// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "encode_png.h"

#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <utility>

namespace htl_picture {
namespace {

static_assert(sizeof(Colour) == 3, "pixels are handed over as they are");

// libpng, with what it has written and what it says.
class Png
{
public:
  Png()
      : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, note_error, ignore_warning))
      , info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
    if(info_ == nullptr)
      throw std::runtime_error("cannot write a picture: libpng does not begin");
    png_set_write_fn(png_, this, append, nullptr);
  }
  ~Png() { png_destroy_write_struct(&png_, &info_); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  void begin(int width, int height) {
    call([&] {
      png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                   8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                   PNG_FILTER_TYPE_DEFAULT);
      png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
      png_write_info(png_, info_);
    });
  }

  void write_row(const Colour* row) {
    call([&] { png_write_row(png_, reinterpret_cast<png_const_bytep>(row)); });
  }

  std::string end() {
    call([&] { png_write_end(png_, info_); });
    return std::move(content_);
  }

private:
  static void note_error(png_structp png, png_const_charp message) {
    static_cast<Png*>(png_get_error_ptr(png))->error_ = message;
    png_longjmp(png, 1);
  }

  static void ignore_warning(png_structp, png_const_charp) {}

  static void append(png_structp png, png_bytep data, png_size_t size) {
    bool is_good = true;
    try {
      static_cast<Png*>(png_get_io_ptr(png))->content_.append(reinterpret_cast<char*>(data), size);
    } catch(const std::bad_alloc&) {
      is_good = false;
    }
    if(!is_good)
      png_error(png, "out of memory");
  }

  template <typename Call> void call(const Call& use) {
    if(!runs_without_error(use))
      throw std::runtime_error("cannot write a picture: " + error_);
  }

  // The errors of libpng are jumps to here, where nothing has to be destroyed, and nothing is
  // thrown, which not all compilers can do beside a jump.
  template <typename Call> bool runs_without_error(const Call& use) {
    if(setjmp(png_jmpbuf(png_)) != 0)
      return false;
    use();
    return true;
  }

  std::string content_, error_;
  png_structp png_;
  png_infop info_;
};

} // namespace

std::string encode_png(int width,
                       int height,
                       const std::vector<Colour>& pixels,
                       const std::function<void()>& look) {
  Png png;
  png.begin(width, height);
  for(int y = 0; y < height; ++y) {
    look();
    png.write_row(pixels.data() + std::size_t(y) * std::size_t(width));
  }
  return png.end();
}

} // namespace htl_picture
