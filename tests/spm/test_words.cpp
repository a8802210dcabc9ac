// The words for people: none is missing, none is said twice, and they say what the documents say.
#include "spm/words.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "spm/events.hpp"

namespace {

using namespace spm;

TEST_CASE("an event's number is for ever, and so is what its words mean") {
  CHECK(static_cast<int>(EventCode::started) == 1);
  CHECK(static_cast<int>(EventCode::powered_down) == 6);
  CHECK(static_cast<int>(EventCode::corrupt_packets) == 16);
  CHECK(static_cast<int>(EventCode::settings_copy_bad) == 26);
  CHECK(static_cast<int>(EventCode::left_motor) == 30);
  CHECK(static_cast<int>(EventCode::brake) == 32);
  CHECK(static_cast<int>(EventCode::stack_overrun) == 41);
  CHECK(std::string(words_of_event(1)) == "started");
  CHECK(std::string(words_of_argument(1)) ==
        "after power on|after a watchdog reset|after a brown-out|after an external reset");
  CHECK(std::string(words_of_event(17)) == "the remote fell silent");
  CHECK(std::string(words_of_argument(17)).empty());
  CHECK(std::string(words_of_event(25)) == "settings lost, defaults used");
  CHECK(std::string(words_of_event(31)) == "right motor output stuck");
  CHECK(std::string(words_of_argument(8)) == "# ms");
}

TEST_CASE("each event has words of its own, and an unknown code has none") {
  const std::set<int> known{1,  2,  3,  4,  5,  6,  7,  8,  9,  16, 17, 18, 19, 20, 21, 22,
                            23, 24, 25, 26, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41};
  std::set<std::string> said;
  for (int code = 0; code < 256; ++code) {
    const char* words = words_of_event(static_cast<std::uint8_t>(code));
    CAPTURE(code);
    REQUIRE((words != nullptr) == (known.count(code) == 1));
    REQUIRE((words_of_argument(static_cast<std::uint8_t>(code)) != nullptr) == (words != nullptr));
    if (words != nullptr) {
      CHECK(said.insert(words).second);
      CHECK(std::string(words).size() > 3);
    }
  }
}

TEST_CASE("each fault and each reason not to drive has words of its own") {
  std::set<std::string> said;
  for (std::uint8_t i = 0; i < fault_count; ++i) {
    CHECK(said.insert(words_of(static_cast<Fault>(i))).second);
  }
  CHECK(said.size() == 20);
  said.clear();
  for (std::uint8_t i = 0; i < inhibit_count; ++i) {
    CHECK(said.insert(words_of(static_cast<Inhibit>(i))).second);
  }
  CHECK(said.size() == 9);
  CHECK(std::string(words_of(Inhibit::awaiting_neutral)) == "awaiting neutral");
  CHECK(std::string(words_of(Inhibit::remote_inhibit)) == "remote inhibit");
  CHECK(std::string(words_of(Fault::general_missing)) == "remote silent");
  CHECK(std::string(words_of(Fault::brake)) == "park brake coil wrong");
}

}  // namespace
