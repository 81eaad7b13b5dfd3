#ifndef HTL_TEST_TEMPORARY_FOLDER_H
#define HTL_TEST_TEMPORARY_FOLDER_H

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <system_error>
#include <thread>

// A folder for the files of a test; removed with all that is in it.
class Temporary_folder
{
public:
  Temporary_folder()
      : path_(std::filesystem::temp_directory_path() /
              ("htl_test_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directory(path_);
  }

  // A browser that is closed may still write, or remove files itself: so it is tried again.
  ~Temporary_folder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
    for(int i = 0; i < 50 && error; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      std::filesystem::remove_all(path_, error);
    }
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  std::string path(const std::string& name) const { return (path_ / name).string(); }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  std::string read(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::size_t number_of_files() const {
    const std::filesystem::directory_iterator begin(path_), end;
    return static_cast<std::size_t>(std::distance(begin, end));
  }

private:
  std::filesystem::path path_;
};

#endif // HTL_TEST_TEMPORARY_FOLDER_H
