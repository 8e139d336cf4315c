#include "ops/operations/append.h"

#include "core/io/cad_format.h"
#include "core/model/unit.h"
#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr Accepts kScale{Sort::Number, kMinScale, kMaxScale};
constexpr Accepts kUp{Sort::Word, 0, 0, "", {"y", "z"}};
constexpr Accepts kChord{Sort::Number, kMinChord, kMaxChord, "metres", {}, 0};
constexpr Accepts kFacetAngle{Sort::Number, kMinFacetAngleDeg, kMaxFacetAngleDeg, "degrees"};

std::optional<InvalidArgument> refuse_chord(const AppendOperation& o) {
  // Only models with curved surfaces have a tessellation to choose.
  const Tessellation standard;
  if (o.tessellation == standard || !cad_format(o.model).empty()) return std::nullopt;
  const bool chord = o.tessellation.chord != standard.chord;
  return InvalidArgument{chord ? "chord" : "facet_angle_deg", "", "", no_curved_surfaces(o.model)};
}

}  // namespace

template <>
const OperationTable& table<AppendOperation>() {
  using P = AppendOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"append", "Add a new object, out of the scene until it is put"}},
      {R("object", &P::object, kNewName, "Name of the new object; no other has it").needed(),
       R("model", &P::model, kText, "Path of the model file, relative to the layout").needed(),
       R("scale", &P::scale, kScale, "Metres per unit of the file; default: as it states, else 1"),
       R("up", &P::up, kUp, "Up axis of the file; default: as its format states, else z"),
       R("fixed", &P::fixed, kFlag, "Fix the object: it never moves and supports any load"),
       R("material", &P::material, kMaterial, "Name of a preset, or its numbers"),
       R("chord", &P::tessellation, &Tessellation::chord, kChord,
         "For curved surfaces: largest distance of triangles from them, before scale; default: "
         "1/1000 of the model's size"),
       R("facet_angle_deg", &P::tessellation, &Tessellation::facet_angle_deg, kFacetAngle,
         "For curved surfaces: largest angle between neighbouring segments and facets")},
      refuse_chord);
  return rows;
}

OperationResult apply(Transaction& transaction, const AppendOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.object)) return refused(std::move(*why));
  // A model is read before operations run: one that is missing here could not be read.
  if (!o.shape) {
    Refusal why{Refusal::Cause::ModelNotLoaded, {{o.object, std::nullopt}}};
    why.detail = o.model;
    return refused(std::move(why));
  }
  // The object has no pose yet: a PUT or STAND gives it one.
  Object object;
  object.name = o.object;
  object.model = o.model_data;
  object.shape = o.shape;
  object.up = o.up.value_or(object.model ? object.model->up : UpAxis::Z);
  object.scale = metres_per_unit(o.scale, o.model_data.get());
  object.fixed = o.fixed;
  if (o.material) object.material = *o.material;
  transaction.add(std::move(object));
  return done_result();
}

Sentence no_curved_surfaces(const std::string& model) {
  return say(
      "\"%1\" has no curved surfaces; accepted: with models in STEP, IGES or BREP (.step .stp "
      ".iges .igs .brep .brp)",
      model);
}

}  // namespace trivet
