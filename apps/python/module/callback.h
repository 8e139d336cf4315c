// Python functions that are told of progress.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <optional>

namespace trivet::python {

namespace py = pybind11;

/// Calls Python from whichever thread reports, one at a time. What it raises is kept for the
/// caller, and sets `cancel`. Made and ended with the GIL.
class PythonCallback {
 public:
  PythonCallback(py::object callback, std::atomic<bool>& cancel)
      : m_callback(std::move(callback)), m_cancel(cancel) {}

  bool is_given() const { return !m_callback.is_none(); }

  template <class... Values>
  void operator()(const Values&... values) {
    if (m_cancel) return;
    const py::gil_scoped_acquire acquire;
    if (m_raised) return;
    try {
      m_callback(values...);
    } catch (py::error_already_set& e) {
      m_raised.emplace(std::move(e));
      m_cancel = true;
    }
  }

  bool has_raised() const { return m_raised.has_value(); }
  void rethrow() {
    if (m_raised) throw std::move(*m_raised);
  }

 private:
  py::object m_callback;
  std::atomic<bool>& m_cancel;
  std::optional<py::error_already_set> m_raised;
};

}  // namespace trivet::python
