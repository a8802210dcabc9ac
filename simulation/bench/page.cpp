#include "simulation/bench/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace simulation::bench {
namespace {

// A real power module, as captures of real chairs show it.
constexpr double real_answer_us = 1800;
constexpr double real_pause_us = 1250;
constexpr double turn_us = 10 * 11 * 26.0;  // the shortest answer, back to back by the chip's own clock

constexpr double cycles_in_a_us = 8;
constexpr double period_us = 20'000;

using Row = std::vector<std::string>;

struct Table {
  std::string title;
  std::string text;  // below the title
  Row head;
  std::vector<Row> rows;
};

std::string show_us(double us) {
  return fmt::format("{:.1f}", us + 0.0);  // no "-0.0"
}

std::string show_cycles_us(std::uint64_t cycles) {
  return show_us(static_cast<double>(cycles) / cycles_in_a_us);
}

std::string show_share(double share) {
  return fmt::format("{:.1f} %", share * 100);
}

template <typename Show>
std::string show_spread(const Spread& spread, Show show) {
  if (spread.count == 0) {
    return "";
  }
  return fmt::format("{} / {} / {}", show(spread.least), show(spread.median), show(spread.most));
}

std::string show_count(double count) {
  return fmt::format("{:.0f}", count);
}

Table bus_table(const Figures& figures) {
  Table table{"The bus", "Least, median and most; microseconds at the pin.", {"what", "idle", "heaviest"}, {}};
  const auto add = [&](const std::string& what, auto read) {
    table.rows.push_back({what, read(figures.idle), read(figures.heavy)});
  };
  const auto spread = [](Spread RunFigures::*member) {
    return [member](const RunFigures& run) { return show_spread(run.*member, show_us); };
  };
  const auto length = [](TurnFigures RunFigures::*member) {
    return [member](const RunFigures& run) { return show_spread((run.*member).length, show_us); };
  };
  const auto bytes = [](TurnFigures RunFigures::*member) {
    return [member](const RunFigures& run) { return show_spread((run.*member).bytes, show_count); };
  };
  add("end of the remote's TF to the answer's first start bit", spread(&RunFigures::answer));
  add("idle time inside the answer, stop bit to start bit", spread(&RunFigures::pause));
  add("answer, first start bit to last stop bit", length(&RunFigures::spm));
  add("answer, bytes", bytes(&RunFigures::spm));
  add("remote's turn", length(&RunFigures::sr));
  add("remote's turn, bytes", bytes(&RunFigures::sr));
  add("attendant control's turn", length(&RunFigures::sacu));
  add("attendant control's turn, bytes", bytes(&RunFigures::sacu));
  add("end of the last turn, from the begin of the cycle", spread(&RunFigures::end_of_talk));
  add("share of 20 ms that turns take", [](const RunFigures& run) { return show_spread(run.utilisation, show_share); });
  add("cycles measured", [](const RunFigures& run) { return std::to_string(run.cycles); });
  add("cycles in which a turn was missing or in another's way",
      [](const RunFigures& run) { return std::to_string(run.broken_cycles); });
  return table;
}

Table example_table(const Figures& figures) {
  Table table{
      "The document's examples of utilisation",
      "The byte counts are those of the document's own packet tables (SB-5.5). It reckons with 50 us between bytes; "
      "here nobody pauses.",
      {"example", "SR + SPM + SACU, bytes", "computed, 50 us between bytes", "computed, back to back", "measured"},
      {}};
  const auto show = [](double us) { return fmt::format("{:.2f} ms, {}", us / 1000, show_share(us / period_us)); };
  for (const Example& example : figures.examples) {
    table.rows.push_back({example.name,
                          fmt::format("{} + {} + {} = {}", example.sr_bytes, example.spm_bytes, example.sacu_bytes,
                                      example.sr_bytes + example.spm_bytes + example.sacu_bytes),
                          show(example.computed_us), show(example.back_to_back_us),
                          example.measured_us ? show(*example.measured_us) : "did not occur"});
  }
  return table;
}

Table chip_table(const Figures& figures) {
  Table table{"The chip", "", {"what", "idle", "heaviest"}, {}};
  const auto add = [&](const std::string& what, auto read) {
    table.rows.push_back({what, read(figures.idle), read(figures.heavy)});
  };
  add("CPU load", [](const RunFigures& run) { return show_share(run.load); });
  add("CPU load of single 20 ms, least, median, most",
      [](const RunFigures& run) { return show_spread(run.load_per_cycle, show_share); });
  const auto span = [](PlacedSpan RunFigures::*member) {
    return [member](const RunFigures& run) {
      const PlacedSpan& span = run.*member;
      return fmt::format("{} us, {} cycles, from {}", show_cycles_us(span.cycles), span.cycles, span.place);
    };
  };
  add("interrupts off outside of handlers, longest", span(&RunFigures::locked));
  add("interrupts off, handlers included, longest", span(&RunFigures::off));
  add("interrupts off at start, before the first is allowed", span(&RunFigures::off_at_start));
  const auto count = [](std::uint64_t Losses::*member) {
    return [member](const RunFigures& run) { return std::to_string(run.losses.*member); };
  };
  add("overruns in the UART", count(&Losses::overruns));
  add("bytes spoiled on the line", count(&Losses::spoiled));
  add("turns of the remote without an answer", count(&Losses::missed));
  add("packets found corrupt by remote or attendant control", count(&Losses::corrupt));
  add("programmer's characters, to and fro", [](const RunFigures& run) { return std::to_string(run.characters); });
  add("of these, not returned in their place", count(&Losses::unreturned));
  add("deepest stack, bytes", [](const RunFigures& run) {
    return run.stack_used ? std::to_string(*run.stack_used) : std::string("not known");
  });
  return table;
}

Table interrupt_table(const Figures& figures) {
  Table table{"Interrupts",
              "From acceptance to the end of RETI, the response included.",
              {"interrupt", "idle: a second", "mean", "longest", "heaviest: a second", "mean", "longest"},
              {}};
  std::map<std::string, std::pair<const InterruptFigures*, const InterruptFigures*>> rows;
  for (const InterruptFigures& row : figures.idle.interrupts) {
    rows[row.name].first = &row;
  }
  for (const InterruptFigures& row : figures.heavy.interrupts) {
    rows[row.name].second = &row;
  }
  for (const auto& [name, pair] : rows) {
    Row row{name};
    for (const InterruptFigures* interrupt : {pair.first, pair.second}) {
      if (interrupt == nullptr) {
        row.insert(row.end(), 3, "");
        continue;
      }
      row.push_back(fmt::format("{:.1f}", interrupt->per_second));
      row.push_back(fmt::format("{:.0f} cycles, {} us", interrupt->mean_cycles,
                                show_us(interrupt->mean_cycles / cycles_in_a_us)));
      row.push_back(
          fmt::format("{} cycles, {} us", interrupt->longest_cycles, show_cycles_us(interrupt->longest_cycles)));
    }
    table.rows.push_back(row);
  }
  return table;
}

Table noise_table(const Figures& figures) {
  Table table{
      "Beside somebody who babbles",
      "Random characters back to back, from a moment on at which the chair drives (H-23): all of the time, half of "
      "the time (a character, and a pause as long), and in every gap between the turns, 7.5 to 19.5 ms after the "
      "begin of the remote's. The stop counts from the end of the last general that came through, or of the one "
      "before the third corrupt packet.",
      {"what"},
      {}};
  for (const NoiseFigures& run : figures.noise) {
    table.head.push_back(run.name);
  }
  const auto add = [&](const std::string& what, auto read) {
    Row row{what};
    for (const NoiseFigures& run : figures.noise) {
      row.push_back(read(run));
    }
    table.rows.push_back(row);
  };
  const auto ms = [](std::optional<double> value) { return value ? fmt::format("{:.1f} ms", *value) : "-"; };
  add("noise", [](const NoiseFigures& run) { return fmt::format("{:.0f} s", run.seconds); });
  add("CPU load", [](const NoiseFigures& run) { return show_share(run.load); });
  add("CPU load of single 20 ms, least, median, most",
      [](const NoiseFigures& run) { return show_spread(run.load_per_cycle, show_share); });
  add("milliseconds that the clock counted", [](const NoiseFigures& run) { return std::to_string(run.ticks); });
  add("interrupts off, handlers included, longest",
      [](const NoiseFigures& run) { return show_cycles_us(run.off) + " us"; });
  add("longest interrupt", [](const NoiseFigures& run) { return show_cycles_us(run.longest_interrupt) + " us"; });
  add("the motors begin to slow", [&](const NoiseFigures& run) { return ms(run.stop_begins_ms); });
  add("from then to both duties zero", [&](const NoiseFigures& run) { return ms(run.stop_lasts_ms); });
  add("turns of the remote that were answered",
      [](const NoiseFigures& run) { return std::to_string(run.answer.count); });
  add("end of TF to the answer's first start bit, us",
      [](const NoiseFigures& run) { return show_spread(run.answer, show_us); });
  add("characters said", [](const NoiseFigures& run) { return std::to_string(run.characters_said); });
  add("overruns in the UART", [](const NoiseFigures& run) { return std::to_string(run.overruns); });
  return table;
}

Table memory_table(const Figures& figures) {
  Table table{"Memory", "", {"what", "bytes"}, {}};
  const ImageFigures& image = figures.image;
  const auto show = [](const std::optional<std::uint64_t>& value) {
    return value ? std::to_string(*value) : std::string("not known");
  };
  table.rows.push_back({"flash", std::to_string(image.flash)});
  table.rows.push_back({"static RAM", show(image.static_ram)});
  const auto deepest = std::max(figures.idle.stack_used, figures.heavy.stack_used);
  table.rows.push_back({"deepest stack seen", show(deepest)});
  table.rows.push_back({"stack bound proven from the machine code", show(image.stack_bound)});
  return table;
}

Table target_table(const std::vector<Target>& targets) {
  Table table{"Targets", "", {"what", "wanted", "seen", ""}, {}};
  for (const Target& target : targets) {
    table.rows.push_back({target.what, target.wanted, target.seen, target.is_met ? "met" : "MISSED"});
  }
  return table;
}

Table comparison_table(const Figures& figures) {
  const double answer = figures.idle.answer.median;
  const double ours = answer + turn_us + figures.idle.pause.most;
  const double real = real_answer_us + real_pause_us + turn_us;
  return {
      "Beside a real power module",
      "A real power module, as captures from real chairs show it, begins its answer 1800 us after the remote's TF and "
      "pauses 1250 us before its own.",
      {"what", "real", "here", "ratio"},
      {{"from TF to the answer's first start bit", show_us(real_answer_us), show_us(answer),
        answer > 0 ? fmt::format("{:.0f} : 1", real_answer_us / answer) : "-"},
       {"idle time inside the answer", show_us(real_pause_us), show_us(figures.idle.pause.most),
        figures.idle.pause.most > 0 ? fmt::format("{:.0f} : 1", real_pause_us / figures.idle.pause.most)
                                    : "no pause to compare"},
       {"from TF to the end of an answer of 10 bytes", show_us(real), show_us(ours),
        fmt::format("{:.1f} : 1", real / ours)}}};
}

std::vector<Table> all_tables(const Figures& figures, const std::vector<Target>& targets) {
  return {bus_table(figures),       comparison_table(figures), example_table(figures), chip_table(figures),
          interrupt_table(figures), noise_table(figures),      memory_table(figures),  target_table(targets)};
}

std::string markdown(const Table& table) {
  std::string text = fmt::format("## {}\n\n", table.title);
  if (!table.text.empty()) {
    text += table.text + "\n\n";
  }
  const auto add = [&text](const Row& row) { text += fmt::format("| {} |\n", fmt::join(row, " | ")); };
  add(table.head);
  add(Row(table.head.size(), "---"));
  for (const Row& row : table.rows) {
    add(row);
  }
  return text + "\n";
}

std::string columns(const Table& table) {
  std::vector<std::size_t> widths(table.head.size(), 0);
  const auto measure = [&](const Row& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  };
  measure(table.head);
  std::for_each(table.rows.begin(), table.rows.end(), measure);
  std::string text = table.title + "\n";
  const auto add = [&](const Row& row) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += fmt::format(" {:<{}} ", row[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add(table.head);
  std::for_each(table.rows.begin(), table.rows.end(), add);
  return text + "\n";
}

constexpr const char* method = R"(# How fast it is

Written by `pilotfish bench --write`; do not edit. `pilotfish bench` prints the same tables, `--json` gives them to a
program; the exit code is 1 if a target is missed.

Measured on the image as it is flashed, `{image}`{compiler}, on a simulated ATmega1284P at
8 MHz, instruction by instruction, in the simulated world of [simulation.md](simulation.md). All times are simulated
time: every run gives the same figures. Each kind of traffic lasted {seconds:.0f} s, after the power-up handshake. What the
simulated chip leaves out is listed in [simulation/board/README.md](../simulation/board/README.md); one thing of it
matters here: on silicon the transmitter starts up to one bit (26 us) later.

- **idle**: the remote's generals and their answers, and the settings once a second. The driver drives for five of every
  ten seconds.
- **heaviest**: everybody's longest turn every 20 ms. The remote: general, 8 characters from the programmer, calibration.
  The power module: general and 8 characters back, once a second the settings as well. The attendant control: general
  and calibration. The driver drives as before.
- **noise**: somebody babbles beside the idle traffic, while the chair drives. In the gaps
  for a third of the time above; where nothing of the remote comes through for 4 s, as the module switches itself off after
  5 s without it.

)";

std::string tell_method(const Figures& figures) {
  const std::string compiler = figures.image.compiler;
  return fmt::format(method, fmt::arg("image", figures.image.name),
                     fmt::arg("compiler", compiler.empty() ? "" : fmt::format(" (compiled by {})", compiler)),
                     fmt::arg("seconds", figures.idle.seconds));
}

}  // namespace

std::string tell_page(const Figures& figures, const std::vector<Target>& targets) {
  std::string page = tell_method(figures);
  for (const Table& table : all_tables(figures, targets)) {
    page += markdown(table);
  }
  page.pop_back();
  for (std::size_t at; (at = page.find(" us")) != std::string::npos;) {
    page.replace(at, 3, " µs");
  }
  return page;
}

std::string tell_tables(const Figures& figures, const std::vector<Target>& targets) {
  std::string text;
  for (const Table& table : all_tables(figures, targets)) {
    text += columns(table);
  }
  return text;
}

}  // namespace simulation::bench
