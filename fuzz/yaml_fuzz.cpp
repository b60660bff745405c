// The YAML reader on arbitrary bytes: it gives a document or an InputError, nothing else.

#include <cstddef>
#include <cstdint>
#include <string>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/text_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    pliant::parse_yaml(pliant::decode_text(bytes, {}, "fuzz.yaml"), "fuzz.yaml");
  } catch (const pliant::InputError&) {
  }
  return 0;
}
