#pragma once

#include <string>
#include <string_view>

#include "pliant/exchange/converted_solid.h"

namespace pliant {

/// The tools that read keyword files (.inp).
enum class KeywordTool { abaqus, calculix };

std::string_view name_of(KeywordTool tool);

/// A number in at most 20 characters, all that these tools read: with as many digits as have room
/// there, 13 or more.
std::string keyword_number(double value);

/// A name as these tools take it: letters, digits and underscores, beginning with a letter, in
/// capitals, of at most 80 characters.
std::string keyword_name(std::string_view text);

/// The keywords below *MATERIAL that hold density and law; with equal energy but for what is lost.
///
/// The energies are those of Abaqus' guide and of CalculiX' manual: sum C_ij (I1-bar - 3)^i (I2-bar
/// - 3)^j + sum (J - 1)^2i / D_i, and of Ogden's sum 2 mu / alpha^2 (...); Arruda and Boyce's is
/// with ((J^2 - 1) / 2 - ln J) / D. *ELASTIC is StVK in CalculiX, and a law of rates in Abaqus.
/// @throws InputError, with the field, for a law that the tool does not have
ConvertedSolid keyword_material(const SolidToConvert& solid, KeywordTool tool);

}  // namespace pliant
