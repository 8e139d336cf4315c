#include "ops/operations/drape.h"

#include "core/flex/judge.h"
#include "core/flex/self_crossings.h"
#include "ops/operations/delete.h"
#include "ops/operations/drape_parts.h"
#include "ops/operations/drape_watch.h"
#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr double kLargestStretch = 1.3;
constexpr Accepts kSize{Sort::Coordinates, 1e-3, 1e3, "metres"};
constexpr Accepts kCell{Sort::Number, 1e-4, 1e3, "metres", {}, 0};
constexpr Accepts kThickness{Sort::Number, 1e-5, 1, "metres"};
constexpr Accepts kFlexDensity{Sort::Number, 1e-4, 1e3, "kg/m2, or kg/m for a cable"};
constexpr Accepts kBending{Sort::Number, 0, 1e6, "N m, or N m2 for a cable"};
constexpr Accepts kFlexFriction{Sort::Number, 0, kMaxFriction};
constexpr Accepts kNetForce{Sort::Number, 1e-7, flex::kRestingForce, "parts of its weight"};
constexpr Accepts kSteps{Sort::Whole, 1, 1e6};

std::string names_of(bool cables) {
  std::string out;
  for (const flex::FlexPreset& preset : flex::flex_presets())
    if (preset.is_cable == cables) out += (out.empty() ? "" : ", ") + preset.material.name;
  return out;
}

std::optional<InvalidArgument> refuse_material(const DrapeOperation& o) {
  const bool is_cable = !o.path.empty();
  const flex::FlexPreset* const preset = flex::flex_preset(o.material);
  // A preset is for sheets or for cables, never for both.
  if (o.material.empty() || (preset && preset->is_cable == is_cable)) return std::nullopt;
  return InvalidArgument{"material", "\"" + o.material + "\"", names_of(is_cable)};
}

std::optional<InvalidArgument> refuse_thickness(const DrapeOperation& o) {
  const flex::Grid grid = grid_of(o);
  const double cell = std::min(grid.length_u / grid.num_u, grid.length_v / grid.num_v);
  const double least = least_cell(flex_material(o).thickness);
  if (cell >= least) return std::nullopt;
  return InvalidArgument{"cell", in_english(figure(cell)),
                         say("cells of %1 m or more, twice the thickness", figure(least))};
}

std::optional<InvalidArgument> refuse_size(const DrapeOperation& o) {
  // A mesh brings its own cells.
  if (o.of) return std::nullopt;
  if (!o.size && (o.path.size() < 2 || !(length_of(o.path) > 1e-3)))
    return InvalidArgument{"path", std::to_string(o.path.size()) + " points",
                           "two or more, over a millimetre or more"};
  const double count = o.size ? 1.0 * grid_of(o).num_u * grid_of(o).num_v : num_segments_of(o);
  if (count >= kMaxFlexVertices)
    return InvalidArgument{"cell", in_english(figure(o.cell)),
                           say("lengths that give at most %1 cells", kMaxFlexVertices)};
  return o.size ? refuse_thickness(o) : std::nullopt;
}

std::optional<InvalidArgument> refuse_holders(const DrapeOperation& o) {
  if (o.held_by.empty() || o.held_by.size() == o.pins.size()) return std::nullopt;
  return InvalidArgument{"held_by", std::to_string(o.held_by.size()) + " names",
                         say("%1, one for each pin", o.pins.size())};
}

std::optional<InvalidArgument> refuse_drape(const DrapeOperation& o) {
  if (o.again) return std::nullopt;
  if (auto found = refuse_holders(o)) return found;
  if (auto found = refuse_material(o)) return found;
  return refuse_size(o);
}

bool crosses(const flex::DrapeProblem& problem, const flex::Points& x) {
  if (problem.num_segments > 0) return false;  // a line; its distances say all
  const auto faces = body_of(problem).faces;
  return flex::self_crossing(x, faces) || flex::self_crossing(flex::rounded_to_float32(x), faces);
}

std::optional<Refusal> refuse_start(const Scene& scene, const std::string& name,
                                    const flex::DrapeProblem& problem,
                                    const DrapeSurroundings& around) {
  // The start may touch nothing, as no step undoes a crossing.
  const auto contact = start_contact(problem, around.obstacles);
  if (contact && contact->owner)
    return Refusal{Refusal::Cause::AlreadyTouches,
                   {{name, std::nullopt}, named(scene, around.owners[*contact->owner])}};
  if (!contact && !crosses(problem, problem.start)) return std::nullopt;
  Refusal why{Refusal::Cause::CrossesItself, {{name, std::nullopt}}};
  why.at = Refusal::At::Start;
  return why;
}

Refusal not_at_rest(const Named& name, const RestCertificate& c, double net_force) {
  const Vec3& at = c.net_force_at;
  return {Refusal::Cause::NotAtRest,
          {name},
          {{"steps", 1.0 * c.num_steps},
           {"net_force", net_force},
           {"x", at.x()},
           {"y", at.y()},
           {"z", at.z()}}};
}

