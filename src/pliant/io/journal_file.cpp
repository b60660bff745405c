#include "pliant/io/journal_file.h"

#include <cstring>

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/sealed_file.h"

namespace pliant {
namespace {

using Json = nlohmann::json;
using Numbers = Journal::Numbers;

constexpr const char* kType = "progress/1";

Json bytes_of(const Numbers& numbers) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(numbers.data());
  return Json::binary({first, first + sizeof(double) * numbers.size()});
}

Numbers numbers_of(const Json& json) {
  const auto& bytes = json.get_binary();
  Numbers numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), sizeof(double) * numbers.size());
  return numbers;
}

Json json_of(const std::vector<Journal::Entry>& entries) {
  Json json = Json::array();
  for (const Journal::Entry& entry : entries) {
    json.push_back({entry.question, bytes_of(entry.answer)});
  }
  return json;
}

std::vector<Journal::Entry> entries_of(const Json& json) {
  std::vector<Journal::Entry> entries;
  for (const Json& entry : json) entries.push_back({entry.at(0), numbers_of(entry.at(1))});
  return entries;
}

Journal::Content content_of(const Json& json) {
  Journal::Content content;
  content.entries = entries_of(json.at("entries"));
  content.reached = numbers_of(json.at("reached"));
  for (const auto& [name, numbers] : json.at("kept").items()) {
    content.kept[name] = numbers_of(numbers);
  }
  for (const auto& [name, entries] : json.at("parts").items()) {
    content.parts[name] = entries_of(entries);
  }
  return content;
}

}  // namespace

std::string journal_bytes(const Journal::Content& content) {
  Json kept = Json::object(), parts = Json::object();
  for (const auto& [name, numbers] : content.kept) kept[name] = bytes_of(numbers);
  for (const auto& [name, entries] : content.parts) parts[name] = json_of(entries);
  const Json json{{"entries", json_of(content.entries)},
                  {"reached", bytes_of(content.reached)},
                  {"kept", kept},
                  {"parts", parts}};
  std::string cbor;
  Json::to_cbor(json, cbor);
  return sealed_bytes(kType, cbor);
}

bool is_journal(const std::filesystem::path& file) { return is_sealed(file, kType); }

Journal::Content read_journal(const std::filesystem::path& file) {
  const std::string cbor = read_sealed(file, kType, "progress of a fit", "fit");
  try {
    return content_of(Json::from_cbor(cbor));
  } catch (const Json::exception&) {
    throw InputError({file.string()}, "is the progress of another version of Pliant",
                     "one that `pliant fit` of the same version wrote");
  }
}

}  // namespace pliant
