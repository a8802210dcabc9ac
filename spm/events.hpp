// What the event log can say; numbers, words and reasons stand in events_list.inc.
#pragma once

#include <stdint.h>

namespace spm {

enum class EventCode : uint8_t {
  none = 0,
#define SPM_EVENT(name, number, words, argument, reason) name = number,
#include "spm/events_list.inc"
#undef SPM_EVENT
};

}  // namespace spm
