#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace pliant::test {

/// A page of the documentation; `path` is relative to the checkout.
struct Page {
  std::filesystem::path path;
  std::string text;
};

/// A fenced block of a page: "```yaml study.yaml" has the language yaml and the name study.yaml.
struct FencedBlock {
  std::string language, name, text;
  int line = 0;         ///< of its fence, counted from 1
  std::string part_of;  ///< T where `<!-- part of T -->` stands above it; empty: a whole document
};

inline Page read_page(const std::filesystem::path& path) {
  std::ifstream stream(std::filesystem::path(PLIANT_SOURCE_DIR) / path, std::ios::binary);
  return {path, {std::istreambuf_iterator<char>(stream), {}}};
}

/// The pages that readers find: at the root of the checkout, and below docs/.
inline std::vector<Page> documentation() {
  namespace fs = std::filesystem;
  std::vector<fs::path> paths{"README.md", "CONTRIBUTING.md", "CHANGELOG.md"};
  const fs::path root = PLIANT_SOURCE_DIR;
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path().lexically_relative(root));
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Page> pages;
  for (const fs::path& path : paths) pages.push_back(read_page(path));
  return pages;
}

/// The blocks of a page, and its prose: the page with the lines of its blocks left empty.
struct PageParts {
  std::vector<FencedBlock> blocks;
  std::string prose;
};

inline PageParts parts_of(const Page& page) {
  PageParts parts;
  std::istringstream lines(page.text);
  std::string above;
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(lines, line); above = line) {
    ++number;
    const bool fence = line.starts_with("```");
    if (fence && !inside) {
      FencedBlock block;
      block.line = number;
      std::istringstream(line.substr(3)) >> block.language >> block.name;
      if (above.starts_with("<!-- part of ")) block.part_of = above.substr(13, above.size() - 17);
      parts.blocks.push_back(block);
    } else if (inside && !fence) {
      parts.blocks.back().text += line + "\n";
    }
    parts.prose += (inside || fence ? "" : line) + "\n";
    if (fence) inside = !inside;
  }
  return parts;
}

}  // namespace pliant::test
