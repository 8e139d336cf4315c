#include "core/io/cad/parts.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "core/base/bad_input.h"
#include "core/base/quoted.h"
#include "core/io/cad_format.h"

namespace trivet {
namespace {

constexpr size_t kMaxNameLength = 100;

using Colour = std::array<float, 4>;

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  std::string out(static_cast<size_t>(name->Get().LengthOfCString()), '\0');
  Standard_PCharacter text = out.data();
  name->Get().ToUTF8CString(text);
  return out;
}

/// A document, closed on destruction.
class Document {
 public:
  Document() { application()->NewDocument("MDTV-XCAF", m_document); }
  ~Document() { application()->Close(m_document); }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  Handle(TDocStd_Document) & get() { return m_document; }

 private:
  static Handle(XCAFApp_Application) application() { return XCAFApp_Application::GetApplication(); }
  Handle(TDocStd_Document) m_document;
};

/// Walks an assembly down to its parts.
class Walk {
 public:
  Walk(Document& document, CadParts& out)
      : m_shapes(XCAFDoc_DocumentTool::ShapeTool(document.get()->Main())),
        m_colours(XCAFDoc_DocumentTool::ColorTool(document.get()->Main())),
        m_out(out) {}

  void all() {
    TDF_LabelSequence free;
    m_shapes->GetFreeShapes(free);
    for (const TDF_Label& label : free) visit(label, {}, name_of(label), {});
  }

 private:
  std::optional<Colour> colour_of(const TDF_Label& label) const {
    Quantity_ColorRGBA colour;
    for (const auto type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (m_colours->GetColor(label, type, colour)) return linear(colour);
    return std::nullopt;
  }
  std::optional<Colour> colour_of(const TopoDS_Shape& shape) const {
    Quantity_ColorRGBA colour;
    for (const auto type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen})
      if (m_colours->GetColor(shape, type, colour)) return linear(colour);
    return std::nullopt;
  }
  static Colour linear(const Quantity_ColorRGBA& c) {
    const Quantity_Color& rgb = c.GetRGB();
    return {static_cast<float>(rgb.Red()), static_cast<float>(rgb.Green()),
            static_cast<float>(rgb.Blue()), c.Alpha()};
  }

  void visit(const TDF_Label& label, const gp_Trsf& place, const std::string& name,
             std::optional<Colour> colour) {
    if (const auto own = colour_of(label); own && !colour) colour = own;
    if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      for (const TDF_Label& component : components) {
        TDF_Label part;
        if (!XCAFDoc_ShapeTool::GetReferredShape(component, part)) continue;
        const gp_Trsf below = place * XCAFDoc_ShapeTool::GetLocation(component).Transformation();
        const std::string own = name_of(part);
        visit(part, below, own.empty() ? name_of(component) : own,
              colour ? colour : colour_of(component));
      }
      return;
    }
    TopoDS_Shape shape;
    if (!XCAFDoc_ShapeTool::GetShape(label, shape) || shape.IsNull()) return;
    CadPart part;
    part.name = name;
    part.shape = shape;
    part.place = place;
    part.material = material(name, colour);
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
      if (const auto own = colour_of(face.Current()))
        part.face_materials.Bind(face.Current(), material(name, own));
    m_out.parts.push_back(std::move(part));
  }

  Index material(const std::string& part, const std::optional<Colour>& colour) {
    Material wanted;
    wanted.name = part.empty() ? "part" : part;
    if (colour) wanted.base_colour = *colour;
    for (size_t i = 0; i < m_out.materials.size(); ++i)
      if (m_out.materials[i].name == wanted.name &&
          m_out.materials[i].base_colour == wanted.base_colour)
        return static_cast<Index>(i);
    m_out.materials.push_back(wanted);
    return static_cast<Index>(m_out.materials.size() - 1);
  }

  Handle(XCAFDoc_ShapeTool) m_shapes;
  Handle(XCAFDoc_ColorTool) m_colours;
  CadParts& m_out;
};

// Open CASCADE would open the files that a STEP file names, wherever they are.
void refuse_other_files(const std::string& path, const STEPCAFControl_Reader& reader) {
  STEPConstruct_ExternRefs references(reader.Reader().WS());
  references.LoadExternRefs();
  for (Standard_Integer i = 1; i <= references.NbExternRefs(); ++i) {
    const Standard_CString name = references.FileName(i);
    if (!name || !*name) continue;
    bad_file(path,
             "names another file, %1, which is not opened; accepted: one STEP file with all parts",
             quoted(std::string(name).substr(0, kMaxNameLength)));
  }
}
void refuse_other_files(const std::string&, const IGESCAFControl_Reader&) {}

template <class Reader>
void transfer(const std::string& path, const char* format, CadParts& out) {
  Document document;
  Reader reader;
  reader.SetNameMode(true);
  reader.SetColorMode(true);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    bad_file(path, "cannot be read as %1", format);
  refuse_other_files(path, reader);
  reader.Transfer(document.get());  // broken parts are left out
  Walk(document, out).all();
}

}  // namespace

CadParts read_cad_parts(const std::string& path) {
  CadParts out;
  const std::string format = cad_format(path);
  if (format == "STEP") {
    out.format = "step";
    transfer<STEPCAFControl_Reader>(path, "STEP", out);
  } else if (format == "IGES") {
    out.format = "iges";
    transfer<IGESCAFControl_Reader>(path, "IGES", out);
  } else {
    out.format = "brep";
    CadPart part;
    part.name = std::filesystem::path(path).stem().string();
    if (!BRepTools::Read(part.shape, path.c_str(), BRep_Builder()))
      bad_file(path, "cannot be read as BREP");
    out.materials.push_back({});
    out.materials.back().name = part.name;
    out.parts.push_back(std::move(part));
  }
  return out;
}

}  // namespace trivet
