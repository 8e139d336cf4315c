#include <sstream>

#include "core/base/quoted.h"
#include "ops/base/refusal.h"

namespace trivet {
namespace {

/// Writes one sentence per cause.
class Writer {
 public:
  explicit Writer(const Refusal& refusal) : m_r(refusal) { m_out.precision(4); }

  std::string run() {
    write();
    return m_out.str();
  }

 private:
  // "the floor", or the quoted name.
  std::string name(size_t i) const {
    if (i >= m_r.objects.size()) return "?";
    const std::string& name = m_r.objects[i].name;
    return name == kFloorName ? "the floor" : quoted(name);
  }
  bool has(size_t i) const { return i < m_r.objects.size(); }
  double number(const char* key) const { return m_r.number(key); }
  long whole(const char* key) const { return static_cast<long>(m_r.number(key)); }

  using Cause = Refusal::Cause;

  void write() {
    if (!write_request() && !write_state() && !write_exact_test() && !write_motion() &&
        !write_place())
      write_interruption();
  }

  bool write_request() {
    switch (m_r.cause) {
      case Cause::InvalidArgument:
        m_out << m_r.detail;
        return true;
      case Cause::UnknownObject:
        m_out << "there is no object " << name(0);
        if (has(1)) m_out << " to put " << name(1) << " on";
        if (!m_r.detail.empty()) m_out << "; did you mean " << quoted(m_r.detail) << "?";
        return true;
      case Cause::InvalidName:
        m_out << quoted(m_r.objects[0].name)
              << " is no name; accepted: UTF-8 without control characters, not \"floor\"";
        return true;
      case Cause::NameTaken:
        m_out << "there is an object " << name(0) << " already";
        return true;
      case Cause::ModelNotLoaded:
        m_out << "the model " << quoted(m_r.detail) << " of " << name(0) << " was not loaded";
        return true;
      case Cause::NotInteractive:
        m_out << m_r.detail << " cannot follow a hand";
        return true;
      default:
        return false;
    }
  }

  void write_immovable(const char* how, const char* cure) {
    m_out << name(0) << " is " << how << (has(1) ? " and would have to move along: " : ": ") << cure
          << " it first";
  }

  bool write_state() {
    switch (m_r.cause) {
      case Cause::Fixed:
        write_immovable("fixed", "unfix");
        return true;
      case Cause::Locked:
        write_immovable("locked", "unlock");
        return true;
      case Cause::NotPlaced:
        m_out << name(0) << " is not in the scene: put it there first";
        return true;
      case Cause::SupportNotPlaced:
        m_out << name(0) << " is not in the scene";
        return true;
      case Cause::NoFloor:
        m_out << "there is no floor to put " << name(0) << " on";
        return true;
      case Cause::OnItself:
        m_out << name(0) << " cannot be put on itself or on what it carries";
        return true;
      case Cause::TooCoarse:
        write_too_coarse();
        return true;
      case Cause::InvalidClearance:
        m_out << "a clearance of " << number("clearance") << " m is not between "
              << number("smallest") << " and " << number("largest")
              << " m for a scene of this size";
        return true;
      default:
        return false;
    }
  }

  void write_too_coarse() {
    m_out << name(0) << " reaches a coordinate of " << number("coordinate")
          << " m: the clearance there, " << number("clearance") << " m, is too coarse for "
          << name(1) << " of " << number("diagonal")
          << " m; accepted: coordinates and sizes of scenes up to " << number("largest_coordinate")
          << " m";
    if (number("largest_clearance") > 0)
      m_out << ", or a clearance that is asked for, up to " << number("largest_clearance") << " m";
  }

  bool write_exact_test() {
    const char* what = nullptr;
    switch (m_r.cause) {
      case Cause::Crossing:
        what = " passes through ";
        break;
      case Cause::Inside:
        what = " is inside ";
        break;
      case Cause::Float32Contact:
        what = " would touch ";
        break;
      case Cause::BelowFloor:
        what = " reaches below the floor";
        break;
      case Cause::Float32BelowFloor:
        what = " would reach below the floor in an exported file";
        break;
      default:
        return false;
    }
    if (m_r.at == Refusal::At::Start) m_out << "at its start position ";
    if (m_r.at == Refusal::At::Given) m_out << "at its position ";
    m_out << name(0) << what;
    if (has(1)) m_out << name(1);
    if (m_r.cause == Cause::Float32Contact) m_out << " in the float32 values of an exported file";
    if (m_r.at == Refusal::At::Now) m_out << ": move it out freely first";
    return true;
  }

