#include "roomgraph/scans/rewrite_simplemap.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "roomgraph/base/checked_file.h"
#include "roomgraph/scans/mrpt_object.h"

namespace roomgraph {
namespace {

template <class T>
std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string textBytes(const std::string& text) { return raw(std::uint32_t(text.size())) + text; }

/** What MRPT writes for a speed that is not known. */
std::string noTwist() { return textBytes("std::optional") + textBytes("TTwist3D") + '\0'; }

/** A symmetric matrix of n x n as MRPT streams it: the diagonal, then what is above it, by rows. */
std::size_t symmetricIndex(std::size_t n, std::size_t row, std::size_t column) {
  if (row == column) return row;
  std::size_t index = n;
  for (std::size_t r = 0; r < row; ++r) index += n - 1 - r;
  return index + column - row - 1;
}

/** The inverse of a covariance; its entries have the names of the covariance's. */
PlanarCovariance inverseOf(const PlanarCovariance& c) {
  const double xx = c.yy * c.pp - c.yp * c.yp, xy = c.xp * c.yp - c.xy * c.pp;
  const double xp = c.xy * c.yp - c.yy * c.xp;
  const double scale = 1 / (c.xx * xx + c.xy * xy + c.xp * xp);
  PlanarCovariance i;
  i.xx = scale * xx, i.xy = scale * xy, i.xp = scale * xp;
  i.yy = scale * (c.xx * c.pp - c.xp * c.xp), i.yp = scale * (c.xy * c.xp - c.xx * c.yp);
  i.pp = scale * (c.xx * c.yy - c.xy * c.xy);
  return i;
}

/** Walks along the objects of a pose, and changes its numbers in place. */
class Mover {
 public:
  Mover(ByteView content, const std::string& file, std::string& bytes)
      : content_(content), file_(file), bytes_(bytes) {}

  void move(std::size_t begin, const PoseMove& move) {
    motion_ = move.motion;
    ByteReader reader(content_, file_);
    reader.skip(begin);
    const ObjectHeader header = readObjectHeader(reader);
    const std::string& name = header.className;
    const bool isInformation = name == "CPosePDFGaussianInf" || name == "CPose3DPDFGaussianInf";
    if (name == "CPose3DPDFGaussian" || name == "CPose3DPDFGaussianInf") {
      movePose3D(reader);
      if (move.covariance) setBlock({reader.peek(), true}, 6, *move.covariance, isInformation);
    } else if (name == "CPosePDFGaussian" || name == "CPosePDFGaussianInf") {
      movePose2D(reader, isInformation);
      if (move.covariance) setPlanar(reader, header, *move.covariance, isInformation);
    } else {
      moveParticles(reader, name == "CPose3DPDFParticles", header.version);
    }
  }

 private:
  void set(const StoredNumbers& numbers, std::size_t index, double to) {
    if (numbers.areDouble) put(numbers, index, to);
    if (!numbers.areDouble) put(numbers, index, float(to));
  }
  template <class T>
  void put(const StoredNumbers& numbers, std::size_t index, T value) {
    char* first = bytes_.data() + (numbers.first - content_.data);
    std::memcpy(first + index * sizeof value, &value, sizeof value);
  }

  /** Turns two numbers that are the x and y of a vector. */
  void turnPair(const StoredNumbers& numbers, std::size_t x, std::size_t y, double angle,
                Point shift = {}) {
    const Point to = turned({numbers.at(x), numbers.at(y)}, angle) + shift;
    set(numbers, x, to.x), set(numbers, y, to.y);
  }
  void movePlace(const StoredNumbers& place) {
    turnPair(place, 0, 1, motion_.phi, motion_.shift());
  }

  /** x, y and phi, or x, y, z and yaw. */
  void moveCoordinates(const StoredNumbers& pose, std::size_t yaw) {
    movePlace(pose);
    set(pose, yaw, wrappedAngle(pose.at(yaw) + motion_.phi));
  }

  /** Leaves `reader` behind the object. */
  void movePose3D(ByteReader& reader) {
    const ObjectHeader header = readObjectHeader(reader);
    if (header.version <= 1) {
      const StoredNumbers m = readMatrix(reader).numbers;  // 4 x 4
      for (std::size_t c = 0; c < 3; ++c) turnPair(m, c, 4 + c, motion_.phi);
      turnPair(m, 3, 7, motion_.phi, motion_.shift());
    } else {
      movePlace({reader.peek(), true});
      reader.skip(3 * sizeof(double));
      const StoredNumbers turn{reader.peek(), true};
      if (header.version == 2) {  // a quaternion, r x y z
        turnPair(turn, 0, 3, motion_.phi / 2), turnPair(turn, 1, 2, motion_.phi / 2);
      } else {
        for (std::size_t c = 0; c < 3; ++c) turnPair(turn, c, 3 + c, motion_.phi);
      }
      reader.skip((header.version == 2 ? 4 : 9) * sizeof(double));
    }
    readObjectEnd(reader, header);
  }

