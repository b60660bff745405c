#include "pliant/exchange/keyword_material.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr std::size_t kLongestNumber = 20, kLongestName = 80, kNumbersPerLine = 8;
constexpr std::size_t kMostOgdenTermsOfAbaqus = 6, kMostOgdenTermsOfCalculix = 3;

// CalculiX takes a D below 1e-10 as not given, and a value of its own for it: the Ds of higher
// powers are so large that the powers vanish.
constexpr double kLeastD = 1e-10, kNoPower = 1e30;

/// A keyword with its numbers, eight a line.
std::string keyword(const std::string& head, const std::vector<double>& numbers) {
  std::string text = "*" + head + "\n";
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text += keyword_number(numbers[i]);
    const bool ends = i + 1 == numbers.size() || (i + 1) % kNumbersPerLine == 0;
    text += ends ? "\n" : ", ";
  }
  return text;
}

/// The keyword of one law.
class LawWriter {
 public:
  LawWriter(const SolidToConvert& solid, KeywordTool tool) : solid_(solid), tool_(tool) {}

  std::string text() {
    return std::visit([this](const auto& shape) { return text_of(shape); }, solid_.law.shape);
  }
  std::vector<std::string>& lost() { return lost_; }

 private:
  bool is_abaqus() const { return tool_ == KeywordTool::abaqus; }

  std::string text_of(const StvkLaw& law) {
    lose_large_strains();
    return keyword("ELASTIC", {law.young(), law.poisson()});
  }

  std::string text_of(const OrthotropicStvkLaw& law) {
    lose_large_strains();
    const Eigen::Matrix3d& d = law.normal;
    return keyword(is_abaqus() ? "ELASTIC, TYPE=ORTHOTROPIC" : "ELASTIC, TYPE=ORTHO",
                   {d(0, 0), d(0, 1), d(1, 1), d(0, 2), d(1, 2), d(2, 2), law.shear(2),
                    law.shear(1), law.shear(0)});
  }

  void lose_large_strains() {
    if (!is_abaqus()) return;
    lost_.emplace_back(
        "St. Venant-Kirchhoff at large strains: *ELASTIC is a law of rates in Abaqus, alike "
        "where strains are small, however large rotations are");
  }

  std::string text_of(const InvariantLaw& law) {
    const auto& [c10, c20, c30] = law.first;
    const double c01 = law.second;
    const bool linear = c20 == 0 && c30 == 0;
    if (c01 == 0 && linear) return keyword("HYPERELASTIC, NEO HOOKE", with_ds({c10}, 1));
    if (linear) return keyword("HYPERELASTIC, MOONEY-RIVLIN", with_ds({c10, c01}, 1));
    if (c01 == 0) return keyword("HYPERELASTIC, YEOH", with_ds({c10, c20, c30}, 3));
    // C10, C01; C20, C11, C02; C30, C21, C12, C03.
    return keyword("HYPERELASTIC, POLYNOMIAL, N=3",
                   with_ds({c10, c01, c20, 0, 0, c30, 0, 0, 0}, 3));
  }

  std::string text_of(const OgdenLaw& law) {
    if (!law.isochoric) refuse("components.stretch", "of stretches that are not over J^(1/3)");
    const std::size_t most = is_abaqus() ? kMostOgdenTermsOfAbaqus : kMostOgdenTermsOfCalculix;
    if (law.terms.size() > most) {
      refuse("components.stretch-bar",
             fmt::format("of {} powers: {} at most", law.terms.size(), most));
    }
    std::vector<double> numbers;
    for (const auto& [mu, alpha] : law.terms) numbers.insert(numbers.end(), {mu, alpha});
    return keyword(fmt::format("HYPERELASTIC, OGDEN, N={}", law.terms.size()),
                   with_ds(std::move(numbers), law.terms.size()));
  }

  std::string text_of(const ArrudaBoyceLaw& law) {
    const double d = first_d();
    const VolumeEnergy::Form form = solid_.law.volume.form;
    if (d > 0 && form != VolumeEnergy::Form::of_square && form != VolumeEnergy::Form::none) {
      lost_.emplace_back(
          "the form of the volume's energy: ARRUDA-BOYCE has bulk / 2 ((J^2 - 1) / 2 - ln J), the "
          "same to second order in J - 1");
    }
    return keyword("HYPERELASTIC, ARRUDA-BOYCE", {law.mu, law.lock, d});
  }

  std::string text_of(const CoupledMooneyRivlinLaw&) {
    refuse("components.I1", "of invariants that are not over J^(2/3)");
  }

  /// Numbers of a law with those of its volume behind them.
  std::vector<double> with_ds(std::vector<double> numbers, std::size_t count) {
    const VolumeEnergy::Form form = solid_.law.volume.form;
    if (form != VolumeEnergy::Form::of_ratio && form != VolumeEnergy::Form::none) {
      lost_.emplace_back(
          "the form of the volume's energy: written as bulk / 2 (J - 1)^2, the same to second "
          "order in J - 1");
    }
    numbers.push_back(first_d());
    numbers.insert(numbers.end(), count - 1, is_abaqus() ? 0 : kNoPower);
    return numbers;
  }

  /// D1 = 2 / bulk; 0 in Abaqus where the volume stays.
  double first_d() {
    double bulk = solid_.law.volume.bulk;
    if (solid_.law.volume.form == VolumeEnergy::Form::none) {
      if (is_abaqus()) return 0;
      bulk = kCalculixBulk * shear_modulus(solid_.law);
      lost_.push_back(fmt::format(
          "the constant volume: CalculiX has none; a bulk modulus of {} times the shear modulus "
          "({} Pa) stands for it",
          kCalculixBulk, format_number(bulk, 4)));
    }
    if (is_abaqus() || 2 / bulk >= kLeastD) return 2 / bulk;
    throw InputError({solid_.file, 0, "components"},
                     fmt::format("have a bulk modulus of {} Pa: CalculiX takes a D of 2 / bulk "
                                 "below 1e-10 as not given",
                                 format_number(bulk, 4)),
                     "at most 2e10 Pa");
  }

  [[noreturn]] void refuse(const std::string& field, const std::string& what) const {
    throw InputError({solid_.file, 0, field},
                     fmt::format("is a law {}, which {} does not have", what, name_of(tool_)),
                     "another law, or --to febio");
  }

  const SolidToConvert& solid_;
  KeywordTool tool_;
  std::vector<std::string> lost_;
};

}  // namespace

std::string_view name_of(KeywordTool tool) {
  return tool == KeywordTool::abaqus ? "Abaqus" : "CalculiX";
}

std::string keyword_number(double value) {
  std::string text = format_number(value);
  for (int digits = 17; text.size() > kLongestNumber; --digits) {
    text = format_number(value, digits);
  }
  return text;
}

std::string keyword_name(std::string_view text) {
  std::string name;
  for (const char c : text.substr(0, kLongestName - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool fits = byte < 0x80 && std::isalnum(byte) != 0;
    name += fits ? static_cast<char>(std::toupper(byte)) : '_';
  }
  const bool begins_well = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  return begins_well ? name : "M" + name;
}

ConvertedSolid keyword_material(const SolidToConvert& solid, KeywordTool tool) {
  LawWriter law(solid, tool);
  ConvertedSolid converted;
  converted.text = fmt::format("*MATERIAL, NAME={}\n", keyword_name(solid.material.name));
  if (solid.material.density > 0) converted.text += keyword("DENSITY", {solid.material.density});
  converted.text += law.text();
  converted.lost = std::move(law.lost());
  return converted;
}

}  // namespace pliant
