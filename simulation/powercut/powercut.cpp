#include "simulation/powercut/powercut.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "simulation/eeprom/file.hpp"
#include "simulation/powercut/judge.hpp"
#include "simulation/powercut/module.hpp"
#include "simulation/powercut/wear.hpp"

namespace simulation::powercut {
namespace {

using eeprom::Bytes;

constexpr int all_safe = 0;
constexpr int some_unsafe = 1;
constexpr int unusable = 2;

constexpr std::size_t most_told = 10;
constexpr std::uint32_t bits = 8;
constexpr std::size_t first_value = 4;

// The EEPROM file that the build puts beside the image.
Layout read_layout(const std::string& image) {
  const std::string file = std::filesystem::path(image).replace_extension(".eep").string();
  if (!std::filesystem::exists(file)) {
    throw std::runtime_error("no file at '" + file +
                             "', which the build leaves beside the image; it tells how settings lie");
  }
  const Bytes contents = eeprom::load_file(file);
  const Layout layout{contents[1], contents[2], {}};
  const auto values = eeprom::values_in_force(contents, layout.version, layout.count);
  if (!values || values->size() <= 2 * threshold_place) {
    throw std::runtime_error("cannot read an EEPROM from '" + file + "': it holds no settings that are whole");
  }
  return {layout.version, layout.count, *values};
}

void put(Bytes& contents, std::size_t at, const Bytes& bytes) {
  std::copy(bytes.begin(), bytes.end(), contents.begin() + static_cast<std::ptrdiff_t>(at));
}

// Other settings than the defaults, every one of them, each inside its range.
Bytes all_different(const Layout& layout) {
  Bytes values = layout.defaults;
  for (std::size_t i = 0; i < values.size(); i += 2) {
    const int before = values[i] | values[i + 1] << 8;
    const int value = before == 0 ? 1 : before - 1;
    values[i] = static_cast<std::uint8_t>(value & 0xFF);
    values[i + 1] = static_cast<std::uint8_t>(value >> 8);
  }
  return values;
}

// The defaults but for some.
Bytes some_different(const Layout& layout, std::uint8_t deadband, std::uint8_t sensitivity, std::uint8_t threshold) {
  Bytes values = layout.defaults;
  values[2 * deadband_place] = deadband;
  values[2 * sensitivity_place] = sensitivity;
  values[2 * threshold_place] = threshold;
  return values;
}

Bytes complement_of(Bytes bytes) {
  for (std::uint8_t& byte : bytes) {
    byte = static_cast<std::uint8_t>(~byte);
  }
  return bytes;
}

// A ring of old records: places 0 to 99 of lap 1, all others of lap 0, so the next one replaces that at 100. The start
// that will be written there differs in every byte.
constexpr std::size_t next_place = 100;
void fill_log(Bytes& contents) {
  for (std::size_t place = 0; place < eeprom::places; ++place) {
    const std::size_t lap = place < next_place ? 1 : 0;
    eeprom::write_record(contents, {static_cast<std::uint16_t>(place + eeprom::places * lap), 8, 200, 0x0909, 255});
  }
}

// One line of the table.
struct Tally {
  std::string what;
  std::size_t bytes = 0;  // that are written, each of which is cut
  int cuts = 0;
  int second_cuts = 0;
  int safe = 0;
  int unsafe = 0;
};

class Campaign {
 public:
  explicit Campaign(const Order& order)
      : order_(order), module_(order.image), layout_(read_layout(order.image)), random_(order.seed) {
    stale_ = all_different(layout_);
    old_ = some_different(layout_, 60, 3, 20);
    other_ = some_different(layout_, 41, 7, 51);
    // A bad copy of which every byte must be written, and one that is newer and whole but for a bit.
    Bytes nonsense = complement_of(eeprom::make_copy(other_, layout_.version, 5));
    nonsense[0] = 0;
    Bytes flipped = eeprom::make_copy(complement_of(other_), layout_.version, 6);
    flipped[30] ^= 0x01;
    const Bytes good = eeprom::make_copy(other_, layout_.version, 5);
    repair_second_ = scene("settings: the second copy is bad, and is written from the first", good, nonsense, {other_});
    repair_first_ = scene("settings: the first copy is bad, and is written from the second", flipped, good, {other_});
    repair_second_.may_tell_bad_copy = repair_first_.may_tell_bad_copy = true;
    log_ =
        scene("event log: the start is written over the oldest record", eeprom::make_copy(other_, layout_.version, 5),
              eeprom::make_copy(other_, layout_.version, 4), {other_});
  }

