// Cables and sheets whose pins objects hold: they go along when these move.
#pragma once

#include "core/scene/transaction.h"
#include "ops/operations/operation_run.h"

namespace trivet {

class CarriedDrapes {
 public:
  /// @param moving  that an operation is about to move: what it holds is taken away meanwhile,
  ///   unless other free objects touch that. nullopt: it moves none by itself.
  CarriedDrapes(Transaction& transaction, std::optional<ObjectId> moving);

  /// Drapes again what was held by objects that are elsewhere now, and puts back the others.
  /// @param result  refused if one of them is.
  void follow(Transaction& transaction, OperationRun& run, OperationResult& result) const;

  bool takes_any_away() const;

 private:
  struct Held {
    ObjectId draped;
    std::vector<std::pair<ObjectId, Pose>> holders;  // before the move
    Pose pose;
    bool is_away = false;
  };
  static void put_back(Transaction& transaction, const Held& held, OperationRun& run);

  std::vector<Held> m_held;
};

/// The scene without what is taken away while an object moves; null: that is nothing.
std::unique_ptr<const Scene> without_carried(const Scene& scene, ObjectId moving);

}  // namespace trivet
