#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "pliant/contact/surface_contact.h"
#include "pliant/mechanics/system.h"

#include "contact/stacked_sheets.h"

namespace pliant::test {

/// Free sheets that push and rub each other.
struct TouchingSheets {
  static constexpr double kThickness = 2e-3, kStiffness = 40;

  TouchingSheets(Sheets made, double friction) : sheets(std::move(made)) {
    const Eigen::Index count = sheets.positions.cols();
    system = std::make_unique<System>(sheets.positions, Eigen::VectorXd::Ones(count));
    const auto surface = std::make_shared<const ContactSurface>(
        sheets.positions, ContactSurface::Faces{sheets.faces},
        std::vector<bool>(static_cast<size_t>(count), true));
    contact = std::make_shared<SurfaceContact>(surface, sheets.positions,
                                               Eigen::VectorXd::Constant(count, kStiffness),
                                               SurfaceContactLaw{kThickness, friction});
    system->add(contact);
    system->finish();
    state = system->initial_state();
  }

  double evaluate(const Eigen::Matrix3Xd& positions, Eigen::Matrix3Xd* gradient = nullptr) const {
    if (gradient) gradient->setZero(3, positions.cols());
    Derivatives derivatives{{}, gradient, nullptr};
    system->evaluate({positions, {}}, {.from = state}, Curvature::exact, derivatives);
    return derivatives.energy.total();
  }

  Sheets sheets;
  std::unique_ptr<System> system;
  std::shared_ptr<SurfaceContact> contact;
  State state;
};

}  // namespace pliant::test
