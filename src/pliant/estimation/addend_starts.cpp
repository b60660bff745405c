#include "pliant/estimation/addend_starts.h"

#include <iterator>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

Addend begun(const AddendKind& kind, const std::vector<double>& shares, const DataScale& data) {
  Eigen::VectorXd values(std::ssize(shares));
  for (std::size_t i = 0; i < shares.size(); ++i) {
    values(static_cast<Eigen::Index>(i)) =
        shares[i] * data_unit(kind.parameters[i], data.stress, data.strain, data.seconds);
  }
  return {kind, values};
}

}  // namespace

std::vector<ComponentLaw> addend_starts(const ComponentLaw& law, const DataScale& data) {
  std::vector<ComponentLaw> laws{law};
  for (std::size_t k = 0; k < law.addends.size(); ++k) {
    const AddendKind& kind = law.addends[k].kind();
    PLIANT_ASSERT(!kind.starts.empty(), "a kind says where fits begin");
    std::vector<ComponentLaw> more;
    for (const ComponentLaw& begun_so_far : laws) {
      for (const std::vector<double>& shares : kind.starts) {
        more.push_back(begun_so_far);
        more.back().addends[k] = begun(kind, shares, data);
      }
    }
    laws = std::move(more);
  }
  return laws;
}

}  // namespace pliant
