#ifndef HTL_TEST_DECODED_PNG_H
#define HTL_TEST_DECODED_PNG_H

#include <png.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// A picture read back from the content of its file.
struct Decoded_png
{
  using Colour = std::array<unsigned char, 3>;

  int width = 0, height = 0;
  std::vector<Colour> pixels;

  const Colour& at(int x, int y) const { return pixels[std::size_t(y) * width + x]; }
  const Colour& middle() const { return at(width / 2, height / 2); }

  template <typename Predicate> std::ptrdiff_t count(Predicate predicate) const {
    return std::count_if(pixels.begin(), pixels.end(), predicate);
  }
};

inline Decoded_png decoded_png(const std::string& png) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if(png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0)
    throw std::runtime_error(image.message);
  image.format = PNG_FORMAT_RGB;
  Decoded_png picture;
  picture.width = static_cast<int>(image.width);
  picture.height = static_cast<int>(image.height);
  picture.pixels.resize(std::size_t(image.width) * image.height);
  if(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0)
    throw std::runtime_error(image.message);
  return picture;
}

#endif // HTL_TEST_DECODED_PNG_H
