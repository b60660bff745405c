#include "pliant/io/sealed_file.h"

#include <fstream>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/digest.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

std::string beginning(std::string_view type) { return fmt::format("pliant: {} ", type); }

}  // namespace

std::string sealed_bytes(std::string_view type, std::string_view content) {
  return fmt::format("{}{}\n{}", beginning(type), sha256_of(content), content);
}

bool is_sealed(const std::filesystem::path& file, std::string_view type) {
  std::ifstream in(file, std::ios::binary);
  std::string found(beginning(type).size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  return in.good() && found == beginning(type);
}

std::string read_sealed(const std::filesystem::path& file, std::string_view type,
                        std::string_view noun, std::string_view command) {
  constexpr std::size_t kLargest = std::size_t{4} << 30;
  const auto fail = [&](const std::string& problem) {
    throw InputError({file.string()}, fmt::format("{} {}", problem, noun),
                     fmt::format("one that `pliant {}` wrote", command));
  };
  const std::string bytes = read_text_file(file, kLargest);
  if (!bytes.starts_with(beginning(type))) fail("is no");
  std::string content = bytes.substr(bytes.find('\n') + 1);
  if (bytes != sealed_bytes(type, content)) fail("is a damaged");
  return content;
}

}  // namespace pliant
