// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad/cad_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <unordered_map>

#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESGraph_Color.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_Face.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

// The readers of OpenCASCADE without its documents: a document would load the libraries of
// its viewer. Names and colours belong to entities of the file, and an entity belongs to the
// shape that was made from it, wherever the assembly repeats the shape.

namespace endmill::cad {
namespace {

// Distance in mm at which borders of separate faces are one: that of exchanged files, whose
// numbers often have six digits.
constexpr double sewing_tolerance = 1e-3;

// What a file says of a face, by the address of its geometry, which repeated parts share.
struct Labels {
    std::unordered_map<const void*, std::string> names;
    std::unordered_map<const void*, std::string> colours;
};

const void* address(const TopoDS_Shape& shape)
{
    return shape.TShape().get();
}

std::string colour_text(const Quantity_Color& colour)
{
    std::array<double, 3> parts{};
    colour.Values(parts[0], parts[1], parts[2], Quantity_TOC_sRGB);
    const auto byte = [](double part) {
        constexpr double most = 255;
        return static_cast<unsigned>(std::lround(std::clamp(part, 0.0, 1.0) * most)) &
               255U;
    };
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(parts[0]),
                  byte(parts[1]), byte(parts[2]));
    return text.data();
}

// Colours all faces of a shape; a colour of a face itself is stronger than that of its body.
void add_colour(Labels& labels, const TopoDS_Shape& shape, const std::string& colour)
{
    if (shape.ShapeType() == TopAbs_FACE) {
        labels.colours[address(shape)] = colour;
        return;
    }
    for (TopExp_Explorer face{shape, TopAbs_FACE}; face.More(); face.Next())
        labels.colours.try_emplace(address(face.Current()), colour);
}

// Reports the first fault of a file as a line of the program's messages.
template <typename Reader>
void report_first_fault(const Reader& reader)
{
    Interface_CheckIterator checks = reader.WS()->ModelCheckList();
    for (checks.Start(); checks.More(); checks.Next()) {
        const Handle(Interface_Check)& check = checks.Value();
        if (!check->HasFailed())
            continue;
        Handle(TCollection_HAsciiString) label;
        if (check->HasEntity())
            label = reader.Model()->StringLabel(check->Entity());
        std::fprintf(stderr, "\nendmill-cad: %s%s%s\n",
                     label.IsNull() ? "" : label->ToCString(), label.IsNull() ? "" : ": ",
                     check->CFail(1));
        std::fflush(stderr);
        return;
    }
}

void require_count(std::size_t faces, std::size_t most)
{
    if (faces > most)
        throw Limit{"the file has " + std::to_string(faces) + " faces; the limit is " +
                    std::to_string(most) + " (--max-faces of import)"};
}

template <typename Reader>
void require_read(IFSelect_ReturnStatus status, const Reader& reader, const char* kind)
{
    if (status != IFSelect_RetDone || reader.Model().IsNull() ||
        reader.Model()->NbEntities() == 0)
        throw BadFile{std::string{"content is not "} + kind};
}

std::string utf8(const TCollection_AsciiString& text)
{
    return {text.ToCString(), static_cast<std::size_t>(text.Length())};
}

std::string step_unit(STEPControl_Reader& reader)
{
    TColStd_SequenceOfAsciiString lengths;
    TColStd_SequenceOfAsciiString angles;
    TColStd_SequenceOfAsciiString solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    std::string all;
    for (const TCollection_AsciiString& length : lengths)
        if (utf8(length).find_first_not_of(' ') != std::string::npos)
            all += (all.empty() ? "" : ", ") + utf8(length);
    return all;
}

void add_step_names(Labels& labels, const STEPControl_Reader& reader)
{
    const Handle(Transfer_TransientProcess)& process =
        reader.WS()->TransferReader()->TransientProcess();
    const auto model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto face = Handle(StepShape_Face)::DownCast(model->Value(i));
        if (face.IsNull() || face->Name().IsNull() || face->Name()->IsEmpty())
            continue;
        const TopoDS_Shape shape = STEPConstruct::FindShape(process, face);
        if (!shape.IsNull())
            labels.names[address(shape)] = utf8(face->Name()->String());
    }
}

