#include "pliant/experiment/drape/drape_setup.h"

namespace pliant {

const std::vector<DrapeHistory>& drape_histories() {
  static const std::vector<DrapeHistory> all{DrapeHistory::lowered, DrapeHistory::shaken,
                                             DrapeHistory::pulled};
  return all;
}

std::string_view name_of(DrapeHistory history) {
  switch (history) {
    case DrapeHistory::shaken:
      return "shaken";
    case DrapeHistory::pulled:
      return "pulled";
    case DrapeHistory::lowered:
      break;
  }
  return "lowered";
}

}  // namespace pliant
