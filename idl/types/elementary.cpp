#include "idl/types/elementary.h"

namespace tacit {
namespace {

// pi/2 in two parts, so that the reduction keeps its low bits (Cody and Waite 1980).
constexpr double kHalfPiHigh = 1.5707963267341256;
constexpr double kHalfPiLow = 6.077100506506192e-11;

// Taylor coefficients; on [-pi/4, pi/4] the first omitted term is below 1e-19.
double sine_series(double x) {
  const double z = x * x;
  double sum = -1.0 / 1307674368000.0;
  sum = sum * z + 1.0 / 6227020800.0;
  sum = sum * z - 1.0 / 39916800.0;
  sum = sum * z + 1.0 / 362880.0;
  sum = sum * z - 1.0 / 5040.0;
  sum = sum * z + 1.0 / 120.0;
  sum = sum * z - 1.0 / 6.0;
  return x + x * z * sum;
}

double cosine_series(double x) {
  const double z = x * x;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * z - 1.0 / 87178291200.0;
  sum = sum * z + 1.0 / 479001600.0;
  sum = sum * z - 1.0 / 3628800.0;
  sum = sum * z + 1.0 / 40320.0;
  sum = sum * z - 1.0 / 720.0;
  sum = sum * z + 1.0 / 24.0;
  return 1.0 - 0.5 * z + z * z * sum;
}

// atan on [0, 1]: atan(t) = 2 atan(t / (1 + sqrt(1 + t^2))) halves the angle twice, which leaves
// an argument below 0.2 for the series.
double arc_tangent_unit(double t) {
  double r = t;
  for (int halving = 0; halving < 2; ++halving) {
    r = r / (1.0 + std::sqrt(1.0 + r * r));
  }
  const double z = r * r;
  double sum = 1.0 / 23.0;
  for (int odd = 21; odd >= 1; odd -= 2) {
    sum = 1.0 / odd - z * sum;
  }
  return 4.0 * r * sum;
}

}  // namespace

SinCos sin_cos(double angle_rad) {
  const double quarters = std::floor(angle_rad * (2.0 / kPi) + 0.5);
  const double r = (angle_rad - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
  const double s = sine_series(r);
  const double c = cosine_series(r);
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double arc_tangent(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) {
    return 0.0;
  }
  const double first_octant =
      ay <= ax ? arc_tangent_unit(ay / ax) : 0.5 * kPi - arc_tangent_unit(ax / ay);
  const double upper = x < 0.0 ? kPi - first_octant : first_octant;
  return y < 0.0 ? -upper : upper;
}

double natural_log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < 0.7071067811865476) {
    mantissa *= 2.0;
    --exponent;
  }
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double z = s * s;
  double sum = 1.0 / 23.0;
  for (int odd = 21; odd >= 1; odd -= 2) {
    sum = 1.0 / odd + z * sum;
  }
  return 2.0 * s * sum + exponent * 0.6931471805599453;
}

double wrapped_rad(double angle_rad) {
  const double wrapped = angle_rad - std::floor(angle_rad / (2.0 * kPi) + 0.5) * (2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

}  // namespace tacit