void add_step_colours(Labels& labels, const STEPControl_Reader& reader)
{
    STEPConstruct_Styles styles{reader.WS()};
    if (!styles.LoadStyles())
        return;
    const Handle(Transfer_TransientProcess)& process =
        reader.WS()->TransferReader()->TransientProcess();
    for (int i = 1; i <= styles.NbStyles(); ++i) {
        const Handle(StepVisual_StyledItem) style = styles.Style(i);
        Handle(StepVisual_Colour) surface;
        Handle(StepVisual_Colour) border;
        Handle(StepVisual_Colour) curve;
        Handle(StepVisual_Colour) rendered;
        double transparency = 0;
        bool is_component = false;
        if (style.IsNull() || style->Item().IsNull() ||
            !styles.GetColors(style, surface, border, curve, rendered, transparency,
                              is_component))
            continue;
        const TopoDS_Shape shape = STEPConstruct::FindShape(process, style->Item());
        Quantity_Color colour;
        const auto& chosen = surface.IsNull() ? rendered : surface;
        if (!shape.IsNull() && !chosen.IsNull() &&
            STEPConstruct_Styles::DecodeColor(chosen, colour))
            add_colour(labels, shape, colour_text(colour));
    }
}

// The number of faces that the file lists, before they are built.
std::size_t listed_step_faces(const Handle(Interface_InterfaceModel) & model)
{
    std::size_t count = 0;
    for (int i = 1; i <= model->NbEntities(); ++i)
        count += model->Value(i)->IsKind(STANDARD_TYPE(StepShape_Face)) ? 1 : 0;
    return count;
}

// The faces that the file lists and that have no shape.
std::size_t lost_step_faces(const STEPControl_Reader& reader)
{
    const Handle(Transfer_TransientProcess)& process =
        reader.WS()->TransferReader()->TransientProcess();
    const auto model = reader.Model();
    std::size_t count = 0;
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto face = Handle(StepShape_Face)::DownCast(model->Value(i));
        if (!face.IsNull() && STEPConstruct::FindShape(process, face).IsNull())
            ++count;
    }
    return count;
}

TopoDS_Shape read_step(const char* path, std::size_t most_faces, Model& model,
                       Labels& labels)
{
    STEPControl_Reader reader;
    require_read(reader.ReadFile(path), reader, "STEP");
    require_count(listed_step_faces(reader.Model()), most_faces);
    report_first_fault(reader);
    model.unit = step_unit(reader);
    reader.TransferRoots();
    add_step_names(labels, reader);
    add_step_colours(labels, reader);
    model.lost_faces = lost_step_faces(reader);
    return reader.OneShape();
}

// The colours with numbers.
const std::array<Quantity_NameOfColor, 9> iges_colours{
    Quantity_NOC_BLACK,    Quantity_NOC_BLACK, Quantity_NOC_RED,
    Quantity_NOC_GREEN,    Quantity_NOC_BLUE1, Quantity_NOC_YELLOW,
    Quantity_NOC_MAGENTA1, Quantity_NOC_CYAN1, Quantity_NOC_WHITE};

std::string iges_colour(const Handle(IGESData_IGESEntity) & entity)
{
    constexpr double whole = 100;  // percent
    const int number = entity->RankColor();
    const auto own = Handle(IGESGraph_Color)::DownCast(entity->Color());
    if (number < 0 && !own.IsNull()) {
        double red = 0;
        double green = 0;
        double blue = 0;
        own->RGBIntensity(red, green, blue);
        const auto part = [&](double value) {
            return std::min(std::max(value / whole, 0.0), 1.0);
        };
        return colour_text({part(red), part(green), part(blue), Quantity_TOC_sRGB});
    }
    if (number >= 1 && number < static_cast<int>(iges_colours.size()))
        return colour_text(Quantity_Color{iges_colours.at(number)});
    return {};
}

void add_iges_labels(Labels& labels, const IGESControl_Reader& reader)
{
    const Handle(Transfer_TransientProcess)& process =
        reader.WS()->TransferReader()->TransientProcess();
    const auto model = reader.Model();
    for (int i = 1; i <= model->NbEntities(); ++i) {
        const auto entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
        if (entity.IsNull())
            continue;
        const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
        if (shape.IsNull())
            continue;
        const std::string colour = iges_colour(entity);
        if (!colour.empty())
            add_colour(labels, shape, colour);
        if (entity->HasName() && shape.ShapeType() == TopAbs_FACE)
            labels.names[address(shape)] = utf8(entity->NameValue()->String());
    }
}

bool is_iges_face(const Handle(IGESData_IGESEntity) & entity)
{
    constexpr std::array types{143, 144, 510};  // bounded, trimmed, of a solid
    return std::ranges::find(types, entity->TypeNumber()) != types.end();
}

