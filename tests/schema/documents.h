#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/temporary_folder.h"
#include "schema/schema_judge.h"

namespace pliant::test {

/// A document with a name for messages.
struct NamedDocument {
  std::string name;
  SchemaCase document;
};

/// A document of a type that it states.
NamedDocument named(const std::string& name, const Document& document);

/// A document with one value replaced; a pointer to nothing adds it.
NamedDocument changed(const std::string& what, SchemaCase document, const char* pointer,
                      nlohmann::json value);
/// The same with a value taken away.
NamedDocument without(const std::string& what, SchemaCase document, const char* pointer);

/// A folder with the files that the documents here name.
class DocumentFolder : public TemporaryFolder {
 public:
  DocumentFolder();
};

/// One document of each input type in which every key that the type has stands, as far as keys go
/// together; and the other variants.
std::vector<NamedDocument> full_documents();

/// What users find: the documents in the pages of the documentation, the materials that come with
/// the program, the demo's lab, the example scenes.
std::vector<NamedDocument> shipped_documents();

/// What the program itself writes: from a virtual lab study, resolved study, material, fit and
/// evaluation; from a scene a simulation; a session.
std::vector<NamedDocument> written_documents();

/// A calibration of two cameras with everything that it can tell of.
NamedDocument written_calibration();

/// Documents of points of image correlation that every reader must refuse.
std::vector<NamedDocument> broken_points();

/// Documents of printed patterns that every reader must refuse.
std::vector<NamedDocument> broken_patterns();

/// Documents of cameras that every reader must refuse.
std::vector<NamedDocument> broken_rigs();

/// Documents that every reader must refuse, with what is wrong with them as a name.
std::vector<NamedDocument> broken_documents();

}  // namespace pliant::test
