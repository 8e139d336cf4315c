#include "core/exact/expansion.h"

#include <cmath>

namespace trivet {
namespace {

// high + low is the exact result, high the rounded one.
struct Pair {
  double high, low;
};

Pair two_sum(double a, double b) {  // [Knuth 1969]
  const double sum = a + b;
  // The parts that went into the sum are recovered from it; the rest is what rounding took.
  const double b_part = sum - a, a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// Two halves of at most 26 bits, with exact products.
Pair split(double a) {                     // [Veltkamp 1968]
  const double shifted = 134217729.0 * a;  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

Pair two_product(double a, double b) {  // [Dekker 1971]
  const double product = a * b;
  const Pair x = split(a), y = split(b);
  const double low = ((x.high * y.high - product) + x.high * y.low + x.low * y.high);
  return {product, low + x.low * y.low};
}

}  // namespace

// Merges by magnitude and carries the sum upwards; each rounding error is a term of the result
// [Shewchuk 1997, theorem 13]. Operands come from two_sum, two_product or these functions, so they
// are strongly nonoverlapping, as the theorem demands; so is the result.
int sum_terms(const double* e, int num_e, const double* f, int num_f, double* out) {
  int size = 0;
  double carry = 0;
  for (int i = 0, j = 0; i < num_e || j < num_f;) {
    // The smaller term goes first.
    const bool take_e = j == num_f || (i < num_e && std::abs(e[i]) < std::abs(f[j]));
    const Pair s = two_sum(carry, take_e ? e[i++] : f[j++]);
    if (s.low != 0) out[size++] = s.low;
    carry = s.high;
  }
  if (carry != 0) out[size++] = carry;
  return size;
}

// [Shewchuk 1997, theorem 19].
int scale_terms(const double* e, int num_e, double factor, double* out) {
  // Zeros are left out: expansions stay short, and their last term carries the sign.
  int size = 0;
  double carry = 0;
  const auto put = [&](double term) {
    if (term != 0) out[size++] = term;
  };
  for (int i = 0; i < num_e; ++i) {
    // Each product has two parts. The low one joins the carry, the high one what is left of that.
    const Pair p = two_product(e[i], factor);
    const Pair low = two_sum(carry, p.low);
    put(low.low);
    const Pair high = two_sum(p.high, low.high);
    put(high.low);
    carry = high.high;
  }
  put(carry);
  return size;
}

Expansion<2> exact_difference(double x, double y) {
  Expansion<2> out;
  const Pair d = two_sum(x, -y);
  if (d.low != 0) out.terms[out.size++] = d.low;
  if (d.high != 0) out.terms[out.size++] = d.high;
  return out;
}

}  // namespace trivet
