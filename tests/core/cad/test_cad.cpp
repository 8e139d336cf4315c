// STEP, IGES and BREP files, made here by Open CASCADE: closed meshes within the tolerance of the
// exact surfaces, with names and colours.
#include <gtest/gtest.h>

#ifdef TRIVET_TEST_OCCT
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <fstream>
#include <functional>

#include "core/base/error.h"
#include "core/index/shape.h"
#include "core/io/cad/cad_model.h"
#include "support/cad_shapes.h"
#include "support/random_shapes.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using namespace trivet::test;

class Cad : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return m_folder.file(name); }
  std::string written(const TopoDS_Shape& shape, const std::string& name) const {
    EXPECT_TRUE(write_cad(shape, file(name)));
    return file(name);
  }

 private:
  TemporaryFolder m_folder;
};

double exact_volume(const TopoDS_Shape& shape) {  // cubic metres
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-6);
  return 1e-9 * properties.Mass();
}

double size_of(const TopoDS_Shape& shape) {  // metres
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return 1e-3 * std::sqrt(box.SquareExtent());
}

/// The nearest point of a triangle: its inside, else one on an edge.
double distance(const Vec3& p, const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  bool inside = true;
  double least = kInfinity;
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = t[k], d = t[(k + 1) % 3] - a;
    const double u = std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (a + u * d - p).norm());
    inside &= n.dot(d.cross(p - a)) >= 0;
  }
  return inside ? std::abs(n.dot(p - t[0])) / n.norm() : least;
}

double distance(const Vec3& p, const Mesh& mesh) {
  double least = kInfinity;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
    least = std::min(least, distance(p, mesh.triangle(f)));
  return least;
}

/// How far a point (millimetres) is from the surface, in closed form or by Open CASCADE's search.
using SurfaceDistance = std::function<double(const Vec3&)>;

double from_ball(const Vec3& p) { return std::abs(p.norm() - kBallRadius); }
double from_ring(const Vec3& p) {
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - kRingRadius, p.z()) - kTubeRadius);
}
SurfaceDistance from_shell(const TopoDS_Shape& shape) {
  const TopoDS_Shape shell = TopExp_Explorer(shape, TopAbs_SHELL).Current();  // not its inside
  return [shell](const Vec3& p) {
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Vertex();
    return BRepExtrema_DistShapeShape(vertex, shell).Value();
  };
}

/// The largest distance from points of the facets to the surface: centres of the largest facets,
/// and random points; metres.
double facets_to_surface(const Mesh& mesh, const SurfaceDistance& distance_of, int count,
                         Random& random) {
  const int num_faces = static_cast<int>(mesh.triangles.size());
  double largest = 0;
  for (int i = 0; i < count; ++i) {
    const Triangle t = mesh.triangle(random.integer(0, num_faces - 1));
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    if (i % 2 == 0) u = v = 1.0 / 3;
    largest =
        std::max(largest, 1e-3 * distance_of(1e3 * (t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]))));
  }
  return largest;
}

/// The largest distance from random points of the surface to the mesh; metres.
double surface_to_facets(const TopoDS_Shape& shape, const Mesh& mesh, int count, Random& random) {
  double largest = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    const BRepAdaptor_Surface surface(face);
    const BRepTopAdaptor_FClass2d inside(face, 1e-7);
    for (int i = 0; i < count; ++i) {
      const gp_Pnt2d uv(random.uniform(surface.FirstUParameter(), surface.LastUParameter()),
                        random.uniform(surface.FirstVParameter(), surface.LastVParameter()));
      if (inside.Perform(uv) != TopAbs_IN) continue;
      const gp_Pnt p = surface.Value(uv.X(), uv.Y());
      largest = std::max(largest, distance(1e-3 * Vec3(p.X(), p.Y(), p.Z()), mesh));
    }
  }
  return largest;
}

