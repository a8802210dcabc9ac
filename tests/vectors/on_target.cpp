// All groups of vectors, one after another, on the AVR; what they came to stays in RAM for the test to read.
#include "tests/vectors/groups.hpp"

using vectors::group_count;
using vectors::Record;

volatile uint32_t digests[group_count];
volatile uint32_t counts[group_count];
volatile int32_t known[group_count][Record::most_known];
volatile uint8_t current;  // the group being run; group_count when all are done

int main() {
  for (uint8_t i = 0; i < group_count; ++i) {
    current = i;
    Record record;
    vectors::groups[i].run(record);
    digests[i] = record.digest();
    counts[i] = record.count();
    for (uint8_t j = 0; j < record.known_count() && j < Record::most_known; ++j) {
      known[i][j] = record.actual(j);
    }
  }
  current = group_count;
  for (;;) {
  }
}
