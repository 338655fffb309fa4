// Integrates y' = motion_rate(y) by ARKODE's ERKStep with embedded error control. This is the only file that
// uses SUNDIALS. Each advance ends exactly at the requested time, where the inputs have a kink. Source:
// SUNDIALS 6.4.1, ARKODE user guide, "Using ERKStep".
#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "reference/motion.h"
#include "reference/sewing.h"

namespace drape::reference {

struct Solver {
  Motion* motion = nullptr;
  SUNContext context = nullptr;
  N_Vector y = nullptr, tolerance = nullptr;
  void* arkode = nullptr;
  double time = 0;
  Course course;        // of the present advance
  Outside outside;      // at its end
  std::string message;  // ARKODE's last error message
};

namespace {

using Eigen::VectorXd;

Eigen::Map<VectorXd> view(N_Vector v) { return {N_VGetArrayPointer(v), Eigen::Index(N_VGetLength(v))}; }

// Makes ARKODE stop where values are not finite.
int rate(realtype, N_Vector y, N_Vector ydot, void* user) {
  const VectorXd state = view(y);
  const Solver& solver = *static_cast<const Solver*>(user);
  view(ydot) = motion_rate(*solver.motion, solver.course, state);
  return view(ydot).allFinite() ? 0 : -1;
}

void message_store(int, const char*, const char*, char* message, void* user) {
  static_cast<Solver*>(user)->message = message;
}

void demand(const Solver& solver, int flag, const char* call) {
  if (flag >= 0) return;
  char* name = ERKStepGetReturnFlagName(flag);
  std::ostringstream text;
  text.precision(9);
  text << "the reference run failed at t = " << solver.time << " s: " << call << " returned ARKODE flag "
       << flag << " (" << (name ? name : "unnamed") << ")";
  if (!solver.message.empty()) text << ": " << solver.message;
  std::free(name);
  throw std::runtime_error(text.str());
}

// Sets ARKODE's default method of an order. SUNDIALS 6.4.1 assumes of each table whose last stage is at c = 1
// that this stage is the first of the next step (LLNL/sundials issue 311). It then starts each step with a
// wrong slope: Verner's method of order 6 falls to order 3, Fehlberg's of order 8 to about 6. Our equations
// do not use ARKODE's time, as time is one of their states. So any c is valid, and c = 0 makes ARKODE
// evaluate the slope again.
void set_method(Solver& solver, int order) {
  constexpr int kTables[] = {ERKSTEP_DEFAULT_2, ERKSTEP_DEFAULT_3, ERKSTEP_DEFAULT_4, ERKSTEP_DEFAULT_5,
                             ERKSTEP_DEFAULT_6, ERKSTEP_DEFAULT_8, ERKSTEP_DEFAULT_8};
  ARKodeButcherTable table = ARKodeButcherTable_LoadERK(static_cast<ARKODE_ERKTableID>(kTables[order - 2]));
  if (!table) throw std::runtime_error("SUNDIALS gives no explicit method of order " + std::to_string(order));
  table->c[table->stages - 1] = 0;
  const int flag = ERKStepSetTable(solver.arkode, table);
  ARKodeButcherTable_Free(table);
  demand(solver, flag, "ERKStepSetTable");
}

void set_tolerance(Solver& solver, double rtol) {
  const Lattice& lattice = solver.motion->lattice;
  const Layout at = layout_of(lattice);
  double mass = 0;
  for (double m : lattice.mass) mass += m;
  auto tolerance = view(solver.tolerance);
  tolerance.setConstant(rtol * mass * 1.0);  // for impulses and work: the mass at 1 m/s
  tolerance.head(at.velocity).setConstant(rtol * lattice.cell);
  tolerance.segment(at.velocity, at.velocity).setConstant(rtol * 1.0);
  tolerance.segment(at.angular, at.input - at.angular).setConstant(rtol * mass * 1.0 * lattice.cell);
  tolerance.segment(at.integral, at.time - at.integral).setConstant(rtol * lattice.cell);
  tolerance[at.time] = 1.0;  // exact by every method
  demand(solver, ERKStepSVtolerances(solver.arkode, rtol, solver.tolerance), "ERKStepSVtolerances");
}

}  // namespace

void SolverClose::operator()(Solver* solver) const {
  if (solver->arkode) ERKStepFree(&solver->arkode);
  if (solver->tolerance) N_VDestroy(solver->tolerance);
  if (solver->y) N_VDestroy(solver->y);
  if (solver->context) SUNContext_Free(&solver->context);
  delete solver;
}

SolverHandle solver_open(Motion& motion, const VectorXd& y, const Accuracy& accuracy) {
  SolverHandle handle(new Solver);
  Solver& s = *handle;
  s.motion = &motion;
  s.outside = motion.start;
  if (SUNContext_Create(nullptr, &s.context) != 0) throw std::runtime_error("SUNDIALS gives no context");
  s.y = N_VNew_Serial(y.size(), s.context);
  s.tolerance = N_VNew_Serial(y.size(), s.context);
  if (!s.y || !s.tolerance) throw std::runtime_error("SUNDIALS gives no vectors");
  view(s.y) = y;
  s.arkode = ERKStepCreate(rate, 0, s.y, s.context);
  if (!s.arkode) throw std::runtime_error("SUNDIALS gives no ERKStep");
  demand(s, ERKStepSetErrHandlerFn(s.arkode, message_store, &s), "ERKStepSetErrHandlerFn");
  demand(s, ERKStepSetUserData(s.arkode, &s), "ERKStepSetUserData");
  set_method(s, accuracy.order);
  demand(s, ERKStepSetInterpolantDegree(s.arkode, 1), "ERKStepSetInterpolantDegree");
  demand(s, ERKStepSetMaxNumSteps(s.arkode, -1), "ERKStepSetMaxNumSteps");
  set_tolerance(s, accuracy.rtol);
  if (accuracy.fixed_step > 0)
    demand(s, ERKStepSetFixedStep(s.arkode, accuracy.fixed_step), "ERKStepSetFixedStep");
  return handle;
}

VectorXd solver_advance(Solver& s, double time, const Outside& to) {
  s.course = course_make(s.motion->lattice, s.outside, to, time - s.time);
  VectorXd y = view(s.y);
  motion_sew(*s.motion, s.time, s.outside, y);
  motion_begin(*s.motion, s.course, y);
  view(s.y) = y;
  demand(s, ERKStepReset(s.arkode, s.time, s.y), "ERKStepReset");
  demand(s, ERKStepSetStopTime(s.arkode, time), "ERKStepSetStopTime");
  realtype reached = s.time;
  const int flag = ERKStepEvolve(s.arkode, time, s.y, &reached, ARK_NORMAL);
  s.time = reached;
  demand(s, flag, "ERKStepEvolve");
  s.time = time;
  s.outside = course_at(s.course, s.course.length);
  return view(s.y);
}

VectorXd solver_advance(Solver& s, double time) { return solver_advance(s, time, s.outside); }

const Outside& solver_outside(const Solver& s) { return s.outside; }

double solver_last_step(Solver& s) {
  realtype step = 0;
  demand(s, ERKStepGetLastStep(s.arkode, &step), "ERKStepGetLastStep");
  return step;
}

long solver_step_count(Solver& s) {
  long count = 0;
  demand(s, ERKStepGetNumSteps(s.arkode, &count), "ERKStepGetNumSteps");
  return count;
}

}  // namespace drape::reference
