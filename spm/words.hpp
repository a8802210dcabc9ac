// Events, faults and reasons not to drive in words, for the console and for people at the simulator. The words stand
// beside the names in events_list.inc, fault_list.inc and inhibit_list.inc, so neither can be without the other.
//
// All texts lie in flash: on the AVR each character is read with base::flash_byte(). They cost no RAM.
#pragma once

#include <stdint.h>

#include "spm/fault_rules.hpp"
#include "spm/inhibit.hpp"

namespace spm {

// Of a code as the log has it; null for one that this version does not know.
const char* words_of_event(uint8_t code);
// What its argument means, see events_list.inc; null for a code that this version does not know.
const char* words_of_argument(uint8_t code);

const char* words_of(Fault fault);
const char* words_of(Inhibit inhibit);

}  // namespace spm
