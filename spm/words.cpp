#include "spm/words.hpp"

#include "drivers/base/flash.hpp"

namespace spm {

// The strings have names of their own, or they would be copied into RAM.

const char* words_of_event(uint8_t code) {
  switch (code) {
#define SPM_EVENT(name, number, words, argument, reason) \
  case number: {                                         \
    static const char text[] IN_FLASH = words;           \
    return text;                                         \
  }
#include "spm/events_list.inc"
#undef SPM_EVENT
    default:
      return nullptr;
  }
}

const char* words_of_argument(uint8_t code) {
  switch (code) {
#define SPM_EVENT(name, number, words, argument, reason) \
  case number: {                                         \
    static const char text[] IN_FLASH = argument;        \
    return text;                                         \
  }
#include "spm/events_list.inc"
#undef SPM_EVENT
    default:
      return nullptr;
  }
}

const char* words_of(Fault fault) {
  switch (fault) {
#define SPM_FAULT(name, words, reason)         \
  case Fault::name: {                          \
    static const char text[] IN_FLASH = words; \
    return text;                               \
  }
#include "spm/fault_list.inc"
#undef SPM_FAULT
  }
  return nullptr;
}

const char* words_of(Inhibit inhibit) {
  switch (inhibit) {
#define SPM_INHIBIT(name, words, reason)       \
  case Inhibit::name: {                        \
    static const char text[] IN_FLASH = words; \
    return text;                               \
  }
#include "spm/inhibit_list.inc"
#undef SPM_INHIBIT
  }
  return nullptr;
}

}  // namespace spm
