#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "simulation/board/avr_image.hpp"
#include "tests/simulation/board/bench.hpp"

namespace simulation {

using Catch::Matchers::Contains;

TEST_CASE("SEI, SLEEP, CLI in a row serves every tick") {
  Bench bench("ticks", {0});
  bench.start().run(1s);
  // A thousand ticks of 1 ms, less the first part of a millisecond for the EEPROM and the set-up.
  CHECK(bench.word("ticks") == 999);
  CHECK(bench.word("loops") >= 999);
  CHECK(bench.word("loops") <= 1001);
  CHECK(bench.byte("signature") == 0x5A);
  const BoardStatistics statistics = bench.board->statistics();
  CHECK(statistics.cycles >= 8'000'000);
  CHECK(statistics.cycles < 8'000'010);
  CHECK(statistics.cycles_asleep > 7'800'000);
  CHECK(statistics.complaints.empty());
}

TEST_CASE("SEI, NOP, CLI in a row serves every tick") {
  Bench bench("ticks", {1});
  bench.start().run(1s);
  CHECK(bench.word("ticks") == 999);
}

TEST_CASE("SLEEP does nothing unless it is enabled") {
  Bench bench("ticks", {2});
  bench.start().run(100ms);
  CHECK(bench.word("ticks") == 99);
  CHECK(bench.word("loops") > 10'000);
  CHECK(bench.board->statistics().cycles_asleep == 0);
}

TEST_CASE("an interrupt is served four cycles after the instruction it interrupts") {
  Bench bench("response");
  bench.start().run(1ms);
  // Matched at the end of count 1000, up to one cycle of the running RJMP, 4 to respond, 3 for the vector's JMP.
  const unsigned seen = bench.word("latency");
  CHECK(seen >= 1008);
  CHECK(seen <= 1009);
}

TEST_CASE("interrupts are counted and timed") {
  Bench bench("ticks", {0});
  bench.start().run(100ms);
  const auto uses = bench.board->interrupt_use();
  REQUIRE(uses.size() == 1);
  CHECK(uses[0].vector == 16);  // TIMER0_COMPA
  CHECK(uses[0].count == 99);
  CHECK(uses[0].longest > 20);
  CHECK(uses[0].longest < 100);
  CHECK(uses[0].cycles <= 99 * uses[0].longest);
}

TEST_CASE("WAKE interrupts on its pin PB2 and ends sleep") {
  Bench bench("wake");
  bench.start().run(10ms);
  CHECK(bench.byte("edges") == 0);
  bench.wake(true).run(10us);
  CHECK(bench.byte("edges") == 1);
  CHECK(bench.byte("seen_first") == 1);  // served before the instruction behind SLEEP
  bench.wake(true).run(1ms).wake(false).run(1ms);
  CHECK(bench.byte("edges") == 2);
}

TEST_CASE("flags wait for their interrupt, and writing one clears just that flag") {
  Bench bench("flags");
  bench.start().run(1ms);
  CHECK(bench.byte("all") == 0x07);
  CHECK(bench.byte("after_write") == 0x05);
  CHECK(bench.byte("after_sbi") == 0x01);
  CHECK(bench.byte("timer_fired") == 1);
  CHECK(bench.byte("timer_asked") == 0);

  bench.wake(true).run(1ms).wake(false).run(1ms).wake(true).run(1ms);
  CHECK(bench.byte("wake_up") == 0x04);
  CHECK(bench.byte("wake_cleared") == 0);
  CHECK(bench.byte("is_done") == 1);
  CHECK(bench.byte("wake_fired") == 1);
}

TEST_CASE("how long interrupts are off is told to the cycle, with the place, handlers apart") {
  const AvrImage image = load_avr_image(Bench::image("locks"));
  const auto run = [](std::uint8_t ways) {
    Bench bench("locks", {ways}, 0, PILOTFISH_TEST_FIRMWARE_DIR, true);
    bench.start().run(10ms);
    const auto off = bench.board->interrupts_off();
    REQUIRE(off.has_value());
    CHECK(off->at_start.cycles > 10);
    CHECK(off->at_start.from == 0);
    return *off;
  };

  InterruptsOff off = run(0);
  CHECK(off.by_program.cycles == 0);
  CHECK(off.with_handlers.cycles == 0);

  off = run(1);  // CLI to SEI
  CHECK(off.by_program.cycles == 11);
  CHECK(image.place_of(off.by_program.from) == "lock_shortly");
  CHECK(off.with_handlers.cycles == 11);

  off = run(3);  // CLI to a restored SREG, the second instruction of its function
  CHECK(off.by_program.cycles == 31);
  CHECK(image.place_of(off.by_program.from) == "lock_and_restore+0x2");

  off = run(5);  // an interrupt
  CHECK(off.by_program.cycles == 11);
  CHECK(off.with_handlers.cycles == 21);
  CHECK(off.with_handlers.from == 13 * 4);

  off = run(9);  // the CLI of an interrupt that had let others in is no lock of the program
  CHECK(off.by_program.cycles == 11);
  CHECK(off.with_handlers.cycles == 24);
  CHECK(image.place_of(off.with_handlers.from) == "__vector_14+0x3e");
}

TEST_CASE("watching interrupts changes no cycle of the run") {
  const auto run = [](bool watches_locks) {
    Bench bench("uart_burst", {0}, 0, PILOTFISH_TEST_FIRMWARE_DIR, watches_locks);
    bench.start();
    for (int burst = 0; burst < 3; ++burst) {
      bench.wake(true).run(10ms).wake(false).run(3ms);
    }
    CHECK(bench.board->interrupts_off().has_value() == watches_locks);
    return bench.spoken;
  };
  const auto spoken = run(false);
  CHECK(spoken.size() == 30);
  CHECK(spoken == run(true));
}

TEST_CASE("an interrupt's time ends with its RETI") {
  Bench bench("locks", {4});
  bench.start().run(10ms);
  const auto uses = bench.board->interrupt_use();
  REQUIRE(uses.size() == 1);
  CHECK(uses[0].longest == 21);
  CHECK(uses[0].cycles == 21 * uses[0].count);
}

TEST_CASE("an image tells its compiler and its places") {
  const AvrImage image = load_avr_image(Bench::image("locks"));
  CHECK_THAT(image.compiler, Contains("GCC"));
  CHECK(AvrImage{}.place_of(0x2c4) == "0x2c4");
}

TEST_CASE("the stack's deepest reach is found") {
  Bench bench("ticks", {0});
  bench.start().run(10ms);
  const auto reached = bench.board->stack_low_water();
  REQUIRE(reached.has_value());
  CHECK(*reached < 0x40FF);
  CHECK(*reached > 0x40FF - 64);
}

TEST_CASE("a HEX file runs as the ELF does") {
  const auto path = std::filesystem::temp_directory_path() / ("pilotfish_" + std::to_string(getpid()) + ".hex");
  // sbi DDRC, 6; sbi PORTC, 6; rjmp to itself: the power latch goes high.
  std::ofstream(path) << ":060000003E9A469AFFCF74\n:00000001FF\n";
  auto board = make_avr_board({.image = path.string()});
  board->power(true, 0ms);
  board->run_until(1ms);
  CHECK(board->pins().power_latch);
  CHECK(board->name() == "avr");
  std::ofstream(path) << ":060000003E9A469AFFCF75\n:00000001FF\n";
  CHECK_THROWS_WITH(make_avr_board({.image = path.string()}), Contains("damaged"));
  std::filesystem::remove(path);
}

TEST_CASE("a missing or foreign image is refused in words that help") {
  CHECK_THROWS_WITH(make_avr_board({.image = "/nowhere/spm.elf"}),
                    Contains("/nowhere/spm.elf") && Contains("cmake --build build --target firmware"));
  CHECK_THROWS_WITH(make_avr_board({.image = "/bin/sh"}), Contains("/bin/sh") && Contains("AVR"));
  CHECK_THROWS_WITH(make_avr_board({.image = Bench::image("ticks"), .mcu = "z80"}), Contains("z80"));
}

TEST_CASE("a compare that falls into an interrupt's response is not lost") {
  Bench bench("compare");
  bench.start().run(300ms);
  CHECK(bench.word("fired") > 2000);
  CHECK(bench.word("lost") == 0);
}

}  // namespace simulation
