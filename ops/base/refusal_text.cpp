// Refusals as sentences, one per cause.
#include <algorithm>
#include <sstream>

#include "core/base/quoted.h"
#include "ops/base/refusal.h"

namespace trivet {
namespace {

class Writer {
 public:
  explicit Writer(const Refusal& refusal) : m_r(refusal) {}

  Sentence run() const {
    for (const auto part : {&Writer::request, &Writer::state, &Writer::exact_test, &Writer::motion,
                            &Writer::place, &Writer::drape})
      if (auto out = (this->*part)()) return with_tries(*out);
    return interruption();
  }

 private:
  using Cause = Refusal::Cause;
  using Maybe = std::optional<Sentence>;

  Sentence name(size_t i) const {
    if (!has(i)) return Sentence(std::string("?"));
    const std::string& name = m_r.objects[i].name;
    return name == kFloorName ? Sentence("the floor") : Sentence(quoted(name));
  }
  bool has(size_t i) const { return i < m_r.objects.size(); }
  Sentence number(const char* key) const { return figure(m_r.number(key), 4); }
  Sentence whole(const char* key) const { return static_cast<long>(m_r.number(key)); }
  const Sentence& detail() const { return m_r.detail; }

  Sentence with_tries(const Sentence& reason) const {
    if (!(m_r.number("tries") > 1)) return reason;
    return say(TRIVET_SENTENCE("%1; %2 starts were tried, up to %3 m from there"), reason,
               whole("tries"), number("within"));
  }

  Maybe request() const {
    switch (m_r.cause) {
      case Cause::InvalidArgument:
        return detail();
      case Cause::UnknownObject:
        return unknown_object();
      case Cause::InvalidName:
        return say(TRIVET_SENTENCE("%1 is no name; accepted: UTF-8 without control characters, not "
                                   "\"floor\""),
                   quoted(m_r.objects[0].name));
      case Cause::NameTaken:
        return say(TRIVET_SENTENCE("there is an object %1 already"), name(0));
      case Cause::ModelNotLoaded:
        return say(TRIVET_SENTENCE("the model %1 of %2 was not loaded"),
                   quoted(in_english(m_r.detail)), name(0));
      case Cause::NotInteractive:
        return say(TRIVET_SENTENCE("%1 cannot follow a hand"), detail());
      default:
        return {};
    }
  }

  Sentence unknown_object() const {
    Sentence out = say(TRIVET_SENTENCE("there is no object %1"), name(0));
    if (has(1)) out = say(TRIVET_SENTENCE("there is no object %1 to put %2 on"), name(0), name(1));
    if (m_r.detail.empty()) return out;
    return say(TRIVET_SENTENCE("%1; did you mean %2?"), out, quoted(in_english(m_r.detail)));
  }

  Maybe state() const {
    switch (m_r.cause) {
      case Cause::Fixed:
        return say(has(1) ? TRIVET_SENTENCE("%1 is fixed and would have to move along: unfix it "
                                            "first")
                          : TRIVET_SENTENCE("%1 is fixed: unfix it first"),
                   name(0));
      case Cause::Locked:
        return say(has(1) ? TRIVET_SENTENCE("%1 is locked and would have to move along: unlock it "
                                            "first")
                          : TRIVET_SENTENCE("%1 is locked: unlock it first"),
                   name(0));
      case Cause::NotPlaced:
        return say(TRIVET_SENTENCE("%1 is not in the scene: put it there first"), name(0));
      case Cause::SupportNotPlaced:
        return say(TRIVET_SENTENCE("%1 is not in the scene"), name(0));
      case Cause::NoFloor:
        return say(TRIVET_SENTENCE("there is no floor to put %1 on"), name(0));
      case Cause::OnItself:
        return say(TRIVET_SENTENCE("%1 cannot be put on itself or on what it carries"), name(0));
      default:
        return precision();
    }
  }

  Maybe precision() const {
    if (m_r.cause == Cause::InvalidClearance)
      return say(TRIVET_SENTENCE("a clearance of %1 m is not between %2 and %3 m for a scene of "
                                 "this size"),
                 number("clearance"), number("smallest"), number("largest"));
    if (m_r.cause != Cause::TooCoarse) return {};
    Sentence out = say(
        TRIVET_SENTENCE("%1 reaches a coordinate of %2 m: the clearance there, %3 m, is too coarse "
                        "for %4 of %5 m; accepted: coordinates and sizes of scenes up to %6 m"),
        name(0), number("coordinate"), number("clearance"), name(1), number("diagonal"),
        number("largest_coordinate"));
    if (!(m_r.number("largest_clearance") > 0)) return out;
    return say(TRIVET_SENTENCE("%1, or a clearance that is asked for, up to %2 m"), out,
               number("largest_clearance"));
  }

