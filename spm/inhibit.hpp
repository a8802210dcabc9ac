// Every reason not to drive, as one set: what the gate obeys, the bus reports and a person can be told.
// The reasons and their words stand in inhibit_list.inc.
#pragma once

#include <stdint.h>

#include "faults/set.hpp"

namespace spm {

enum class Inhibit : uint8_t {
#define SPM_INHIBIT(name, words, reason) name,
#include "spm/inhibit_list.inc"
#undef SPM_INHIBIT
};

constexpr uint8_t inhibit_count = 0
#define SPM_INHIBIT(name, words, reason) +1
#include "spm/inhibit_list.inc"
#undef SPM_INHIBIT
    ;

using Inhibits = faults::Set<Inhibit>;
static_assert(inhibit_count <= 8 * sizeof(Inhibits::Bits), "the set has a bit for each");

}  // namespace spm
