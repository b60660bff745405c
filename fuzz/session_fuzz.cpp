// The reader of session.yaml on arbitrary YAML: it gives a session whose frames have names, or an
// InputError, nothing else.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/text_file.h"
#include "pliant/measurement/session/session_document.h"

namespace {

namespace fs = std::filesystem;

/// A folder with the files that the seeds name.
const fs::path& folder() {
  static const fs::path path = [] {
    fs::path made = fs::temp_directory_path() / ("session-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(made);
    std::ofstream(made / "rest.ply") << "";
    std::ofstream(made / "left.txt") << "0 1 2";
    return made;
  }();
  return path;
}

void require(bool fact) {
  if (!fact) std::abort();
}

void use(const pliant::SessionDocument& session) {
  require(session.sample.width > 0 && session.sample.height > 0);
  require(session.sample.mass.has_value() || session.sample.density.has_value());
  require(session.frames.name(7) != session.frames.name(8));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string file = (folder() / "session.yaml").string();
  try {
    use(pliant::session_document_of(
        pliant::parse_yaml(pliant::decode_text(bytes, {}, file), file)));
  } catch (const pliant::InputError&) {
  }
  return 0;
}
