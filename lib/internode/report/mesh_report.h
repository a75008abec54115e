// SPDX-License-Identifier: MIT
//
// What `internode mesh` says of a file.

#pragma once

#include "internode/io/mesh/mesh_file.h"
#include "internode/mesh/mesh_facts.h"
#include "internode/mesh/mesh_fault.h"

#include <optional>
#include <vector>

namespace internode {

struct MeshReport {
    const MeshFile& file;
    MeshCounts counts;
    std::vector<MeshFault> faults;
    std::optional<MeshTopology> topology; ///< none where the faces are no manifold
};

/// Counts, faults, and where the faces are a manifold what kind of surface. O(n log n).
[[nodiscard]] MeshReport mesh_report(const MeshFile& file);

/// The lines of the file that show a fault: those of its faces, or of its vertex; empty where the file has none.
[[nodiscard]] std::vector<std::size_t> lines_of(const MeshFault& fault, const MeshFile& file);

} // namespace internode
