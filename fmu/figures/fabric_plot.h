// The tables of a fabric's strips as a picture: the input diagram against the simulated one.
#pragma once
#include <string>
#include <vector>

namespace drape::figures {

struct PlotPanel {
  std::string title;
  std::vector<double> elongation;        // [points] fraction
  std::vector<double> input, simulated;  // [points] N
};

std::string fabric_plot_svg(const std::string& title, const std::vector<PlotPanel>& panels);

}  // namespace drape::figures
