#include "apps/serve/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>
#include <unistd.h>

#include <fstream>

namespace trivet::serve {
namespace {

using namespace prometheus;

// Bounds of the buckets of durations, seconds: from a query to a heap.
const Histogram::BucketBoundaries kSeconds = {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30};

// Bytes of the process in memory; 0 where /proc does not tell.
double resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  double pages = 0, resident = 0;
  statm >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace

struct Metrics::State {
  Gauge& gauge(const char* name, const char* help) {
    return BuildGauge().Name(name).Help(help).Register(registry).Add({});
  }

  Registry registry;
  Family<Counter>& requests = BuildCounter()
                                  .Name("trivet_requests_total")
                                  .Help("Requests answered, by route and result")
                                  .Register(registry);
  Family<Histogram>& seconds = BuildHistogram()
                                   .Name("trivet_request_seconds")
                                   .Help("Seconds to compute an answer, by route")
                                   .Register(registry);
  Counter& refused =
      BuildCounter()
          .Name("trivet_requests_refused_total")
          .Help("Requests for another host or of pages, for which nothing is computed")
          .Register(registry)
          .Add({});
  Gauge& sessions = gauge("trivet_sessions", "Sessions that are open");
  Gauge& connections = gauge("trivet_connections", "Connections that are open");
  Gauge& waiting = gauge("trivet_requests_waiting", "Requests that wait for a thread");
  Gauge& computing = gauge("trivet_requests_computing", "Requests that a thread computes");
  Gauge& resident = gauge("process_resident_memory_bytes", "Resident memory size in bytes");
};

Metrics::Metrics() : m_state(std::make_unique<State>()) {}
Metrics::~Metrics() = default;

void Metrics::count(const std::string& route, const std::string& result, double seconds) {
  m_state->requests.Add({{"route", route}, {"result", result}}).Increment();
  m_state->seconds.Add({{"route", route}}, kSeconds).Observe(seconds);
}

std::string Metrics::text(const HttpLoad& load, size_t num_sessions) {
  m_state->sessions.Set(static_cast<double>(num_sessions));
  m_state->connections.Set(load.connections);
  m_state->waiting.Set(load.waiting);
  m_state->computing.Set(load.computing);
  m_state->refused.Increment(static_cast<double>(load.refused) - m_state->refused.Value());
  m_state->resident.Set(resident_bytes());
  return TextSerializer().Serialize(m_state->registry.Collect());
}

}  // namespace trivet::serve
