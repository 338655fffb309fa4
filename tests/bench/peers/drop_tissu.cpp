// Tissu's core in double precision, called as its Python module calls it. `tissu_drop SECONDS PLACES` writes
// the positions of the particles at the end as lines of x y z, and prints the wall and processor seconds of
// the frames. drop_tissu.py defines the names in capitals. Y is up here, and lengths are in decimetres:
// hinges of triangles below 1e-4 squared units have no effect.
// of triangles below 1e-4 squared units do nothing.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include "engine/Cloth.hpp"
#include "engine/ClothMesh.hpp"
#include "engine/World.hpp"
#include "physics/GravityForce.hpp"
#include "physics/Solver.hpp"

namespace {

constexpr double kUnits = 10;                    // a metre
constexpr double kMass = DENSITY * CELL * CELL;  // kg: the unit of mass, of a particle inside
constexpr double kFrame = 1.0 / 60;
constexpr int kSubsteps = 10, kIterations = 3;

void scene_fill(Tissu::World& world, Tissu::Solver& solver) {
  const Eigen::Vector3d gravity(0, -GRAVITY * kUnits, 0);
  world.setGravity(gravity);
  world.addForce(std::make_shared<Tissu::GravityForce>(gravity));
  world.setThickness(THICKNESS * kUnits);
  world.addSphereCollider(Eigen::Vector3d::Zero(), RADIUS * kUnits, FRICTION, "ball");

  // Compliances: 1 over stiffness in kg/s2, which no unit of length changes; 1 over rigidity in kg dm2/s2.
  const auto material = std::make_shared<Tissu::ClothMaterial>(1.0, kMass / STRETCH, kMass / SHEAR,
                                                               kMass / (BENDING * kUnits * kUnits));
  const auto cloth = std::make_shared<Tissu::Cloth>("sheet", material);
  const Eigen::Vector3d corner(CORNER_X * kUnits, CORNER_Z * kUnits, -CORNER_Y * kUnits);
  const Eigen::Quaterniond level(Eigen::AngleAxisd(-EIGEN_PI / 2, Eigen::Vector3d::UnitX()));
  Tissu::ClothMesh().initGrid(SIDE, SIDE, CELL * kUnits, *cloth, solver, corner, level);
  world.addCloth(cloth);

  // A particle weighs one unit before the cloth's mass is added. Gravity is a force that does not depend on
  // the mass of a particle: the fall is right when all particles weigh one unit.
  for (int id = 0; id < SIDE * SIDE; ++id) solver.setParticleInverseMass(id, 1.0);
  solver.setSubsteps(kSubsteps);
  solver.setIterations(kIterations);
}

}  // namespace

int main(int, char** arguments) {
  const double seconds = std::atof(arguments[1]);
  Tissu::World world;
  Tissu::Solver solver;
  scene_fill(world, solver);

  const int frames = seconds > kFrame ? static_cast<int>(seconds / kFrame + 0.5) : 1;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t before = std::clock();
  for (int frame = 0; frame < frames; ++frame) solver.update(world, kFrame);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  const double processor = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  std::printf("%.9g %.9g\n", wall.count() / (frames * kFrame), processor / (frames * kFrame));

  std::FILE* file = std::fopen(arguments[2], "w");
  if (!file) return 1;
  for (const Tissu::Particle& particle : solver.getParticles()) {
    const Eigen::Vector3d r = particle.getPosition() / kUnits;
    std::fprintf(file, "%.17g %.17g %.17g\n", r.x(), -r.z(), r.y());
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
