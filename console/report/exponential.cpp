#include "console/report/exponential.h"

#include <algorithm>
#include <cmath>

namespace tacit {

double exponential(double x) {
  constexpr double kLimit = 700.0;
  // ln 2 in two parts, the first with enough trailing zeros that its multiples are exact.
  constexpr double kLn2High = 6.93147180369123816490e-01;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  if (x < -kLimit) {
    return 0.0;
  }
  const double bounded = std::min(x, kLimit);
  const double halvings = std::floor(bounded / (kLn2High + kLn2Low) + 0.5);
  const double rest = (bounded - halvings * kLn2High) - halvings * kLn2Low;
  double sum = 1.0;
  for (int term = 15; term > 0; --term) {
    sum = 1.0 + rest / term * sum;
  }
  return std::ldexp(sum, static_cast<int>(halvings));
}

}  // namespace tacit