TopoDS_Shape read_iges(const char* path, std::size_t most_faces, Model& model,
                       Labels& labels)
{
    IGESControl_Reader reader;
    require_read(reader.ReadFile(path), reader, "IGES");
    const Handle(IGESData_IGESModel) entities = reader.IGESModel();
    std::vector<Handle(IGESData_IGESEntity)> faces;
    for (int i = 1; i <= entities->NbEntities(); ++i)
        if (is_iges_face(entities->Entity(i)))
            faces.push_back(entities->Entity(i));
    require_count(faces.size(), most_faces);
    report_first_fault(reader);
    const Handle(TCollection_HAsciiString) name = entities->GlobalSection().UnitName();
    model.unit = name.IsNull() ? "" : utf8(name->String());
    reader.TransferRoots();
    add_iges_labels(labels, reader);
    const Handle(Transfer_TransientProcess)& process =
        reader.WS()->TransferReader()->TransientProcess();
    model.lost_faces =
        static_cast<std::size_t>(std::ranges::count_if(faces, [&](const auto& face) {
            return TransferBRep::ShapeResult(process, face).IsNull();
        }));
    return reader.OneShape();
}

// Whether a face belongs to no shell.
bool has_separate_faces(const TopoDS_Shape& shape)
{
    return TopExp_Explorer{shape, TopAbs_FACE, TopAbs_SHELL}.More();
}

// A shell as it is, or as the boundary of a solid if it is closed.
TopoDS_Shape solid_if_closed(const TopoDS_Shell& shell)
{
    if (!BRep_Tool::IsClosed(shell))
        return shell;
    BRepBuilderAPI_MakeSolid maker{shell};
    if (!maker.IsDone())
        return shell;
    TopoDS_Solid solid = maker.Solid();
    BRepLib::OrientClosedSolid(solid);
    return solid;
}

// The shape with separate faces sewn into shells, and closed shells made solids. The labels
// follow the faces.
TopoDS_Shape sewn(const TopoDS_Shape& shape, Labels& labels)
{
    BRepBuilderAPI_Sewing sewing{sewing_tolerance};
    sewing.Add(shape);
    sewing.Perform();
    for (TopExp_Explorer face{shape, TopAbs_FACE}; face.More(); face.Next()) {
        const TopoDS_Shape after = sewing.ModifiedSubShape(face.Current());
        if (after.IsNull() || after.IsSame(face.Current()))
            continue;
        for (auto* texts : {&labels.names, &labels.colours})
            if (const auto text = texts->find(address(face.Current()));
                text != texts->end())
                texts->emplace(address(after), std::string{text->second});
    }
    const TopoDS_Shape result = sewing.SewedShape();
    TopoDS_Compound whole;
    BRep_Builder builder;
    builder.MakeCompound(whole);
    for (TopExp_Explorer shell{result, TopAbs_SHELL}; shell.More(); shell.Next())
        builder.Add(whole, solid_if_closed(TopoDS::Shell(shell.Current())));
    for (TopExp_Explorer face{result, TopAbs_FACE, TopAbs_SHELL}; face.More();
         face.Next()) {
        // A sphere or a torus is closed by itself.
        TopoDS_Shell shell;
        builder.MakeShell(shell);
        builder.Add(shell, face.Current());
        builder.Add(whole, solid_if_closed(shell));
    }
    return whole;
}

std::string text_of(const std::unordered_map<const void*, std::string>& texts,
                    const TopoDS_Shape& shape)
{
    const auto found = texts.find(address(shape));
    return found == texts.end() ? std::string{} : found->second;
}

}  // namespace

Model read_model(const char* path, FileKind kind, std::size_t most_faces)
{
    Model model{};
    Labels labels;
    model.shape = kind == FileKind::Step ? read_step(path, most_faces, model, labels)
                                         : read_iges(path, most_faces, model, labels);
    model.is_sewn = !model.shape.IsNull() && has_separate_faces(model.shape);
    if (model.is_sewn)
        model.shape = sewn(model.shape, labels);
    TopTools_IndexedMapOfShape faces;
    if (!model.shape.IsNull())
        TopExp::MapShapes(model.shape, TopAbs_FACE, faces);
    if (faces.IsEmpty())
        throw BadFile{"the file has no surfaces"};
    require_count(static_cast<std::size_t>(faces.Extent()), most_faces);
    for (int i = 1; i <= faces.Extent(); ++i)
        model.faces.push_back({TopoDS::Face(faces(i)), text_of(labels.names, faces(i)),
                               text_of(labels.colours, faces(i))});
    return model;
}

}  // namespace endmill::cad
