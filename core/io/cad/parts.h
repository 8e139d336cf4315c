// Private. Contents of a CAD file: placed parts with names and colours.
#pragma once

#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <string>
#include <vector>

#include "core/io/cad/model.h"

namespace trivet {

/// A part of an assembly, in one placement.
struct CadPart {
  std::string name;
  TopoDS_Shape shape;  // shared by all places of the part
  gp_Trsf place;       // millimetres
  Index material = 0;  // of faces without a colour of their own
  TopTools_DataMapOfShapeInteger face_materials;
};

struct CadParts {
  std::vector<CadPart> parts;
  std::vector<Material> materials;
  std::string format;  // "step", "iges", "brep"
};

/// @throws Error (BadInput) naming the file; Standard_Failure.
CadParts read_cad_parts(const std::string& path);

/// Polygonises all parts into the model's mesh, face_material, corner_normals and polygonised, to
/// model.tessellation.
/// @throws Error (BadInput) naming the file; Standard_Failure.
void polygonise(const CadParts& parts, const ImportLimits& limits, Model& model);

}  // namespace trivet
