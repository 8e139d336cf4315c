// The rest of a sheet, a cable or an open mesh that comes down among obstacles. Start here.
#pragma once

#include "core/flex/flexible.h"
#include "core/flex/minimiser.h"

namespace trivet::flex {

/// A flexible body before it comes down. One of `grid`, `num_segments` and `faces`.
struct DrapeProblem {
  FlexMaterial material;
  std::optional<Grid> grid;               // of a sheet
  int num_segments = 0;                   // of a cable
  double length = 0;                      // of a cable, m
  std::vector<std::array<int, 3>> faces;  // of a mesh
  Points start;                           // where its vertices are; of a mesh: its rest shape
  std::vector<bool> pinned;               // of the vertices
  std::vector<double> loads = {};         // kg hung on the vertices of a cable; empty: none
};

struct DrapeOptions {
  MinimiserOptions minimiser;
  double pressure = ContactOptions{}.pressure;
  double layer = 5e-4;  // m
  double slip = 1e-4;   // m of elastic way of friction
  int levels = 0;       // from coarse to fine; 0: as many as help
};

struct DrapeResult {
  Ending ending = Ending::Stuck;
  Points x;
  Points friction;   // N on each vertex
  double layer = 0;  // m, of the contact on the finest level
  RestCertificate certificate;
  std::vector<double> shares;  // of the weight, by owners of obstacles
  std::vector<bool> touches;   // the same owners: in its layer
  double pin_share = 0;
  std::vector<double> pin_shares;  // the same by vertices
};

/// From coarse to fine: cells are halved exactly, so that no crossing can appear. The same bits for
/// any number of threads.
/// @param problem  its start is clear: see starts_clear().
DrapeResult drape(const DrapeProblem& problem, const Obstacles& obstacles,
                  const DrapeOptions& options, const Watch& watch = {});

/// The layer of a level's contact: at most a quarter of a cell.
double contact_layer(double layer, const Body& body);

/// The body of a problem, as it is on the finest level.
Body body_of(const DrapeProblem& problem);

/// The thing to which the start is nearer than it may be: an owner's number, or that it touches
/// itself.
struct StartContact {
  std::optional<int> owner;  // nullopt: itself
  Vec3 at = Vec3::Zero();
};
std::optional<StartContact> start_contact(const DrapeProblem& problem, const Obstacles& obstacles);

}  // namespace trivet::flex
