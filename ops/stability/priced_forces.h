// Contact forces that balance bodies, where touches have prices that change from time to time.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ops/settle/linear_program.h"
#include "ops/stability/contact_forces.h"

namespace trivet {

/// The program of contact_forces(), in which pushes of each touch have their own price. Only
/// touches that lower the cost take part (column generation), and each solution starts where the
/// one before ended: of hundreds of touches in a heap few carry.
class PricedForces {
 public:
  /// The end of programs, from which others of the same bodies start a little later.
  struct End {
    struct OfTouch {
      BodyContact touch;
      LinearProgram::Basis columns;
    };
    std::vector<OfTouch> touches;  // that carried
    LinearProgram::Basis rest;     // of what is missing, and of rows; empty: nothing has ended
  };

  /// @param part  any bodies; it has to live as long. `more` does not count. @param clearance
  /// metres. @param first  each touch: takes part from the beginning. @param start  the end of
  /// others, of as many bodies: touches at the same places take part, too.
  PricedForces(const FreeBodies& part, double clearance, const std::vector<char>& first,
               const End& start = {});

  /// The cheapest forces; residual is their price and that of what is missing.
  /// @param prices  of each touch, >= 0: of a push as heavy as what its body `on` carries. A
  /// missing weight costs 1.
  PartForces find(std::span<const double> prices);

  /// Touches that take part by now.
  size_t num_joined() const { return m_joined.size(); }
  End end() const;

 private:
  void join(size_t k);
  void start_from(const End& end);
  std::optional<size_t> same_place(const BodyContact& touch) const;
  bool join_best(std::span<const double> gains);
  PartForces of_all_touches(PartForces forces) const;

  const FreeBodies& m_part;
  const double m_clearance;
  const std::vector<double> m_carried;
  std::vector<size_t> m_joined;  // touches, in the order of their columns
  std::vector<char> m_is_joined;
  LinearProgram::Basis m_basis;      // where the last program ended
  size_t m_num_columns = 0;          // of touches, in that
  std::vector<size_t> m_columns_of;  // of each that has joined, in the last program
};

/// A few of each pair of bodies whose forces would lower the cost most, by their gains: so a
/// program stays small, and different places of a large face take part. Touches of one pair are
/// neighbours in the list.
std::vector<size_t> touches_that_join(std::span<const BodyContact> touches,
                                      std::span<const double> gains);

}  // namespace trivet
