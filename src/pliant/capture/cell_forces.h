#pragma once

#include "pliant/capture/logged_forces.h"

namespace pliant {

/// Load cells that pull at cords, which cameras see.
class CellForces : public LoggedForces {
 public:
  explicit CellForces(const DicFile& dic);

  void see_cords(int frame, std::vector<std::optional<CordLine>> lines) override;
  std::optional<double> noise() const override;
  double balance_bound() const override;
  bool is_free(int frame) const override;
  std::vector<std::string> warnings(const std::vector<double>& ways) const override;

 private:
  /// By the ways of all cords at once, along each, since all were seen: what they pull with all
  /// together.
  Together together(const std::vector<double>& ways) const override;
  void place(double start) override;
  std::string add_forces(SessionFrame& frame, std::size_t number,
                         const std::vector<HeldPlace>& held) const override;
  std::vector<double> ways_of_cords() const;
  double largest_pull(std::size_t cell) const;
  /// Whether a cell reads so much that its cord pulls.
  bool pulls(std::size_t cell, std::size_t frame) const;

  CellRows rows_;
  CellLog cells_;
  std::vector<std::vector<std::optional<CordLine>>> lines_;  // by frame and cell
};

}  // namespace pliant
