// The event log as a person reads it.
#include "simulation/eeprom/events.hpp"

#include <catch2/catch.hpp>

namespace simulation::eeprom {

TEST_CASE("an event is told in words, and so is its argument") {
  CHECK(tell({0, 1, 0, 0, 1}) == "started, after power on");
  CHECK(tell({0, 1, 1, 0, 1}) == "started, after a watchdog reset");
  CHECK(tell({0, 1, 9, 0, 1}) == "started, argument 9");
  CHECK(tell({0, 8, 12, 0, 1}) == "the loop stood still, 12 ms");
  CHECK(tell({0, 17, 0, 0, 1}) == "the remote fell silent");
  CHECK(tell({0, 17, 3, 0, 1}) == "the remote fell silent, argument 3");
  CHECK(tell({0, 33, 2, 0, 1}) == "self-test failed, RAM at the start");
  CHECK(tell({0, 33, 0, 0, 1}) == "self-test failed, argument 0");
  CHECK(tell({0, 77, 5, 0, 1}) == "event 77, unknown to this version, argument 5");
}

TEST_CASE("the log as a table holds number, start, seconds and words, oldest first") {
  Bytes contents(4096, 0xFF);
  CHECK(make_event_table(contents) == "the event log is empty\n");
  write_record(contents, {256, 17, 0, 12, 2});
  write_record(contents, {255, 1, 0, 0, 2});
  write_record(contents, {257, 23, 0, 65535, 2});
  CHECK(make_event_table(contents) ==
        " number     start  seconds after it   what happened\n"
        "    255         2               0 s   started, after power on\n"
        "    256         2              12 s   the remote fell silent\n"
        "    257         2   65535 s or more   battery flat\n"
        "3 of 256 places used\n");
}

TEST_CASE("which arguments have words") {
  CHECK(has_words(1, 0));
  CHECK(has_words(1, 3));
  CHECK_FALSE(has_words(1, 4));
  CHECK_FALSE(has_words(8, 0));
  CHECK_FALSE(has_words(17, 0));
  CHECK_FALSE(has_words(33, 0));
  CHECK(has_words(33, 1));
}

}  // namespace simulation::eeprom