std::optional<Refusal> refuse_end(const Named& name, const flex::DrapeProblem& problem,
                                  const flex::DrapeResult& result) {
  const RestCertificate& c = result.certificate;
  // The end is refused if it does not rest, is stretched too far, or crosses itself.
  if (result.ending != flex::Ending::AtRest) return not_at_rest(name, c, c.net_force);
  if (c.stretch > kLargestStretch)
    return Refusal{Refusal::Cause::Overstretched,
                   {name},
                   {{"stretch", c.stretch}, {"largest_stretch", kLargestStretch}}};
  if (crosses(problem, result.x)) return Refusal{Refusal::Cause::CrossesItself, {name}};
  return std::nullopt;
}

// As check will judge it: from what is stored.
std::optional<Refusal> refuse_judged(const Named& name, const Object& object,
                                     const DrapeSurroundings& around) {
  const flex::Judgement judged =
      flex::judge(*object.flexible, object.world_from_object(), around.obstacles);
  if (judged.is_at_rest()) return std::nullopt;
  return not_at_rest(name, object.flexible->certificate, judged.net_force);
}

flex::DrapeOptions options_of(const DrapeOperation& o) {
  flex::DrapeOptions out;
  out.minimiser.tolerance = o.net_force;
  out.minimiser.max_steps = o.steps;
  return out;
}

void keep_looks(const Object& before, Object& object) {
  auto model = std::make_shared<Model>(*object.model);
  model->materials = before.model->materials;
  object.model = std::move(model);
  object.group = before.group;
}

std::optional<Refusal> refuse_holders(const Scene& scene, const DrapeOperation& o) {
  for (const std::string& name : o.held_by) {
    const auto id = scene.find(name);
    if (!id) return unknown_object(scene, name);
    if (!scene.at(*id).placed)
      return Refusal{Refusal::Cause::NotPlaced, {named(scene, Support(*id))}};
  }
  return std::nullopt;
}

// Into the scene, judged like every object that stands.
OperationResult stand_draped(Transaction& transaction, Object object, OperationRun& run) {
  const Pose pose = object.pose;
  // The draped object is a solid like any other from here on.
  const ObjectId id = transaction.add(std::move(object));
  if (auto why = refuse_stand(transaction.scene(), id, pose, run.options)) {
    why->at = Refusal::At::End;
    return refused(std::move(*why));
  }
  const PlacedBox placed{id, expected_box(transaction.scene(), transaction.scene().at(id), pose)};
  const double clearance =
      clearance_near(transaction.scene(), run.options, placed.box, {&placed, 1});
  stand_at(transaction, id, pose, rest_rules(run.options, clearance));
  OperationResult result;
  result.end = OperationResult::End::AtRest;
  result.milliseconds = run.stopwatch.milliseconds();
  return result;
}

// @param before  the object that it was, draped again; null: a new one.
OperationResult bring_down(Transaction& transaction, const DrapeOperation& o,
                           const flex::DrapeProblem& problem, const Object* before,
                           OperationRun& run) {
  const Scene& scene = transaction.scene();
  const DrapeSurroundings around = drape_surroundings(scene, problem.start, problem.length);
  const Named name{o.object, std::nullopt};
  if (around.owners.empty() && o.pins.empty())
    return refused({Refusal::Cause::NothingBelow, {name}});
  if (auto why = refuse_start(scene, o.object, problem, around)) return refused(std::move(*why));
  DrapeShow show(o.object, problem);
  const flex::DrapeResult draped =
      flex::drape(problem, around.obstacles, options_of(o), [&](const flex::Progress& progress) {
        show.step(progress);
        return !run.interrupt.reason();
      });
  if (draped.ending == flex::Ending::Stopped) {
    OperationResult result;
    run.interrupt.refuse("drape", name, result);
    return result;
  }
  if (auto why = refuse_end(name, problem, draped)) return refused(std::move(*why));
  Object object = draped_object(scene, o, problem, around, draped);
  if (before) keep_looks(*before, object);
  if (auto why = refuse_judged(name, object, around)) return refused(std::move(*why));
  return stand_draped(transaction, std::move(object), run);
}

constexpr unsigned kSheet = 0, kCable = 1, kAgain = 2, kMesh = 3;
constexpr std::initializer_list<unsigned> kNew = {kSheet, kCable, kMesh};

