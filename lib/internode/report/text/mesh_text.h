// SPDX-License-Identifier: MIT

#pragma once

#include "internode/mesh/mesh_repair.h"
#include "internode/report/mesh_report.h"

#include <string>

namespace internode {

/// What a mesh is and what is wrong with it, for a terminal; the first twenty faults, each with its line.
[[nodiscard]] std::string mesh_text(const MeshReport& report);

/// "2 faces turned, 1 edge cut", or "nothing to repair".
[[nodiscard]] std::string repairs_text(const MeshRepairs& repairs);

} // namespace internode