/// Every edge is used as often in either direction. Coarse meshes may use one more than once.
bool is_closed(const Mesh& mesh) {
  const Adjacency adjacency = make_adjacency(mesh);
  return std::all_of(adjacency.components.begin(), adjacency.components.end(),
                     [](const Component& c) { return c.balanced && c.even; });
}

struct Solid {
  const char* name;
  TopoDS_Shape shape;
  double chord;  // metres: what gives a volume within 0.1 %; thin things need less
  SurfaceDistance from_surface;
  int num_faces;
};

TEST_F(Cad, StepIsClosedWithinTheToleranceAndOfTheRightVolume) {
  Random random(3);
  const TopoDS_Shape spoon = lofted_spoon(), jar = bottle();
  const Solid solids[] = {{"ball", ball(), 4e-5, from_ball, 1},
                          {"ring", ring(), 1.2e-5, from_ring, 1},
                          {"spoon", spoon, 8e-6, from_shell(spoon), 3},
                          {"bottle", jar, 4e-5, from_shell(jar), 5}};
  for (const Solid& solid : solids) {
    SCOPED_TRACE(solid.name);
    const Model model = read_cad_model(written(solid.shape, "made.step"), {}, {solid.chord, 20});
    ASSERT_TRUE(model.polygonised);
    const Polygonisation& done = *model.polygonised;
    EXPECT_EQ(done.num_failed_faces, 0);
    EXPECT_EQ(done.num_faces, solid.num_faces);
    EXPECT_EQ(done.chord, solid.chord);
    EXPECT_LE(done.deviation, solid.chord);
    EXPECT_TRUE(is_closed(model.mesh));
    const auto made = make_shape(model.mesh);
    EXPECT_EQ(made->mass.rule, MassRule::Volume);
    const double volume = exact_volume(solid.shape);
    EXPECT_NEAR(made->mass.volume, volume, 1e-3 * volume);
    const double outwards = facets_to_surface(model.mesh, solid.from_surface, 60, random);
    const double inwards = surface_to_facets(solid.shape, model.mesh, 40, random);
    // Beside the chord: float32.
    EXPECT_LE(std::max(inwards, outwards), solid.chord + 1e-8);
    EXPECT_GT(inwards, 0.05 * solid.chord);  // no finer than needed
    std::printf("%-7s chord %.3g m, found %.3g and %.3g m (Trivet: %.3g), volume %+.4f %%, %zu\n",
                solid.name, solid.chord, inwards, outwards, done.deviation,
                100 * (made->mass.volume / volume - 1), model.mesh.triangles.size());
  }
}

TEST_F(Cad, CoarseTolerancesStayClosedAndWithin) {
  for (const TopoDS_Shape& shape : {ball(), ring(), lofted_spoon(), bottle()}) {
    const std::string step = written(shape, "made.step");
    for (const double relative : {3e-2, 5e-3}) {
      const Model model = read_cad_model(step, {}, {relative * size_of(shape), 60});
      EXPECT_TRUE(is_closed(model.mesh));
      EXPECT_LE(model.polygonised->deviation, model.polygonised->chord);
    }
  }
}

TEST_F(Cad, DefaultsAreAThousandthOfTheSize) {
  const Model model = read_cad_model(written(ball(), "made.step"));
  const double size = model.mesh.box().diagonal();
  EXPECT_NEAR(model.polygonised->chord, 1e-3 * size, 1e-5 * size);
  EXPECT_EQ(model.tessellation, Tessellation());
  EXPECT_EQ(model.metres_per_unit, 1);
}

TEST_F(Cad, IgesAndBrepAreClosedToo) {
  const TopoDS_Shape shape = bottle();
  const double volume = exact_volume(shape);
  Random random(7);
  for (const char* const name : {"made.igs", "made.brep"}) {
    SCOPED_TRACE(name);
    const Model model = read_cad_model(written(shape, name), {}, {4e-5, 20});
    EXPECT_TRUE(is_closed(model.mesh));
    const auto made = make_shape(model.mesh);
    EXPECT_NEAR(made->mass.volume, volume, 3e-3 * volume);
    EXPECT_LE(surface_to_facets(shape, model.mesh, 50, random), 4e-5 + 1e-8);
  }
}