  void run() {
    cut_the_image(repair_second_);
    cut_the_image(repair_first_);
    cut_the_image(log_);
    cut_a_change();
    flip_bits_of_one_copy();
    lose_both_copies();
    start_new_board();
  }

  const std::vector<Tally>& tallies() const { return tallies_; }
  const std::vector<std::string>& failures() const { return failures_; }
  int starts() const { return module_.starts(); }
  double simulated() const { return module_.simulated(); }
  double writes_of_record() const { return writes_of_record_; }

 private:
  Scene scene(const std::string& name, const Bytes& first, const Bytes& second, std::vector<Bytes> allowed) {
    Scene made;
    made.name = name;
    made.eeprom = Bytes(eeprom::size, 0xFF);
    put(made.eeprom, eeprom::copy_at(0), first);
    put(made.eeprom, eeprom::copy_at(1), second);
    fill_log(made.eeprom);
    made.allowed = std::move(allowed);
    made.next_place = next_place;
    return made;
  }

  Tally& open(const std::string& what) {
    tallies_.push_back({});
    tallies_.back().what = what;
    return tallies_.back();
  }

  std::vector<Outcome> outcomes() { return order_.wants_all ? all_outcomes(random_) : some_outcomes(random_); }
  Outcome any_outcome() {
    const auto all = all_outcomes(random_);
    return all[random_.below(static_cast<std::uint32_t>(all.size()))];
  }

  // What the image does with this EEPROM if nobody cuts it.
  std::vector<EepromWrite> watch(const Scene& scene) {
    module_.set_eeprom(scene.eeprom);
    const Answer answer = module_.start();
    const std::vector<EepromWrite> writes = module_.writes();
    const std::string flaw = judge_order(writes);
    if (flaw.empty()) {
      finish(scene, "no cut", answer);
    } else {
      fail(scene, "no cut", flaw);
    }
    return writes;
  }

  // ---- the supply fails while the image writes

  void cut_the_image(const Scene& scene) {
    open(scene.name);
    const std::vector<EepromWrite> writes = watch(scene);
    tallies_.back().bytes = writes.size();
    note_wear(scene, writes);
    Scene with_mark_away = scene;
    with_mark_away.may_tell_bad_copy = false;
    for (std::size_t i = 0; i < writes.size(); ++i) {
      const bool is_unfinished_copy = i > 0 && writes[i].address < eeprom::place_at(0);
      const Scene& expected = is_unfinished_copy ? with_mark_away : scene;
      for (const Outcome& outcome : outcomes()) {
        cut_once(expected, {static_cast<int>(i), outcome}, writes[i]);
      }
      cut_twice_after(expected, static_cast<int>(i), static_cast<int>(writes.size()));
    }
  }

  // A second cut, at every byte or at one: those before the first cut are as they must be and are not written again.
  void cut_twice_after(const Scene& scene, int first, int writes) {
    if (!order_.wants_all) {
      const auto second = static_cast<int>(random_.below(static_cast<std::uint32_t>(writes - first)));
      cut_twice(scene, {first, any_outcome()}, {second, any_outcome()});
      return;
    }
    for (int second = 0; second < writes; ++second) {
      cut_twice(scene, {first, any_outcome()}, {second, any_outcome()});
    }
  }

  void cut_once(const Scene& scene, const Cut& cut, const EepromWrite& write) {
    const std::string what = fmt::format("cut in byte {} (address {}, {:02X} to {:02X}), which becomes {}",
                                         cut.write + 1, write.address, write.before, write.after, cut.outcome.tell());
    module_.set_eeprom(scene.eeprom);
    if (!module_.start_and_cut(cut)) {
      fail(scene, what, "the image does not write the same twice");
      return;
    }
    ++tallies_.back().cuts;
    const std::string flaw = judge_log_after_cut(scene, module_.eeprom());
    if (!flaw.empty()) {
      fail(scene, what, flaw);
      return;
    }
    finish(scene, what, module_.start());
  }

