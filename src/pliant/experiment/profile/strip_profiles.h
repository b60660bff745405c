#pragma once

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/profile/hanging_strip.h"
#include "pliant/measurement/profile_rows.h"
#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// Strips that hang from a clamp, their profiles measured; what is compared is the distance of each
/// measured point from the profile that the law predicts. A strip that may rest in several shapes
/// is compared in the nearest.
///
/// The measured value of every row is zero, the predicted one the distance (m), positive where the
/// predicted profile passes on the left of the measured point.
class StripProfiles : public ComponentExperiment {
 public:
  std::optional<Prediction> predict(const ComponentLaw& law, const Eigen::VectorXd& nuisance,
                                    bool with_jacobian) const override;
  Eigen::VectorXd unfitted_nuisance(const ComponentLaw& law) const override;
  double reference() const override;
  /// Of strips that were rolled the tighter half: their weight matters least.
  std::unique_ptr<ComponentExperiment> easy_part() const override;
  std::optional<StripShapes> shapes(const ComponentLaw& law,
                                    const Eigen::VectorXd& nuisance) const override;

 protected:
  /// A strip, and the measured profiles that should have its shape.
  struct Strip {
    std::vector<ProfileRows> profiles;
    Elastica elastica;
    Elastica finer;     ///< of a shape whose curvature jumps
    double rolled = 0;  ///< curvature that the strip was bent to before (1/m)
  };

  /// @param density  kg/m^2
  /// @param setting  column of what the experiment varies
  StripProfiles(const ExperimentSpec& spec, const DataRows& data, double density,
                std::string_view setting);

  /// Adds a profile of a strip of some length.
  /// @throws InputError where the profile has another length
  void add_strip(const ProfileRows& rows, double length, double rolled, const DataRows& data);
  /// Estimates the density (kg/m^2) along.
  void estimate_density(double density);

  const std::vector<ProfileRows>& profiles() const { return profiles_; }

 private:
  static std::optional<HangingStrip> hang(const Strip& strip, const ComponentLaw& law,
                                          double weight, bool with_derivatives);
  std::vector<const Strip*> slowest_first() const;
  /// Stated, or what the nuisance parameter says (N/m^2).
  double weight_by(const Eigen::VectorXd& nuisance) const;
  static void compare(const ProfileRows& measured, const StripProfile& predicted, double length,
                      Prediction& prediction);

  std::string setting_;
  double weight_ = 0;  // N/m^2
  std::vector<ProfileRows> profiles_;
  std::vector<Strip> strips_;
};

}  // namespace pliant
