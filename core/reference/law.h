// The laws per width of a fabric on cells of size b. Equations: core/README.md, section 3.
#pragma once
#include "reference/curve.h"
#include "scene/scene.h"

namespace drape::reference {

// A law per width, and the end of its test. A direction without a law has a curve without points and an
// infinite end.
struct Law {
  Curve curve;         // N/m over strain
  double test_end;     // last elongation of the diagram
  double damping = 0;  // s; the tension per width is p(e) + damping p'(e) de/dt
};

Law yarn_law(const Scene& scene, const scene::FabricSpec& fabric, const scene::DiagramSpec& diagram,
             double b);
Law bias_law(const Scene& scene, const scene::FabricSpec& fabric, double b);

}  // namespace drape::reference
