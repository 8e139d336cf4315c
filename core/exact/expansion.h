// Expansions: exact numbers as sums of doubles [Shewchuk 1997]. The terms grow in magnitude and do
// not overlap, so the last one carries the sign. Exact unless a product over- or underflows. Only
// +, - and x, in a fixed order: the same bits on every machine. Products are split by hand [Dekker
// 1971]: without -march, std::fma is a library call per product, and slow where the hardware has
// none.
#pragma once

#include <array>

namespace trivet {

/// Holds at most `capacity` terms; zeros are never stored, so 0 has no terms. Capacities are sums
/// and products of those of the operands: overflow is impossible.
template <int capacity>
struct Expansion {
  int size = 0;
  std::array<double, capacity> terms{};

  int sign() const { return size == 0 ? 0 : terms[size - 1] > 0 ? 1 : -1; }
};

/// The exact sum of two expansions (fast expansion sum). @return the number of terms written to
/// `out`, at most num_e + num_f.
int sum_terms(const double* e, int num_e, const double* f, int num_f, double* out);

/// The exact product of an expansion and a number. @return the number of terms written to `out`,
/// at most 2 num_e.
int scale_terms(const double* e, int num_e, double factor, double* out);

/// Exactly x - y.
Expansion<2> exact_difference(double x, double y);

template <int n>
Expansion<n> operator-(Expansion<n> e) {  // by value: negated in place
  for (int i = 0; i < e.size; ++i) e.terms[i] = -e.terms[i];
  return e;
}

template <int n, int m>
Expansion<n + m> operator+(const Expansion<n>& e, const Expansion<m>& f) {
  Expansion<n + m> out;
  out.size = sum_terms(e.terms.data(), e.size, f.terms.data(), f.size, out.terms.data());
  return out;
}

template <int n, int m>
Expansion<n + m> operator-(const Expansion<n>& e, const Expansion<m>& f) {
  return e + (-f);
}

/// Multiplies term by term of f, which should be the shorter one.
template <int n, int m>
Expansion<2 * n * m> operator*(const Expansion<n>& e, const Expansion<m>& f) {
  // Each term of f scales e exactly; the products are summed as they come.
  Expansion<2 * n * m> out, last;
  for (int i = 0; i < f.size; ++i) {
    std::array<double, 2 * n> scaled;
    const int num = scale_terms(e.terms.data(), e.size, f.terms[i], scaled.data());
    last = out;
    out.size = sum_terms(last.terms.data(), last.size, scaled.data(), num, out.terms.data());
  }
  return out;
}

}  // namespace trivet
