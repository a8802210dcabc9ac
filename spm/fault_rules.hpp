// The power module's faults, most severe first (SB-01.9); the list with their words is fault_list.inc.
#pragma once

#include <stdint.h>

#include "faults/manager.hpp"
#include "faults/set.hpp"

namespace spm {

enum class Fault : uint8_t {
#define SPM_FAULT(name, words, reason) name,
#include "spm/fault_list.inc"
#undef SPM_FAULT
};

constexpr uint8_t fault_count = 0
#define SPM_FAULT(name, words, reason) +1
#include "spm/fault_list.inc"
#undef SPM_FAULT
    ;

using FaultBits = uint32_t;
using FaultSet = faults::Set<Fault, FaultBits>;
static_assert(fault_count <= 8 * sizeof(FaultBits), "the set has a bit for each");

extern const faults::Row fault_rows[fault_count];

}  // namespace spm
