// SPDX-License-Identifier: MIT

#include "internode/io/mesh/mesh_file.h"

#include "internode/io/mesh/mesh_readers.h"

namespace internode {

std::string_view name_of(MeshFileFormat format) {
    switch (format) {
    case MeshFileFormat::Obj:
        return "OBJ";
    case MeshFileFormat::Off:
        return "OFF";
    case MeshFileFormat::Ply:
        return "PLY";
    case MeshFileFormat::Stl:
        break;
    }
    return "STL";
}

MeshFileFormat mesh_format(std::string_view bytes) {
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r\n")) return MeshFileFormat::Ply;
    if (is_binary_stl(bytes) || bytes.starts_with("solid")) return MeshFileFormat::Stl;
    return is_off(bytes) ? MeshFileFormat::Off : MeshFileFormat::Obj;
}

namespace {

ParsedMesh read(std::string_view bytes, std::string_view source, MeshFileFormat format) {
    switch (format) {
    case MeshFileFormat::Obj:
        return read_obj_mesh(bytes, source);
    case MeshFileFormat::Off:
        return read_off_mesh(bytes, source);
    case MeshFileFormat::Ply:
        return read_ply_mesh(bytes, source);
    case MeshFileFormat::Stl:
        break;
    }
    return read_stl_mesh(bytes, source);
}

} // namespace

ParsedMesh read_mesh(std::string_view bytes, std::string_view source) {
    const MeshFileFormat format = mesh_format(bytes);
    ParsedMesh parsed = read(bytes, source, format);
    if (parsed.file) {
        parsed.file->source = source;
        parsed.file->format = format;
    }
    return parsed;
}

} // namespace internode
