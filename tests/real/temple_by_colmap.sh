#!/bin/sh
# Points of multiview_templeSparseRing by COLMAP (apt-get install colmap), its cameras known, for
# RealSlowTemple.LiesWhereColmapPutsIt:
#   tests/real/temple_by_colmap.sh DATA/multiview_templeSparseRing FOLDER
#   PLIANT_COLMAP=FOLDER ./dev real -R RealSlowTemple
set -eu
data=$(realpath "$1")
mkdir -p "$2/pictures" "$2/known"
cd "$2"
cp "$data"/*.png pictures/
rm -f database.db
export QT_QPA_PLATFORM=offscreen

# COLMAP counts the middle of the first pixel as (0.5, 0.5).
lens=$(awk 'NR == 2 { print $2 "," $6 "," $4 + 0.5 "," $7 + 0.5 }' "$data/templeSR_par.txt")
colmap feature_extractor --database_path database.db --image_path pictures \
  --ImageReader.single_camera 1 --ImageReader.camera_model PINHOLE \
  --ImageReader.camera_params "$lens" --SiftExtraction.use_gpu 0 --SiftExtraction.num_threads 1
colmap exhaustive_matcher --database_path database.db \
  --SiftMatching.use_gpu 0 --SiftMatching.num_threads 1

echo "1 PINHOLE 640 480 $lens" | tr , ' ' > known/cameras.txt
: > known/points3D.txt
# Rotations as quaternions, by the largest of their numbers; a second, empty line for each picture.
awk 'NR > 1 && NF == 22 {
  for (i = 0; i < 9; ++i) r[int(i / 3), i % 3] = $(11 + i)
  trace = r[0, 0] + r[1, 1] + r[2, 2]
  i = 0
  if (r[1, 1] > r[i, i]) i = 1
  if (r[2, 2] > r[i, i]) i = 2
  j = (i + 1) % 3
  k = (i + 2) % 3
  if (trace > r[i, i]) {
    s = 2 * sqrt(1 + trace)
    w = s / 4
    for (i = 0; i < 3; ++i) q[i] = (r[(i + 2) % 3, (i + 1) % 3] - r[(i + 1) % 3, (i + 2) % 3]) / s
  } else {
    s = 2 * sqrt(1 + r[i, i] - r[j, j] - r[k, k])
    w = (r[k, j] - r[j, k]) / s
    q[i] = s / 4
    q[j] = (r[j, i] + r[i, j]) / s
    q[k] = (r[k, i] + r[i, k]) / s
  }
  printf "%d %.15g %.15g %.15g %.15g %s %s %s 1 %s\n\n", NR - 1, w, q[0], q[1], q[2], $20, $21, $22, $1
}' "$data/templeSR_par.txt" > known/images.txt
colmap point_triangulator --database_path database.db --image_path pictures \
  --input_path known --output_path .
colmap model_converter --input_path . --output_path . --output_type TXT
colmap model_analyzer --path .
