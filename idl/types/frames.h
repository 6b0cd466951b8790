#pragma once

#include <Eigen/Core>

#include "idl/types/elementary.h"

namespace tacit {

/// Frame tags. World: x east, y north, origin at the south-west corner of the mission area.
/// Body: x ahead, y to the left, origin at the robot's centre. Odometry: the body frame of that
/// robot at tick 0.
struct WorldFrame {};
struct BodyFrame {};
struct OdometryFrame {};

/// A planar vector that only mixes with vectors of its own frame. Metres unless a name says
/// otherwise.
template <class Frame>
struct FrameVec {
  Eigen::Vector2d xy{0.0, 0.0};

  FrameVec() = default;
  FrameVec(double x, double y) : xy(x, y) {}
  explicit FrameVec(const Eigen::Vector2d& v) : xy(v) {}

  [[nodiscard]] double x() const { return xy.x(); }
  [[nodiscard]] double y() const { return xy.y(); }
  [[nodiscard]] double dot(const FrameVec& o) const { return x() * o.x() + y() * o.y(); }
  [[nodiscard]] double cross(const FrameVec& o) const { return x() * o.y() - y() * o.x(); }
  [[nodiscard]] double squared_norm() const { return dot(*this); }
  [[nodiscard]] double norm() const { return std::sqrt(squared_norm()); }

  FrameVec& operator+=(const FrameVec& o) {
    xy += o.xy;
    return *this;
  }
  FrameVec& operator-=(const FrameVec& o) {
    xy -= o.xy;
    return *this;
  }
  friend FrameVec operator+(FrameVec a, const FrameVec& b) { return a += b; }
  friend FrameVec operator-(FrameVec a, const FrameVec& b) { return a -= b; }
  friend FrameVec operator-(const FrameVec& a) { return FrameVec{-a.x(), -a.y()}; }
  friend FrameVec operator*(double s, const FrameVec& v) { return FrameVec{s * v.x(), s * v.y()}; }
  friend bool operator==(const FrameVec& a, const FrameVec& b) {
    return a.x() == b.x() && a.y() == b.y();
  }
};

using WorldVec = FrameVec<WorldFrame>;
using BodyVec = FrameVec<BodyFrame>;
using OdometryVec = FrameVec<OdometryFrame>;

/// `v` scaled to length 1; the zero vector stays zero.
template <class Frame>
[[nodiscard]] FrameVec<Frame> unit(const FrameVec<Frame>& v) {
  const double length = v.norm();
  return length > 0.0 ? (1.0 / length) * v : FrameVec<Frame>{};
}

/// `v` shortened to at most `limit`.
template <class Frame>
[[nodiscard]] FrameVec<Frame> clipped(const FrameVec<Frame>& v, double limit) {
  const double squared = v.squared_norm();
  return squared > limit * limit ? (limit / std::sqrt(squared)) * v : v;
}

/// The direction in which a robot faces, held as a unit vector so that turning a vector into or
/// out of the body frame needs no trigonometry.
struct Heading {
  double cos = 1.0;
  double sin = 0.0;

  [[nodiscard]] static Heading from_rad(double angle_rad) {
    const SinCos sc = sin_cos(angle_rad);
    return {sc.cos, sc.sin};
  }
  /// Counter-clockwise from the frame's x axis, in (-pi, pi].
  [[nodiscard]] double rad() const { return arc_tangent(sin, cos); }
  [[nodiscard]] Heading turned(double angle_rad) const {
    const SinCos sc = sin_cos(angle_rad);
    const double c = cos * sc.cos - sin * sc.sin;
    const double s = sin * sc.cos + cos * sc.sin;
    const double scale = 1.0 / std::sqrt(c * c + s * s);
    return {c * scale, s * scale};
  }
};

/// Where a robot is and faces, in `Frame`.
template <class Frame>
struct FramePose {
  FrameVec<Frame> position_m;
  Heading heading;
};

using WorldPose = FramePose<WorldFrame>;
using OdometryPose = FramePose<OdometryFrame>;

/// Turns a vector given in `Frame` into the body frame of a robot that faces `heading`.
template <class Frame>
[[nodiscard]] BodyVec to_body(const Heading& heading, const FrameVec<Frame>& v) {
  return {heading.cos * v.x() + heading.sin * v.y(), heading.cos * v.y() - heading.sin * v.x()};
}

/// The inverse of `to_body`.
template <class Frame>
[[nodiscard]] FrameVec<Frame> from_body(const Heading& heading, const BodyVec& v) {
  return {heading.cos * v.x() - heading.sin * v.y(), heading.sin * v.x() + heading.cos * v.y()};
}

}  // namespace tacit
