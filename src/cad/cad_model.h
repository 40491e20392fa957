// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

/// \file
/// What OpenCASCADE reads from a STEP or IGES file.

namespace endmill::cad {

/// The kind of a file, which its name tells.
enum class FileKind { Step, Iges };

/// The file cannot be read as what it should be; `what()` is one line for a person.
class BadFile : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A limit was reached; `what()` is one line for a person.
class Limit : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A face of the model where it stands in the assembly.
struct ModelFace {
    TopoDS_Face face;
    std::string name;    ///< as the file gives it, in UTF-8; empty without one
    std::string colour;  ///< "#rrggbb" in sRGB; empty if the file gives none
};

/// All that a file contains, in mm.
struct Model {
    TopoDS_Shape shape;
    std::vector<ModelFace> faces;  ///< in the order of the shape
    std::string
        unit;      ///< name of the unit of length in the file; empty: the file names none
    bool is_sewn;  ///< whether the file had separate faces that were sewn
    std::size_t lost_faces;  ///< faces in the file that OpenCASCADE does not build
};

/// Reads a file. Separate faces are sewn where their borders agree. The first fault that
/// OpenCASCADE sees in the file goes to the standard error before the file is translated,
/// because the translation may crash.
/// \param path that OpenCASCADE opens for reading.
/// \param most_faces largest number of faces.
/// \throws BadFile if OpenCASCADE does not read it, or if it has no faces.
/// \throws Limit if there are more faces.
Model read_model(const char* path, FileKind kind, std::size_t most_faces);

}  // namespace endmill::cad