  /** An object, or with `isBare` its coordinates alone. */
  void movePose2D(ByteReader& reader, bool isBare) {
    ObjectHeader header;
    if (!isBare) header = readObjectHeader(reader);
    const bool areDouble = isBare || header.version > 0;
    moveCoordinates({reader.peek(), areDouble}, 2);
    reader.skip(3 * (areDouble ? sizeof(double) : sizeof(float)));
    if (!isBare) readObjectEnd(reader, header);
  }

  void moveParticles(ByteReader& reader, bool are3D, int version) {
    for (auto left = reader.get<std::uint32_t>(); left > 0; --left) {
      reader.skip(sizeof(double));  // its weight
      if (version == 0) {
        if (are3D) movePose3D(reader);
        if (!are3D) movePose2D(reader, false);
        continue;
      }
      moveCoordinates({reader.peek(), true}, are3D ? 3 : 2);
      reader.skip((are3D ? 6 : 3) * sizeof(double));
    }
  }

  void setPlanar(ByteReader& reader, const ObjectHeader& header, const PlanarCovariance& covariance,
                 bool isInformation) {
    if (isInformation || header.version > 0)
      return setBlock({reader.peek(), isInformation || header.version > 1}, 3, covariance,
                      isInformation);
    const StoredNumbers m = readMatrix(reader).numbers;
    const std::array<double, 9> all{covariance.xx, covariance.xy, covariance.xp,
                                    covariance.xy, covariance.yy, covariance.yp,
                                    covariance.xp, covariance.yp, covariance.pp};
    for (std::size_t i = 0; i < all.size(); ++i) set(m, i, all[i]);
  }

  /** Of a symmetric matrix over x, y, phi, or x, y, z, yaw, pitch, roll. */
  void setBlock(const StoredNumbers& symmetric, std::size_t n, const PlanarCovariance& covariance,
                bool isInformation) {
    const PlanarCovariance c = isInformation ? inverseOf(covariance) : covariance;
    const std::size_t yaw = n == 3 ? 2 : 3;
    for (const std::size_t row : {std::size_t(0), std::size_t(1), yaw})
      for (std::size_t k = 0; k < n; ++k)
        if (k != row) set(symmetric, symmetricIndex(n, std::min(row, k), std::max(row, k)), 0);
    set(symmetric, 0, c.xx), set(symmetric, 1, c.yy), set(symmetric, yaw, c.pp);
    set(symmetric, symmetricIndex(n, 0, 1), c.xy);
    set(symmetric, symmetricIndex(n, 0, yaw), c.xp);
    set(symmetric, symmetricIndex(n, 1, yaw), c.yp);
  }

  ByteView content_;
  const std::string& file_;
  std::string& bytes_;
  Transform2D motion_;
};

bool isMoved(const PoseMove& move) {
  return move.covariance || move.motion.x != 0 || move.motion.y != 0 || move.motion.phi != 0;
}

}  // namespace

std::string joinSimplemaps(const std::vector<SimplemapPart>& parts) {
  if (parts.empty()) return {};
  const auto newest = std::max_element(parts.begin(), parts.end(),
                                       [](const SimplemapPart& l, const SimplemapPart& r) {
                                         return l.recording.version < r.recording.version;
                                       });
  std::uint32_t count = 0;
  for (const SimplemapPart& part : parts) count += std::uint32_t(part.frames.size());
  const std::size_t head = newest->recording.frames.front().begin - sizeof count;
  std::string joined = newest->content.substr(0, head) + raw(count);
  for (const SimplemapPart& part : parts) {
    const bool lacksTwist = newest->recording.version >= 2 && part.recording.version < 2;
    for (const std::size_t k : part.frames) {
      const Recording::Frame& frame = part.recording.frames[k];
      joined.append(part.content, frame.begin, frame.end - frame.begin);
      if (lacksTwist) joined += noTwist();
    }
  }
  return joined + char(kObjectEnd);
}

std::string movePoses(ByteView content, const Recording& recording,
                      const std::vector<PoseMove>& moves) {
  const std::vector<Recording::Frame>& frames = recording.frames;
  if (frames.size() != moves.size() || (!frames.empty() && frames.back().end > content.size))
    refuse(recording.file, "has changed while it was read", kSaveMapAgain);
  std::string bytes = content.text();
  Mover mover(content, recording.file, bytes);
  for (std::size_t k = 0; k < moves.size(); ++k)
    if (isMoved(moves[k])) mover.move(frames[k].begin, moves[k]);
  return bytes;
}

}  // namespace roomgraph
