#include "roomgraph/scans/StoredPose.h"

#include <mrpt/math/CQuaternion.h>
#include <mrpt/system/datetime.h>

#include "roomgraph/scans/object_header.h"
#include "roomgraph/scans/read_simplemap.h"

namespace roomgraph {
namespace {

std::optional<double> timeOf(const Recording::Frame& frame) {
  for (const RangeScan& scan : frame.scans)
    if (scan.time != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(scan.time);
  for (const PointCloud& cloud : frame.clouds)
    if (cloud.time != INVALID_TIMESTAMP) return mrpt::Clock::toDouble(cloud.time);
  return std::nullopt;
}

}  // namespace

StoredPoses readStoredPoses(CheckedFile& file) {
  if (!isSimplemap(file)) refuse(file.name(), "is no simplemap", "give one");
  const Recording recording = readSimplemap(file);
  StoredPoses poses;
  poses.mapVersion = recording.version;
  ByteReader reader(file.head(), file.name());
  readObjectHeader(reader);
  reader.skip(sizeof(std::uint32_t));
  poses.headEnd = reader.position();
  for (const Recording::Frame& frame : recording.frames) {
    StoredPose pose;
    pose.begin = frame.begin, pose.end = frame.end;
    pose.place = {frame.robot.x(), frame.robot.y(), frame.robot.z()};
    mrpt::math::CQuaternionDouble q;
    frame.robot.getAsQuaternion(q);
    pose.turn = {q.x(), q.y(), q.z(), q.r()};
    pose.time = timeOf(frame);
    poses.frames.push_back(pose);
  }
  return poses;
}

}  // namespace roomgraph