  const char* exact_pattern() const {
    switch (m_r.cause) {
      case Cause::Crossing:
        return TRIVET_SENTENCE("%1 passes through %2");
      case Cause::Inside:
        return TRIVET_SENTENCE("%1 is inside %2");
      case Cause::Float32Contact:
        return TRIVET_SENTENCE("%1 would touch %2 in the float32 values of an exported file");
      case Cause::BelowFloor:
        return TRIVET_SENTENCE("%1 reaches below the floor");
      case Cause::Float32BelowFloor:
        return TRIVET_SENTENCE("%1 would reach below the floor in an exported file");
      default:
        return nullptr;
    }
  }

  // Only poses that a user gave have one.
  Sentence with_depth(const Sentence& pattern) const {
    const auto has_depth = [](const Refusal::Number& n) { return n.key == "depth"; };
    if (std::none_of(m_r.numbers.begin(), m_r.numbers.end(), has_depth)) return pattern;
    if (m_r.number("depth") == 0 && has(1))
      return say(TRIVET_SENTENCE("%1 touches %2, and there is no room to move it apart"), name(0),
                 name(1));
    return say(TRIVET_SENTENCE("%1, by %2 m near (%3, %4, %5)"), pattern, number("depth"),
               number("x"), number("y"), number("z"));
  }

  Maybe exact_test() const {
    const char* const pattern = exact_pattern();
    if (!pattern) return {};
    Sentence out = with_depth(say(pattern, name(0), name(1)));
    switch (m_r.at) {
      case Refusal::At::Start:
        return say(TRIVET_SENTENCE("at its start position %1"), out);
      case Refusal::At::Given:
        return say(TRIVET_SENTENCE("at its position %1"), out);
      case Refusal::At::Now:
        return say(TRIVET_SENTENCE("%1: move it out freely first"), out);
      case Refusal::At::End:
        break;
    }
    return out;
  }

  Maybe motion() const {
    switch (m_r.cause) {
      case Cause::AlreadyTouches:
        return say(TRIVET_SENTENCE("%1 touches %2 already"), name(0), name(1));
      case Cause::NothingBelow:
        if (m_r.number("slides") > 0)
          return say(
              TRIVET_SENTENCE("%1 slides or tips off what is below it, and would fall for ever"),
              name(0));
        return say(TRIVET_SENTENCE("nothing is below %1: it would fall for ever"), name(0));
      case Cause::Topples:
        return say(TRIVET_SENTENCE("the scene would not stand at friction %1: %2 would move"),
                   number("friction"), names_from(1));
      case Cause::Wedged:
        return wedged();
      case Cause::TouchesAtStart:
        return say(TRIVET_SENTENCE("%1 touches something at its start"), name(0));
      case Cause::TooManyMotions:
        return say(TRIVET_SENTENCE("%1 did not come to rest within %2 motions"), name(0),
                   whole("max_motions"));
      case Cause::PathTooLong:
        return say(TRIVET_SENTENCE("%1 did not get to the end of its way within %2 motions"),
                   name(0), whole("max_motions"));
      default:
        return missing_contact();
    }
  }

  Sentence wedged() const {
    if (m_r.objects.size() < 2)
      return say(TRIVET_SENTENCE("%1 is wedged in the air: it can neither sink further nor be held "
                                 "there"),
                 name(0));
    return say(m_r.objects.size() == 2
                   ? TRIVET_SENTENCE("%1 is wedged against %2: it can neither sink further nor be "
                                     "held there")
                   : TRIVET_SENTENCE("%1 is wedged between %2: it can neither sink further nor be "
                                     "held there"),
               name(0), names_from(1));
  }

  Maybe missing_contact() const {
    switch (m_r.cause) {
      case Cause::NothingToSlideOn:
        return say(TRIVET_SENTENCE("%1 lies on nothing along which it could be pushed"), name(0));
      case Cause::LiesOnNothing:
        return say(TRIVET_SENTENCE("%1 lies on nothing: there is no contact %2"), name(0),
                   purpose());
      case Cause::NoContact:
        return say(TRIVET_SENTENCE("%1 does not touch %2: there is no contact %3"), name(0),
                   has(1) ? name(1) : Sentence("anything"), purpose());
      case Cause::PointContact:
        return say(TRIVET_SENTENCE("%1 touches %2 in one point: there is no line to turn about"),
                   name(0), name(1));
      default:
        return {};
    }
  }

