#include <algorithm>

#include "schema/documents.h"

namespace pliant::test {
namespace {

SchemaCase full_document(const std::string& name) {
  const std::vector<NamedDocument> full = full_documents();
  return std::ranges::find(full, name, &NamedDocument::name)->document;
}

}  // namespace

std::vector<NamedDocument> broken_patterns() {
  const SchemaCase board = full_document("board of tags"), chess = full_document("chessboard");
  const SchemaCase clips = full_document("labels of clips"),
                   cloth = full_document("texture of cloth");
  return {
      changed("tags of another family", board, "/board/family", "tag25h9"),
      changed("a board without columns", board, "/board/columns", 0),
      changed("half a row", board, "/board/rows", 1.5),
      changed("a tag without unit", board, "/board/tag", 20),
      changed("tags that touch", board, "/board/gap", "0 mm"),
      changed("a code that there is not", board, "/board/first_code", 587),
      changed("a board and a chessboard", board, "/chessboard", chess.document["chessboard"]),
      without("nothing that was drawn", board, "/board"),
      changed("a sheet without width", board, "/sheet/width", "0 mm"),
      changed("a ruler in pixels", board, "/ruler/drawn", 2362),
      without("a ruler that was only measured", board, "/ruler/drawn"),
      changed("squares of a chessboard by their area", chess, "/chessboard/square", "4 cm^2"),
      changed("a chessboard of one row", chess, "/chessboard/rows", 1),
      changed("no codes", clips, "/clips/codes", nlohmann::json::array()),
      changed("a code twice", clips, "/clips/codes/1", 0),
      changed("a code by its name", clips, "/clips/codes/0", "left"),
      without("labels without edge", clips, "/clips/edge"),
      changed("a negative seed", cloth, "/cloth/seed", -1),
      changed("no octaves", cloth, "/cloth/octaves", 0),
      changed("no dots", cloth, "/cloth/dpi", 0),
      without("waves of any length", cloth, "/cloth/finest"),
  };
}

}  // namespace pliant::test