  void cut_twice(const Scene& scene, const Cut& first, const Cut& second) {
    const std::string what =
        fmt::format("cut in byte {} ({}), and after the next start in byte {} ({})", first.write + 1,
                    first.outcome.tell(), second.write + 1, second.outcome.tell());
    module_.set_eeprom(scene.eeprom);
    module_.start_and_cut(first);
    ++tallies_.back().cuts;
    if (module_.start_and_cut(second)) {  // it may have less left to write
      ++tallies_.back().second_cuts;
    }
    finish(scene, what, module_.start());
  }

  // ---- a change of settings, in the order that the document promises; the image reads what is left of it

  void cut_a_change() {
    Scene change = scene("settings: others are stored, by the document; the image reads them",
                         eeprom::make_copy(old_, layout_.version, 255), eeprom::make_copy(stale_, layout_.version, 254),
                         {old_, other_});
    open(change.name);
    const Bytes block = eeprom::make_copy(other_, layout_.version, 0);
    const std::size_t at = eeprom::copy_at(1);
    Bytes reached = change.eeprom;
    std::vector<EepromWrite> writes{{static_cast<std::uint16_t>(at), 0, 0xFF}};
    for (std::size_t i = 1; i < block.size(); ++i) {
      writes.push_back({static_cast<std::uint16_t>(at + i), reached[at + i], block[i]});
    }
    writes.push_back({static_cast<std::uint16_t>(at), 0xFF, 0});
    for (std::size_t i = 0; i < writes.size(); ++i) {
      const EepromWrite& write = writes[i];
      if (write.before == write.after) {
        continue;
      }
      ++tallies_.back().bytes;
      // The copy that is replaced stands until its mark is away.
      change.stale = i == 0 ? std::vector<Bytes>{stale_} : std::vector<Bytes>{};
      for (const Outcome& outcome : outcomes()) {
        Bytes cut = reached;
        cut[write.address] = outcome.left(write);
        const std::string what = fmt::format("cut in byte {} (address {}, {:02X} to {:02X}), which becomes {}", i + 1,
                                             write.address, write.before, write.after, outcome.tell());
        ++tallies_.back().cuts;
        module_.set_eeprom(cut);
        finish(change, what, module_.start());
      }
      reached[write.address] = write.after;
    }
  }

  // ---- bytes that are wrong without a cut

  void flip_bits_of_one_copy() {
    Scene sound = log_;
    sound.may_tell_bad_copy = true;
    open("settings: one bit of one copy has flipped");
    const std::size_t copy_size = first_value + layout_.defaults.size() + 2;
    tallies_.back().bytes = eeprom::copies * (copy_size - 1);
    for (std::size_t copy = 0; copy < eeprom::copies; ++copy) {
      for (std::size_t i = 1; i < copy_size; ++i) {  // a mark may be anything but FF
        const std::uint32_t chosen = random_.below(bits);
        for (std::uint32_t bit = 0; bit < bits; ++bit) {
          if (bit != chosen && !order_.wants_all) {
            continue;
          }
          Bytes contents = sound.eeprom;
          contents[eeprom::copy_at(copy) + i] ^= static_cast<std::uint8_t>(1U << bit);
          module_.set_eeprom(contents);
          finish(sound, fmt::format("bit {} of byte {} of copy {} flipped", bit, i, copy), module_.start());
        }
      }
    }
  }

  void lose_both_copies() {
    Scene lost = log_;
    lost.settings = Scene::Settings::lost;
    lost.name = "settings: both copies are bad, so it limps with defaults";
    open(lost.name);
    const std::size_t copy_size = first_value + layout_.defaults.size() + 2;
    tallies_.back().bytes = copy_size - 1;
    for (std::size_t i = 1; i < copy_size; i += order_.wants_all ? 1 : 9) {
      Scene one = lost;
      const std::size_t other = 1 + random_.below(static_cast<std::uint32_t>(copy_size - 1));
      one.eeprom[eeprom::copy_at(0) + i] ^= static_cast<std::uint8_t>(1U << random_.below(bits));
      one.eeprom[eeprom::copy_at(1) + other] ^= static_cast<std::uint8_t>(1U << random_.below(bits));
      module_.set_eeprom(one.eeprom);
      finish(one, fmt::format("byte {} of the first copy and byte {} of the second are wrong", i, other),
             module_.start());
    }
  }

  void start_new_board() {
    Scene erased;
    erased.name = "new board: everything is erased";
    erased.eeprom = Bytes(eeprom::size, 0xFF);
    erased.settings = Scene::Settings::missing;
    cut_the_image(erased);
  }