std::vector<Row<DrapeOperation>> drape_rows() {
  using P = DrapeOperation;
  using R = Row<P>;
  return {
      R("object", &P::object, kNewName,
        "Name of the new object; no other has it. With \"again\": the object")
          .needed(),
      R("size", &P::size, kSize, "Size of the sheet along warp and weft").in({kSheet}).needed(),
      R("path", &P::path, kPoint, "Corners of the line along which the cable starts")
          .in({kCable})
          .needed(),
      R("of", &P::of, kObjectName, "Object with the mesh, in the scene or not")
          .in({kMesh})
          .needed(),
      R("again", &P::again, kFlag,
        "Drape the object again from its first start, its ends at those that hold them")
          .in({kAgain})
          .needed(),
      R("position", &P::start, &Pose::translation, kPoint,
        "Position of the sheet's middle, or the mesh's origin, at the start")
          .in({kSheet, kMesh})
          .needed(),
      R("rotation", &P::start, &Pose::rotation, kRotation,
        "Rotation at the start, quaternion, of a level sheet")
          .in({kSheet, kMesh}),
      R("cell", &P::cell, kCell,
        "Largest side of a cell of the sheet, or segment of the cable; default: a 40th of the "
        "sheet's length, a 128th of the cable's")
          .in({kSheet, kCable}),
      R("material", &P::material, kText,
        "Material: cotton (default), felt, paper, towel or wool of a sheet; lead of a cable")
          .in(kNew),
      R("thickness", &P::thickness, kThickness,
        "Thickness of the sheet, or diameter of the cable; default: the material's")
          .in(kNew),
      R("density", &P::density, kFlexDensity,
        "Mass per area, or per length of a cable; default: the material's")
          .in(kNew),
      R("bending", &P::bending, kBending, "Bending stiffness; default: the material's").in(kNew),
      R("friction", &P::friction, kFlexFriction,
        "Coulomb friction coefficient, also against itself; default: the material's")
          .in(kNew),
      R("pins", &P::pins, kPoint, "Points whose nearest vertices stay where they start").in(kNew),
      R("held_by", &P::held_by, kObjectName,
        "Objects that hold the pins, one for each: when they move, it is draped again")
          .in(kNew),
      R("net_force", &P::net_force, kNetForce,
        "Largest net force that may be left at a vertex at rest"),
      R("steps", &P::steps, kSteps,
        "Largest number of steps of the solver, on each level from coarse to fine")};
}

}  // namespace

template <>
const OperationTable& table<DrapeOperation>() {
  using P = DrapeOperation;
  static const OperationTable rows = make_table<P>(
      {{"drape",
        "Drape a flat sheet, a new object, over what lies below",
        {"size"},
        {},
        [](const P& o) { return o.size.has_value(); },
        [](P& o) { o.size = Vec2(1, 1); }},
       {"drape",
        "Drape a cable, a new object, over what lies below",
        {"path"},
        {},
        [](const P& o) { return !o.path.empty(); },
        [](P& o) {
          o.path = {Vec3::Zero(), Vec3::UnitX()};
        }},
       {"drape",
        "Drape an object again that was draped before",
        {"again"},
        {},
        [](const P& o) { return o.again; },
        [](P& o) { o.again = true; }},
       {"drape",
        "Drape a sheet (by its size), a cable (by its path) or an open mesh, a new object, over "
        "what lies below",
        {"of"},
        {},
        [](const P& o) { return o.of.has_value(); },
        [](P& o) { o.of = ""; }}},
      drape_rows(), refuse_drape,
      TRIVET_SENTENCE("a shape is missing; accepted: \"size\" of a sheet, \"path\" of a cable, "
                      "\"of\" for a mesh, or \"again\""));
  return rows;
}

OperationResult apply(Transaction& transaction, const DrapeOperation& o, OperationRun& run) {
  const Scene& scene = transaction.scene();
  if (o.again) {
    const auto draped = scene.find(o.object);
    return draped ? drape_again(transaction, *draped, o, run)
                  : refused(unknown_object(scene, o.object));
  }
  if (auto why = refuse_name(scene, o.object)) return refused(std::move(*why));
  if (auto why = refuse_holders(scene, o)) return refused(std::move(*why));
  auto made = drape_problem(scene, o);
  if (auto* const why = std::get_if<Refusal>(&made)) return refused(std::move(*why));
  return bring_down(transaction, o, std::get<flex::DrapeProblem>(made), nullptr, run);
}

OperationResult drape_again(Transaction& transaction, ObjectId draped, const DrapeOperation& limits,
                            OperationRun& run) {
  auto made = problem_again(transaction.scene(), draped);
  if (auto* const why = std::get_if<Refusal>(&made)) return refused(std::move(*why));
  auto& [o, problem] = std::get<DrapedAgain>(made);
  o.net_force = limits.net_force, o.steps = limits.steps;
  const Object before = transaction.scene().at(draped);
  DeleteOperation away;
  away.object = before.name;
  OperationResult gone = apply(transaction, away, run);
  if (!gone.ok()) return gone;
  OperationResult result = bring_down(transaction, o, problem, &before, run);
  for (const std::string& name : gone.unsupported) add_name(result.unsupported, name);
  return result;
}

}  // namespace trivet