  // Purpose of a contact.
  Sentence purpose() const { return detail(); }

  Sentence names_from(size_t first) const {
    if (!has(first)) return {};
    Sentence out = name(first);
    for (size_t i = first + 1; has(i); ++i) out = say(TRIVET_SENTENCE("%1 and %2"), out, name(i));
    return out;
  }

  Maybe place() const {
    switch (m_r.cause) {
      case Cause::NoFreePlace:
        return no_free_place();
      case Cause::KeepTooLarge:
        return say(
            TRIVET_SENTENCE(
                "%1 cannot be kept %2 m away from everything else: a scene so large is too coarse "
                "for its objects, the smallest of which is %3 m; accepted: a distance to keep of "
                "up to %4 m"),
            name(0), number("keep"), number("diagonal"), number("largest_keep"));
      case Cause::RestsOnOther:
        return say(TRIVET_SENTENCE("%1 would come to rest against %2"), name(0), name(1));
      case Cause::NoArrangement:
        return detail();
      case Cause::RestsTooClose:
        return say(TRIVET_SENTENCE("%1 would come to rest too near to %2"), name(0), name(1));
      case Cause::LeavesRegion:
        if (has(1))
          return say(TRIVET_SENTENCE("%1 fits nowhere on %2 in its region"), name(0), name(1));
        return say(TRIVET_SENTENCE("%1 would come to rest partly outside its region"), name(0));
      case Cause::StandsBadly:
        if (m_r.number("least_margin") > 0)
          return say(TRIVET_SENTENCE("%1 would not stand well: it tips over an edge %2 m away; "
                                     "accepted: %3 m or more"),
                     name(0), number("margin"), number("least_margin"));
        return say(TRIVET_SENTENCE("%1 would not stand well: it needs friction of %2; accepted: "
                                   "%3 or less"),
                   name(0), number("friction"), number("most_friction"));
      default:
        return {};
    }
  }

  Maybe drape() const {
    switch (m_r.cause) {
      case Cause::CrossesItself:
        return say(m_r.at == Refusal::At::Start
                       ? TRIVET_SENTENCE("at its start %1 passes through itself")
                       : TRIVET_SENTENCE("%1 would pass through itself"),
                   name(0));
      case Cause::NoSheet:
        return say(TRIVET_SENTENCE("%1 cannot be draped: %2"), name(0), detail());
      case Cause::Overstretched:
        return say(TRIVET_SENTENCE("%1 would be stretched by a factor of %2; accepted: up to %3. "
                                   "Its pins are too far apart, or it is too weak"),
                   name(0), number("stretch"), number("largest_stretch"));
      case Cause::NotAtRest:
        return say(TRIVET_SENTENCE("%1 did not come to rest within %2 steps: near (%3, %4, %5) a "
                                   "force of %6 times the weight of a vertex is left"),
                   name(0), whole("steps"), number("x"), number("y"), number("z"),
                   number("net_force"));
      default:
        return {};
    }
  }

  Sentence no_free_place() const {
    Sentence out = say(
        TRIVET_SENTENCE("no free place for %1 on %2: of %3 places, every %4 m, %5 are over no "
                        "part of it and %6 are blocked by other objects"),
        name(0), name(1), whole("judged"), number("spacing"), whole("beside"), whole("blocked"));
    if (m_r.number("outside") > 0)
      out = say(TRIVET_SENTENCE("%1; at %2 more it would leave its region"), out, whole("outside"));
    if (!m_r.first) return out;
    return say(TRIVET_SENTENCE("%1; it was tried at %2 others: first %3"), out, whole("tried"),
               sentence_of(*m_r.first));
  }

  Sentence interruption() const {
    if (m_r.cause == Cause::NotTried)
      return say(TRIVET_SENTENCE("not tried, because %1 of %2 was refused before"), detail(),
                 name(0));
    if (m_r.cause == Cause::Cancelled)
      return say(TRIVET_SENTENCE("%1 of %2 was cancelled"), detail(), name(0));
    return say(TRIVET_SENTENCE("%1 of %2 did not end within %3 s"), detail(), name(0),
               number("seconds"));
  }

  const Refusal& m_r;
};

}  // namespace

Sentence sentence_of(const Refusal& refusal) { return Writer(refusal).run(); }

std::string message(const Refusal& refusal) { return in_english(sentence_of(refusal)); }

}  // namespace trivet
