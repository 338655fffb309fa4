// One cloth as the slave of a master, independent of the FMI version: its life cycle, values by reference,
// checked requests, saved states and log. fmi2.cpp is a thin layer over it.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drape/drape.h"
#include "instance/balance_watch.h"
#include "variables.h"

namespace drape::instance {

enum class Phase : unsigned { kInstantiated, kInitialization, kStepComplete, kTerminated, kError };

// The log. With DRAPE_LOG_ERROR, `status` is what the refused or failed call returns.
using LogFn = void(void* user, drape_status status, drape_log_kind kind, const std::string& message);

// Reasons for a refused or failed call are always logged. The filter applies to all other messages.
struct LogFilter {
  bool warnings = true, events = false, stability = false;
};

// The outputs at the communication point before the present one, for derivatives.
struct History {
  int read = 0;               // the groups of outputs that it holds: bits as in drape_get_outputs
  double length = 0;          // s, from there to the present point
  std::vector<double> value;  // [recorded rows]
};

// A copy of everything in an instance that changes.
struct Saved {
  drape_snapshot* cloth = nullptr;  // freed with the instance or by instance_forget
  Phase phase = Phase::kInstantiated;
  double stop_time = 0;    // s
  std::int64_t steps = 0;  // this and the rest as in Instance
  int read = 0, derivatives_asked = 0;
  History history;
  BalanceWatch balance;
};

struct Instance {
  drape_cloth* cloth = nullptr;
  std::vector<description::Variable> table;
  Phase phase = Phase::kInstantiated;
  double stop_time = std::numeric_limits<double>::infinity();  // s; infinity: none
  std::vector<std::unique_ptr<Saved>> saved;
  const Saved* initial = nullptr;     // one of the saved states: the state to reset to
  std::int64_t steps = 0;             // made by the master
  int read = 0;                       // the outputs that hold the present time: bits as in drape_get_outputs
  int read_before_saving = 0;         // the same, when the state was saved that the present one has come from
  std::vector<std::size_t> recorded;  // rows of the outputs whose derivative is a slope
  History history;
  bool has_energy = false;    // the scene asks for energies
  BalanceWatch balance;       // with energies: at every communication point
  int derivatives_asked = 0;  // groups of outputs of which a derivative has been asked
  bool surprised = false;     // the last call took a value that may surprise: it has been logged
  LogFn* log = nullptr;
  void* log_user = nullptr;
  LogFilter filter;
  // Messages of the core, logged when the status of the call is known.
  std::vector<std::pair<drape_log_kind, std::string>> pending_messages;
};

// Opens the scene and checks that the guid is its own. Returns null after a fault, which has been logged.
Instance* instance_open(const std::string& scene_file, const std::string& guid, LogFilter filter, LogFn* log,
                        void* user);
void instance_close(Instance* instance);

// Logs a sentence and returns the status.
drape_status instance_refuse(Instance& instance, drape_status status, const std::string& sentence);

// Computes groups of outputs at the present time: bits as in drape_get_outputs.
void instance_read_outputs(Instance& instance, int needs);

// Logs the messages that the core sent during a call that returned `status`.
drape_status instance_flush(Instance& instance, drape_status status);

// Life cycle. The caller has checked that the phase allows the call. Times are in s.
drape_status instance_setup(Instance& instance, double start_time, double stop_time);
drape_status instance_exit_initialization(Instance& instance);
drape_status instance_step(Instance& instance, double time, double length);
// Warns of a fit without rest, of seams that have not closed, and of energy that is missing.
void instance_terminate(Instance& instance);
void instance_reset(Instance& instance);

// Values by reference, of one type of FMI. As Real, any variable is a number: masters may read all in one
// call. A call that names one bad value changes nothing.
enum class As { kReal, kInteger, kBoolean };
drape_status instance_get(Instance& instance, As as, const std::uint32_t* references, std::size_t count,
                          double* values);
drape_status instance_set(Instance& instance, As as, const std::uint32_t* references, std::size_t count,
                          const double* values);

// Time derivatives of Real outputs; `orders` must be 1. That of a position is its velocity. Of other outputs
// it is the slope over the last communication step, 0 before there are two points, and of those that jump 0.
drape_status instance_get_derivatives(Instance& instance, const std::uint32_t* references, std::size_t count,
                                      const int* orders, double* values);
History history_take(Instance& instance);  // of the present point, before a step

// Time derivatives of inputs at the beginning of the next step. `orders` must be 1.
drape_status instance_set_rates(Instance& instance, const std::uint32_t* references, std::size_t count,
                                const int* orders, const double* values);

// Saved states belong to the instance. `into` is overwritten unless it is null. A state that is not the
// instance's own is refused (null, DRAPE_DISCARD).
Saved* instance_save(Instance& instance, Saved* into);
drape_status instance_restore(Instance& instance, const Saved* saved);
drape_status instance_forget(Instance& instance, const Saved* saved);

// Saved states as bytes, for other instances of the same scene in any process. `size` is that of
// instance_bytes_size. Bytes that are not whole, or of another scene, are refused (null, DRAPE_DISCARD).
drape_status instance_bytes_size(Instance& instance, const Saved* saved, std::size_t* size);
drape_status instance_write(Instance& instance, const Saved* saved, unsigned char* bytes, std::size_t size);
Saved* instance_read(Instance& instance, const unsigned char* bytes, std::size_t size);

}  // namespace drape::instance