  bool write_motion() {
    switch (m_r.cause) {
      case Cause::AlreadyTouches:
        m_out << name(0) << " touches " << name(1) << " already";
        return true;
      case Cause::NothingBelow:
        m_out << "nothing is below " << name(0) << ": it would fall for ever";
        return true;
      case Cause::Topples:
        m_out << "the scene would not stand at friction " << number("friction") << ": "
              << names_from(1) << " would move";
        return true;
      case Cause::Wedged:
        m_out << name(0) << " is wedged " << wedged_where()
              << ": it can neither sink further nor be held there";
        return true;
      case Cause::TouchesAtStart:
        m_out << name(0) << " touches something at its start";
        return true;
      case Cause::TooManyMotions:
        m_out << name(0) << " did not come to rest within " << whole("max_motions") << " motions";
        return true;
      case Cause::PathTooLong:
        m_out << name(0) << " did not get to the end of its way within " << whole("max_motions")
              << " motions";
        return true;
      default:
        return write_missing_contact();
    }
  }

  bool write_missing_contact() {
    switch (m_r.cause) {
      case Cause::NothingToSlideOn:
        m_out << name(0) << " lies on nothing along which it could be pushed";
        return true;
      case Cause::LiesOnNothing:
        m_out << name(0) << " lies on nothing: there is no contact " << m_r.detail;
        return true;
      case Cause::NoContact:
        m_out << name(0) << " does not touch " << (has(1) ? name(1) : "anything")
              << ": there is no contact " << m_r.detail;
        return true;
      case Cause::PointContact:
        m_out << name(0) << " touches " << name(1)
              << " in one point: there is no line to turn about";
        return true;
      default:
        return false;
    }
  }

  std::string wedged_where() const {
    if (m_r.objects.size() < 2) return "in the air";
    return (m_r.objects.size() == 2 ? "against " : "between ") + names_from(1);
  }

  std::string names_from(size_t first) const {
    std::string out;
    for (size_t i = first; i < m_r.objects.size(); ++i)
      out.append(out.empty() ? "" : " and ").append(name(i));
    return out;
  }

  bool write_place() {
    switch (m_r.cause) {
      case Cause::NoFreePlace:
        m_out << "no free place for " << name(0) << " on " << name(1) << ": of " << whole("judged")
              << " places, every " << number("spacing") << " m, " << whole("beside")
              << " are over no part of it and " << whole("blocked")
              << " are blocked by other things";
        if (m_r.first)
          m_out << "; it was tried at " << whole("tried") << " others: first "
                << message(*m_r.first);
        return true;
      case Cause::KeepTooLarge:
        m_out
            << name(0) << " cannot be kept " << number("keep")
            << " m away from everything else: a scene so large is too coarse for its objects, the "
               "smallest of which is "
            << number("diagonal") << " m; accepted: a distance to keep of up to "
            << number("largest_keep") << " m";
        return true;
      case Cause::RestsOnOther:
        m_out << name(0) << " would come to rest against " << name(1);
        return true;
      case Cause::NoArrangement:
        m_out << m_r.detail;
        return true;
      case Cause::RestsTooClose:
        m_out << name(0) << " would come to rest too near to " << name(1);
        return true;
      default:
        return false;
    }
  }

  void write_interruption() {
    if (m_r.cause == Cause::NotTried)
      m_out << "not tried, because " << m_r.detail << " of " << name(0) << " was refused before";
    else if (m_r.cause == Cause::Cancelled)
      m_out << m_r.detail << " of " << name(0) << " was cancelled";
    else
      m_out << m_r.detail << " of " << name(0) << " did not end within " << number("seconds")
            << " s";
  }

  const Refusal& m_r;
  std::ostringstream m_out;
};

}  // namespace

std::string message(const Refusal& refusal) { return Writer(refusal).run(); }

}  // namespace trivet
