// The U3M import on arbitrary JSON: it gives a study whose files our own readers take, or an
// InputError.

#include <cstddef>
#include <cstdint>
#include <string>

#include "pliant/base/errors.h"
#include "pliant/exchange/u3m_import.h"
#include "pliant/io/csv.h"
#include "pliant/io/document.h"
#include "pliant/io/text_file.h"

namespace {

/// What the import wrote is sound: an InputError here is a defect, so it is not caught.
void read_back(const pliant::ImportedStudy& study) {
  pliant::parse_yaml(study.study_yaml, "study.yaml");
  for (const auto& [name, content] : study.files) pliant::parse_csv(content, name);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  pliant::ImportedStudy study;
  try {
    pliant::U3mFile file{pliant::parse_json(pliant::decode_text(bytes, {}, "a.json"), "a.json")};
    if (!pliant::find_physics(file.physics)) return 0;
    study = pliant::import_u3m(file);
  } catch (const pliant::InputError&) {
    return 0;
  }
  read_back(study);
  return 0;
}
