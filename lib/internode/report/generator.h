// SPDX-License-Identifier: MIT
//
// What made a document: it stands in the metadata of every JSON, picture and page. No time, no folder, no output name:
// the same command gives the same bytes wherever and whenever it runs (docs/promises.md, P25).

#pragma once

#include <string>

namespace internode {

struct Generator {
    std::string version; ///< "0.1.0"
    std::string command; ///< "internode masks @fibonacci -d 2": base names of inputs, without -o
};

} // namespace internode
