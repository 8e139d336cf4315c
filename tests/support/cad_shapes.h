// Curved shapes made by Open CASCADE, in millimetres, and their files.
#pragma once

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Elips.hxx>
#include <string>

namespace trivet::test {

inline constexpr double kBallRadius = 40, kRingRadius = 30, kTubeRadius = 10;

inline TopoDS_Shape ball() { return BRepPrimAPI_MakeSphere(kBallRadius).Shape(); }
inline TopoDS_Shape ring() { return BRepPrimAPI_MakeTorus(kRingRadius, kTubeRadius).Shape(); }

/// A loft through ellipses, from a handle to a bowl.
inline TopoDS_Shape lofted_spoon() {
  BRepOffsetAPI_ThruSections loft(true, false);
  const double sections[][4] = {{0, 4, 3, 0},    {40, 3, 2.5, 2}, {90, 3, 2.5, 6},
                                {110, 10, 3, 3}, {135, 17, 3, 0}, {150, 4, 2.5, 2}};
  for (const auto& [x, width, thickness, z] : sections) {
    const gp_Ax2 frame(gp_Pnt(x, 0, z), gp::DX(), gp::DY());
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Elips(frame, width, thickness));
    loft.AddWire(BRepBuilderAPI_MakeWire(edge).Wire());
  }
  return loft.Shape();
}

/// A spline revolved about its axis, with a cylinder for its neck.
inline TopoDS_Shape bottle() {
  TColgp_Array1OfPnt points(1, 5);
  points(1) = gp_Pnt(30, 0, 0), points(2) = gp_Pnt(33, 0, 40), points(3) = gp_Pnt(28, 0, 80);
  points(4) = gp_Pnt(15, 0, 110), points(5) = gp_Pnt(12, 0, 120);
  BRepBuilderAPI_MakeWire wire;
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), points(1)));
  const Handle(Geom_BSplineCurve) side = GeomAPI_PointsToBSpline(points).Curve();
  wire.Add(BRepBuilderAPI_MakeEdge(side));
  wire.Add(BRepBuilderAPI_MakeEdge(points(5), gp_Pnt(0, 0, 120)));
  wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 120), gp_Pnt(0, 0, 0)));
  const TopoDS_Shape body = BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire.Wire()).Face(),
                                                  gp_Ax1(gp::Origin(), gp::DZ()))
                                .Shape();
  const gp_Ax2 top(gp_Pnt(0, 0, 115), gp::DZ());
  return BRepAlgoAPI_Fuse(body, BRepPrimAPI_MakeCylinder(top, 16, 20).Shape()).Shape();
}

/// By extension: .step, .igs (faces that share no edges), .brep.
inline bool write_cad(const TopoDS_Shape& shape, const std::string& path) {
  Message::DefaultMessenger()->ChangePrinters().Clear();  // silences standard output
  if (path.ends_with(".step")) {
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    return writer.Write(path.c_str()) == IFSelect_RetDone;
  }
  if (path.ends_with(".igs")) {
    IGESControl_Writer writer("MM", 0);
    writer.AddShape(shape);
    return writer.Write(path.c_str());
  }
  return BRepTools::Write(shape, path.c_str());
}

}  // namespace trivet::test
