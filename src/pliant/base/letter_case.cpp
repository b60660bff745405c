#include "pliant/base/letter_case.h"

namespace pliant {
namespace {

constexpr char kLatin1Lead = '\xC3';  // of the two bytes of letters with accents
constexpr char kCase = 32;            // from a capital letter to its small one

/// The second byte of a capital letter from À to Þ, but for the sign of multiplication.
bool is_accented_capital(char second) {
  const auto byte = static_cast<unsigned char>(second);
  return byte >= 0x80 && byte <= 0x9E && byte != 0x97;
}

}  // namespace

std::string lower_case(std::string_view text) {
  std::string result(text);
  char before = '\0';
  for (char& c : result) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital || (before == kLatin1Lead && is_accented_capital(c))) {
      c = static_cast<char>(c + kCase);
    }
    before = c;
  }
  return result;
}

bool same_letters(std::string_view a, std::string_view b) {
  return a.size() == b.size() && lower_case(a) == lower_case(b);
}

}  // namespace pliant
