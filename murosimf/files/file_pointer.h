/// file_pointer.h - a stream of the C library that is closed with its owner.
#pragma once

#include <cstdio>
#include <memory>

namespace murosimf::files {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePtr = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace murosimf::files
