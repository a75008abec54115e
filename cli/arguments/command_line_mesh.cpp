// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

namespace internode::cli {

void CommandReader::add_mesh() {
    CLI::App* mesh = add(
        "mesh", with_examples("What the mesh of a file is: counts, components, boundaries, genus, valences, what is\n"
                              "sharp, and every fault that keeps its faces from being an oriented manifold, with\n"
                              "its line. Exit 1 when there is one.",
                              "mesh data/meshes/tetrahedron.obj", "mesh data/meshes/box.off --json"));
    mesh->add_option("FILE", mesh_.file, "OBJ, OFF, PLY or STL, or -")->required();
    add_output(mesh, mesh_.output);
    mesh->add_flag(
        "--repair", mesh_.repair,
        "Write the mesh instead, made a manifold: faces are turned to agree, degenerate ones dropped, edges\n"
        "and vertices that are not manifold cut apart");
    commands_.push_back({mesh, [this] { return Request(mesh_); }});
}

} // namespace internode::cli
