// The laws per width of a fabric on cells of edge b. Equations: core/README.md, section 3.
#pragma once
#include "reference/curve.h"
#include "scene/scene.h"

namespace drape::reference {

// A law per width and where its test ended; a law switched off has a curve without points and no end.
struct Law {
  Curve curve;         // N/m over strain
  double test_end;     // last elongation of the diagram
  double damping = 0;  // s: a link pulls with p(e) + damping p'(e) de/dt
};

Law thread_law(const Scene& scene, const scene::FabricSpec& fabric, const scene::DiagramSpec& diagram,
               double b);
Law bias_law(const Scene& scene, const scene::FabricSpec& fabric, double b);

}  // namespace drape::reference
