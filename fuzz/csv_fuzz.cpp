// The CSV reader on arbitrary bytes: it gives a table or an InputError, nothing else.

#include <cstddef>
#include <cstdint>
#include <string>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"

namespace {

template <typename Read>
void try_to_read(Read&& read) {
  try {
    read();
  } catch (const pliant::InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try_to_read([&] {
    const pliant::CsvTable table = pliant::parse_csv(
        text, "fuzz.csv",
        {.columns = {{"mapped", "Load (N)"}, {"first", "1 (N)"}}, .numbered_columns = true});
    try_to_read([&] { table.quantity("force", pliant::Dimension::force); });
    try_to_read([&] { table.quantity("mapped", pliant::Dimension::force); });
    try_to_read([&] { table.quantity("first", pliant::Dimension::force); });
    for (const std::string& header : table.headers()) {
      try_to_read([&] { table.numbers(header); });
      try_to_read([&] { table.integers(header); });
      try_to_read([&] { table.texts(header); });
    }
  });
  return 0;
}
