// One master with two slaves of the same scene, and what it knows of them.
#pragma once
#include "cases.h"
#include "fmi2Functions.h"
#include "variables.h"

namespace drape::fuzz {

// A scene as an unpacked FMU has it.
struct Resources {
  std::string folder, guid;
  std::vector<description::Variable> table;
  std::vector<double> start;  // of each row
  double interval;
};

Resources resources_make(const std::filesystem::path& work, const std::string& scene);

struct Slave {
  fmi2Component component = nullptr;
  double time = 0;
  struct Saved {
    fmi2FMUstate state;
    std::vector<double> outputs;  // empty where they could not be read
  };
  std::vector<Saved> saved;
};

struct Sequence {
  Random random;
  const Resources& resources;
  Outcome& outcome;
  fmi2CallbackFunctions callbacks{};
  Slave slave[2];
  std::size_t sentences = 0;  // logged by the present call
};

// The logger of the sequence's callbacks.
void fmi_logger(fmi2ComponentEnvironment sequence, fmi2String, fmi2Status status, fmi2String, fmi2String text,
                ...);

// Passes the status on. A refused call must have said why.
fmi2Status called(Sequence& s, const Slave& slave, const char* name, fmi2Status status);
#define CALL(NAME, ...) called(s, slave, #NAME, NAME(slave.component __VA_OPT__(, ) __VA_ARGS__))

// All outputs, which must be finite; or nothing where they may not be read now.
std::vector<double> outputs_read(Sequence& s, Slave& slave);

// Instantiates, once in a while with arguments that must be refused.
void slave_instantiate(Sequence& s, Slave& slave);
void slave_free(Sequence& s, Slave& slave);

}  // namespace drape::fuzz