TEST_F(Cad, NamesAndColoursOfAnAssembly) {
  Handle(TDocStd_Document) document;
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document);
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const auto colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto add = [&](const TopoDS_Shape& shape, const char* name, double r, double g, double b) {
    const TDF_Label label = shapes->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    colours->SetColor(label, Quantity_Color(r, g, b, Quantity_TOC_RGB), XCAFDoc_ColorSurf);
    return label;
  };
  const TDF_Label red = add(ball(), "red ball", 0.5, 0, 0);
  const TDF_Label blue = add(ring(), "blue ring", 0, 0, 0.25);
  const TDF_Label all = shapes->NewShape();
  gp_Trsf beside;
  beside.SetTranslation(gp_Vec(100, 0, 0));
  shapes->AddComponent(all, red, TopLoc_Location());
  shapes->AddComponent(all, red, TopLoc_Location(beside));
  shapes->AddComponent(all, blue, TopLoc_Location(beside));
  shapes->UpdateAssemblies();
  STEPCAFControl_Writer writer;
  ASSERT_TRUE(writer.Transfer(document));
  ASSERT_EQ(writer.Write(file("assembly.stp").c_str()), IFSelect_RetDone);
  XCAFApp_Application::GetApplication()->Close(document);

  const Model model = read_cad_model(file("assembly.stp"));
  EXPECT_EQ(model.num_nodes, 3);
  EXPECT_EQ(model.polygonised->num_faces, 3);
  ASSERT_EQ(model.materials.size(), 2u);
  EXPECT_EQ(model.materials[0].name, "red ball");
  EXPECT_EQ(model.materials[1].name, "blue ring");
  EXPECT_NEAR(model.materials[0].base_colour[0], 0.5, 0.01);
  EXPECT_NEAR(model.materials[1].base_colour[2], 0.25, 0.01);
  EXPECT_EQ(make_adjacency(model.mesh).components.size(), 3u);
  EXPECT_NEAR(model.mesh.box().upper.x(), 0.14, 1e-4);  // metres
  EXPECT_EQ(model.corner_normals.size(), model.mesh.triangles.size());
}

TEST_F(Cad, NormalsAreThoseOfTheSurface) {
  const Model model = read_cad_model(written(ball(), "made.step"));
  for (size_t f = 0; f < model.mesh.triangles.size(); ++f) {
    const Triangle t = model.mesh.triangle(static_cast<Index>(f));
    for (int k = 0; k < 3; ++k)
      ASSERT_GT(model.corner_normals[f][k].cast<double>().dot(t[k].normalized()), 0.99) << f;
  }
}

TEST_F(Cad, WhatCannotBeReadIsNamed) {
  const auto message = [&](const std::string& name, const std::string& content) {
    std::ofstream(file(name)) << content;
    try {
      read_cad_model(file(name));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  for (const char* const name : {"a.step", "b.iges", "c.brep"}) {
    EXPECT_NE(message(name, "nothing of the kind\n").find(name), std::string::npos);
    EXPECT_NE(message(name, "").find(name), std::string::npos);
  }
  const std::string whole = written(lofted_spoon(), "made.step");
  std::ifstream stream(whole);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  EXPECT_NE(message("half.step", text.substr(0, text.size() / 2)).find("half.step"),
            std::string::npos);
  ImportLimits limits;
  limits.max_triangles = 100;
  EXPECT_THROW(read_cad_model(whole, limits), Error);
  EXPECT_THROW(read_cad_model(whole, {}, {1e-9, 20}), Error);
}

}  // namespace
}  // namespace trivet

#else

TEST(Cad, IsNotPartOfThisBuild) {
  GTEST_SKIP() << "this build has no Open CASCADE (Debian: libocct-data-exchange-dev)";
}

#endif