  // ---- the verdict of a case

  void finish(const Scene& scene, const std::string& what, const Answer& answer) {
    const Bytes after = module_.eeprom();
    std::string flaw = module_.take_mischief();
    if (flaw.empty()) {
      flaw = judge_settings(scene, layout_, after, answer);
    }
    if (flaw.empty()) {
      flaw = judge_log(scene, after);
    }
    if (flaw.empty()) {
      ++tallies_.back().safe;
    } else {
      fail(scene, what, flaw);
    }
  }

  void fail(const Scene& scene, const std::string& what, const std::string& flaw) {
    ++tallies_.back().unsafe;
    failures_.push_back(fmt::format("{}\n    {}:\n    {}", scene.name, what, flaw));
  }

  void note_wear(const Scene& scene, const std::vector<EepromWrite>& writes) {
    std::map<std::uint16_t, int> counts;
    for (const EepromWrite& write : writes) {
      if (write.address >= eeprom::place_at(scene.next_place)) {
        writes_of_record_ = std::max<double>(writes_of_record_, ++counts[write.address]);
      }
    }
  }

  const Order& order_;
  Module module_;
  Layout layout_;
  Random random_;
  Bytes stale_;
  Bytes old_;
  Bytes other_;
  Scene repair_second_;
  Scene repair_first_;
  Scene log_;
  std::vector<Tally> tallies_;
  std::vector<std::string> failures_;
  double writes_of_record_ = 0;
};

std::string tell_row(const Tally& tally) {
  return fmt::format("{:<66} {:>6} {:>6} {:>7} {:>7} {:>9}\n", tally.what, tally.bytes, tally.cuts, tally.second_cuts,
                     tally.safe, tally.unsafe);
}

void tell(const Order& order, const Campaign& campaign, std::ostream& out) {
  using report::Tone;
  fmt::print(out, "{}",
             order.palette.paint(Tone::heading,
                                 fmt::format("{:<66} {:>6} {:>6} {:>7} {:>7} {:>9}\n", "What is written, or wrong",
                                             "bytes", "cuts", "second", "safe", "not safe")));
  Tally sum;
  for (const Tally& tally : campaign.tallies()) {
    out << tell_row(tally);
    sum.cuts += tally.cuts;
    sum.second_cuts += tally.second_cuts;
    sum.safe += tally.safe;
    sum.unsafe += tally.unsafe;
  }
  const Usage usage;
  fmt::print(out,
             "\nEvent log: {} places; a record writes its busiest cell {:.0f} times, and a cell stands {:.0f} writes.\n"
             "{:.0f} power cycles of {:.0f} records and {:.0f} other events a day: it lasts {:.0f} years.\n\n",
             eeprom::places, campaign.writes_of_record(), cell_endurance, usage.power_cycles,
             usage.records_of_power_cycle, usage.events,
             years_of_log(usage, eeprom::places, std::max(1.0, campaign.writes_of_record())));
  for (std::size_t i = 0; i < std::min(most_told, campaign.failures().size()); ++i) {
    fmt::print(out, "{}  {}\n", order.palette.paint(Tone::alarm, "NOT SAFE"), campaign.failures()[i]);
  }
  if (campaign.failures().size() > most_told) {
    fmt::print(out, "... and {} more\n", campaign.failures().size() - most_told);
  }
  if (sum.unsafe == 0) {
    fmt::print(out, "all {} cases safe: {} cuts, {} of them with a second one, {} starts of the image (seed {})\n",
               sum.safe, sum.cuts, sum.second_cuts, campaign.starts(), order.seed);
  } else {
    fmt::print(out, "{} of {} cases NOT SAFE (seed {})\n", sum.unsafe, sum.safe + sum.unsafe, order.seed);
  }
}

}  // namespace

int run(const Order& order, std::ostream& out, std::ostream& err) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    Campaign campaign(order);
    campaign.run();
    tell(order, campaign, out);
    if (order.is_verbose) {
      const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      fmt::print(err, "{} starts in {:.1f} s, {:.0f} a second, {:.0f} x real time\n", campaign.starts(), wall,
                 campaign.starts() / wall, campaign.simulated() / wall);
    }
    return campaign.failures().empty() ? all_safe : some_unsafe;
  } catch (const std::runtime_error& error) {
    err << error.what() << '\n';
    return unusable;
  }
}

}  // namespace simulation::powercut
