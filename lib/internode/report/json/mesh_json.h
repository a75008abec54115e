// SPDX-License-Identifier: MIT

#pragma once

#include "internode/io/file/sink.h"
#include "internode/report/generator.h"
#include "internode/report/mesh_report.h"

namespace internode {

/// The document "internode-mesh" (docs/json.md). False if the sink failed.
bool write_mesh_json(Sink& sink, const MeshReport& report, const Generator& generator);

} // namespace internode
