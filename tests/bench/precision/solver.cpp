// Sources: SUNDIALS 6.4.1, user guides of ARKODE (ERKStep, ARKStep) and CVODE. Implicit methods solve by
// Newton with SPGMR, without a preconditioner; products with the Jacobian are differences of f.
#include "bench/precision/solver.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace drape::bench {
namespace {

constexpr int kKrylov = 20;  // vectors of SPGMR, at most

// The allocations of one run, and the data of its right-hand sides.
struct Session {
  const Equations& equations;
  long evaluations = 0, max_evaluations;
  SUNContext context = nullptr;
  N_Vector y = nullptr, tolerance = nullptr;
  SUNLinearSolver linear = nullptr;
  SUNNonlinearSolver nonlinear = nullptr;
  void *erk = nullptr, *ark = nullptr, *cvode = nullptr;
};

void close(Session& s) {
  if (s.erk) ERKStepFree(&s.erk);
  if (s.ark) ARKStepFree(&s.ark);
  if (s.cvode) CVodeFree(&s.cvode);
  if (s.linear) SUNLinSolFree(s.linear);
  if (s.nonlinear) SUNNonlinSolFree(s.nonlinear);
  if (s.tolerance) N_VDestroy(s.tolerance);
  if (s.y) N_VDestroy(s.y);
  if (s.context) SUNContext_Free(&s.context);
}

// The equations do not depend on time. Numbers that are not finite request a smaller step; too many
// evaluations end the run.
int evaluate(Session& s, const Rate& rate, N_Vector y, N_Vector ydot) {
  if (++s.evaluations > s.max_evaluations) return -1;
  double* to = N_VGetArrayPointer(ydot);
  rate(N_VGetArrayPointer(y), to);
  double sum[8] = {};  // independent sums, so that the check is cheap beside the forces
  const sunindextype n = N_VGetLength(y);
  for (sunindextype k = 0; k + 8 <= n; k += 8)
    for (sunindextype j = 0; j < 8; ++j) sum[j] += 0 * to[k + j];
  for (sunindextype k = n / 8 * 8; k < n; ++k) sum[0] += 0 * to[k];
  for (double part : sum)
    if (part != 0) return 1;  // also true for NaN
  return 0;
}
Session& of(void* user) { return *static_cast<Session*>(user); }
int whole(realtype, N_Vector y, N_Vector ydot, void* s) {
  return evaluate(of(s), of(s).equations.rate, y, ydot);
}
int outer(realtype, N_Vector y, N_Vector ydot, void* s) {
  return evaluate(of(s), of(s).equations.outer, y, ydot);
}
int inner(realtype, N_Vector y, N_Vector ydot, void* s) {
  return evaluate(of(s), of(s).equations.inner, y, ydot);
}
void ignore_message(int, const char*, const char*, char*, void*) {}  // a failed run gives no row

void demand(int flag, const char* call) {
  if (flag < 0)
    throw std::runtime_error(std::string("SUNDIALS: ") + call + " returned " + std::to_string(flag));
}

// The last stage at c = 0: core/reference/solver.cpp explains it.
void erk_table(Session& s, int order) {
  const ARKODE_ERKTableID id = order == 2   ? ARKODE_HEUN_EULER_2_1_2
                               : order == 3 ? ARKODE_BOGACKI_SHAMPINE_4_2_3
                               : order == 4 ? ARKODE_ZONNEVELD_5_3_4
                               : order == 5 ? ARKODE_DORMAND_PRINCE_7_4_5
                               : order == 6 ? ARKODE_VERNER_8_5_6
                                            : ARKODE_FEHLBERG_13_7_8;
  ARKodeButcherTable table = ARKodeButcherTable_LoadERK(id);
  if (order >= 6) table->c[table->stages - 1] = 0;
  const int flag = ERKStepSetTable(s.erk, table);
  ARKodeButcherTable_Free(table);
  demand(flag, "ERKStepSetTable");
}

void open_erk(Session& s, const Method& m, double end, double rtol) {
  s.erk = ERKStepCreate(whole, 0, s.y, s.context);
  demand(ERKStepSetErrHandlerFn(s.erk, ignore_message, nullptr), "ERKStepSetErrHandlerFn");
  demand(ERKStepSetUserData(s.erk, &s), "ERKStepSetUserData");
  erk_table(s, m.order);
  demand(ERKStepSVtolerances(s.erk, rtol, s.tolerance), "ERKStepSVtolerances");
  demand(ERKStepSetInterpolantDegree(s.erk, 1), "ERKStepSetInterpolantDegree");
  demand(ERKStepSetMaxNumSteps(s.erk, -1), "ERKStepSetMaxNumSteps");
  demand(ERKStepSetStopTime(s.erk, end), "ERKStepSetStopTime");
}

void open_ark(Session& s, const Method& m, double end, double rtol) {
  const bool imex = m.family == Family::kImex;
  s.ark = ARKStepCreate(imex ? outer : nullptr, imex ? inner : whole, 0, s.y, s.context);
  demand(ARKStepSetErrHandlerFn(s.ark, ignore_message, nullptr), "ARKStepSetErrHandlerFn");
  demand(ARKStepSetUserData(s.ark, &s), "ARKStepSetUserData");
  demand(ARKStepSetOrder(s.ark, m.order), "ARKStepSetOrder");
  demand(ARKStepSVtolerances(s.ark, rtol, s.tolerance), "ARKStepSVtolerances");
  s.linear = SUNLinSol_SPGMR(s.y, SUN_PREC_NONE, kKrylov, s.context);
  demand(ARKStepSetLinearSolver(s.ark, s.linear, nullptr), "ARKStepSetLinearSolver");
  demand(ARKStepSetInterpolantDegree(s.ark, 1), "ARKStepSetInterpolantDegree");
  demand(ARKStepSetMaxNumSteps(s.ark, -1), "ARKStepSetMaxNumSteps");
  demand(ARKStepSetStopTime(s.ark, end), "ARKStepSetStopTime");
}

void open_cvode(Session& s, const Method& m, double end, double rtol) {
  s.cvode = CVodeCreate(m.family == Family::kBdf ? CV_BDF : CV_ADAMS, s.context);
  demand(CVodeInit(s.cvode, whole, 0, s.y), "CVodeInit");
  demand(CVodeSetErrHandlerFn(s.cvode, ignore_message, nullptr), "CVodeSetErrHandlerFn");
  demand(CVodeSetUserData(s.cvode, &s), "CVodeSetUserData");
  demand(CVodeSVtolerances(s.cvode, rtol, s.tolerance), "CVodeSVtolerances");
  if (m.family == Family::kAdams) {
    s.nonlinear = SUNNonlinSol_FixedPoint(s.y, 0, s.context);
    demand(CVodeSetNonlinearSolver(s.cvode, s.nonlinear), "CVodeSetNonlinearSolver");
  } else {
    s.linear = SUNLinSol_SPGMR(s.y, SUN_PREC_NONE, kKrylov, s.context);
    demand(CVodeSetLinearSolver(s.cvode, s.linear, nullptr), "CVodeSetLinearSolver");
  }
  demand(CVodeSetMaxNumSteps(s.cvode, -1), "CVodeSetMaxNumSteps");
  demand(CVodeSetStopTime(s.cvode, end), "CVodeSetStopTime");
}

int evolve(Session& s, double end) {
  realtype reached = 0;
  if (s.erk) return ERKStepEvolve(s.erk, end, s.y, &reached, ARK_NORMAL);
  if (s.ark) return ARKStepEvolve(s.ark, end, s.y, &reached, ARK_NORMAL);
  return CVode(s.cvode, end, s.y, &reached, CV_NORMAL);
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> kMethods = {{"ERK", Family::kErk, 2},
                                               {"ERK", Family::kErk, 3},
                                               {"ERK", Family::kErk, 4},
                                               {"ERK", Family::kErk, 5},
                                               {"ERK", Family::kErk, 6},
                                               {"ERK", Family::kErk, 8},
                                               {"DIRK", Family::kDirk, 2},
                                               {"DIRK", Family::kDirk, 3},
                                               {"DIRK", Family::kDirk, 4},
                                               {"DIRK", Family::kDirk, 5},
                                               {"IMEX", Family::kImex, 3},
                                               {"IMEX", Family::kImex, 4},
                                               {"IMEX", Family::kImex, 5},
                                               {"Adams", Family::kAdams, 0},
                                               {"Adams, Krylov", Family::kAdamsKrylov, 0},
                                               {"BDF, Krylov", Family::kBdf, 0}};
  return kMethods;
}

Solved solve(const Equations& e, const Method& m, double end, double rtol, long max_evaluations) {
  Session s{.equations = e, .max_evaluations = max_evaluations};
  if (SUNContext_Create(nullptr, &s.context) != 0) throw std::runtime_error("SUNDIALS gives no context");
  const auto size = sunindextype(e.start.size());
  s.y = N_VNew_Serial(size, s.context);
  s.tolerance = N_VNew_Serial(size, s.context);
  std::copy(e.start.begin(), e.start.end(), N_VGetArrayPointer(s.y));
  for (std::size_t k = 0; k < e.scale.size(); ++k) N_VGetArrayPointer(s.tolerance)[k] = rtol * e.scale[k];
  if (m.family == Family::kErk) open_erk(s, m, end, rtol);
  else if (m.family == Family::kDirk || m.family == Family::kImex) open_ark(s, m, end, rtol);
  else open_cvode(s, m, end, rtol);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Solved solved;
  solved.done = evolve(s, end) >= 0;
  solved.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  solved.evaluations = s.evaluations;
  solved.y.assign(N_VGetArrayPointer(s.y), N_VGetArrayPointer(s.y) + size);
  close(s);
  return solved;
}

}  // namespace drape::bench
