#include "pliant/capture/plane_view.h"

#include <Eigen/LU>

namespace pliant {

Eigen::Matrix2Xd PlaneView::on_plane(const Eigen::Matrix2Xd& pixels) const {
  return (to_plane * lens.straightened(pixels).colwise().homogeneous()).colwise().hnormalized();
}

Eigen::Matrix2Xd PlaneView::in_picture(const Eigen::Matrix2Xd& places) const {
  return lens.seen((to_plane.inverse() * places.colwise().homogeneous()).colwise().hnormalized());
}

PlaneView straight_view(double scale) {
  PlaneView view;
  view.to_plane.diagonal() << scale, scale, 1;
  return view;
}

}  // namespace pliant
