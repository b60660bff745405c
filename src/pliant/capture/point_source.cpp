#include "pliant/capture/point_source.h"

#include "pliant/capture/point_frames.h"
#include "pliant/capture/space_points.h"
#include "pliant/capture/tracked_points.h"

namespace pliant {

std::unique_ptr<PointSource> point_source(const DicFile& dic, const ReadPicture& read_picture,
                                          const RunContext& context) {
  if (dic.views) return std::make_unique<SpacePoints>(dic, read_picture, context);
  if (dic.pictures) return std::make_unique<TrackedPoints>(dic, read_picture, context);
  return std::make_unique<PointFrames>(dic);
}

}  // namespace pliant
