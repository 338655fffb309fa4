#include "command/files/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/files/whole_file.h"
#include "decimal.h"
#include "instance/unfinished.h"

namespace drape::command {
namespace {

ReportTable elongations(drape_cloth* cloth, double limit) {
  ReportTable table{"elongation",
                    {"piece", "direction"},
                    {{"min", "%"},
                     {"mean", "%"},
                     {"max", "%"},
                     {"limit", "%"},
                     {"beyond the limit", "% of area"},
                     {"largest tension", "N/m"}},
                    {}};
  const std::pair<drape_yarn_direction, const char*> directions[] = {
      {DRAPE_WARP, "warp"}, {DRAPE_WEFT, "weft"}, {DRAPE_BIAS, "bias"}};
  for (int p = 0; p < drape_piece_count(cloth); ++p)
    for (const auto& [along, name] : directions) {
      const drape_elongation e = drape_elongation_of(cloth, p, along, limit);
      const double tension = along == DRAPE_BIAS ? NAN : e.tension_max,
                   bound = std::isfinite(e.limit) ? 100 * e.limit : NAN;  // NaN for a law that is off
      table.rows.push_back(
          {{drape_piece_at(cloth, p).name, name},
           {100 * e.strain.min, 100 * e.strain.mean, 100 * e.strain.max, bound, 100 * e.beyond, tension}});
    }
  return table;
}

ReportTable fit(drape_cloth* cloth, const drape_outputs& o) {
  return {"fit",
          {"of"},
          {{"unbalanced forces", "of the load"}, {"allowed", "of the load"}, {"at rest", "1"}},
          {{{"the cloth"}, {o.fit_residual, instance::kResidualAtRest, double(drape_at_rest(cloth))}}}};
}

ReportTable seams(drape_cloth* cloth, const drape_outputs& o) {
  ReportTable table{
      "seams",
      {"seam"},
      {{"largest gap", "mm"}, {"mean gap", "mm"}, {"told to close", "1"}, {"closed", "1"}, {"length", "m"}},
      {}};
  for (int k = 0; k < o.seam_count; ++k) {
    const drape_seam& seam = o.seam[k];
    const drape_seam_lines lines = drape_seam_lines_at(cloth, k);
    double sum = 0;
    for (int n = 0; n < 3 * lines.pair_count; n += 3)
      sum += std::hypot(lines.b[n] - lines.a[n], lines.b[n + 1] - lines.a[n + 1],
                        lines.b[n + 2] - lines.a[n + 2]);
    table.rows.push_back(
        {{seam.name},
         {1e3 * seam.gap_max, 1e3 * sum / lines.pair_count, double(seam.due), seam.closed, seam.length}});
  }
  return table;
}

ReportTable contact(drape_cloth* cloth, const drape_outputs& o) {
  const drape_fields& f = *drape_fields_at(cloth);
  double area = 0, force = 0;
  for (int n = 0; n < f.node_count; ++n) {
    force += f.pressure[n] * f.area[n];
    if (f.pressure[n] > 0) area += f.area[n];
  }
  return {"contact",
          {"of"},
          {{"particles", "1"},
           {"area", "m2"},
           {"normal force", "N"},
           {"mean pressure", "Pa"},
           {"largest pressure", "Pa"},
           {"penetration", "mm"}},
          {{{"all bodies"},
            {o.contact_count, area, force, area > 0 ? force / area : 0, o.contact_pressure,
             1e3 * o.contact_penetration}}}};
}

ReportTable bodies(const drape_outputs& o) {
  ReportTable table{"force of the cloth on bodies",
                    {"body"},
                    {{"force x", "N"},
                     {"force y", "N"},
                     {"force z", "N"},
                     {"torque x", "N.m"},
                     {"torque y", "N.m"},
                     {"torque z", "N.m"}},
                    {}};
  for (int b = 0; b < o.body_count; ++b) {
    const drape_body& body = o.body[b];
    table.rows.push_back(
        {{body.name},
         {body.force[0], body.force[1], body.force[2], body.torque[0], body.torque[1], body.torque[2]}});
  }
  return table;
}

std::string cell_text(double value) {
  if (std::isnan(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// A table whose columns are as wide as their texts: words left-aligned, numbers right-aligned.
std::string table_text(const ReportTable& t) {
  std::vector<std::vector<std::string>> lines(1, t.labels);
  for (const ReportColumn& c : t.columns) lines[0].push_back(c.unit == "1" ? c.name : c.name + ", " + c.unit);
  for (const ReportTable::Row& row : t.rows) {
    lines.push_back(row.words);
    for (const double value : row.values) lines.back().push_back(cell_text(value));
  }
  std::vector<std::size_t> width(lines[0].size(), 0);
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) width[k] = std::max(width[k], line[k].size());
  std::string text = t.title + "\n";
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::string fill(width[k] - line[k].size(), ' ');
      text += "  " + (k < t.labels.size() ? line[k] + fill : fill + line[k]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<ReportTable> report_of(drape_cloth* cloth, double limit) {
  std::vector<ReportTable> report{elongations(cloth, limit)};
  const drape_outputs& o =
      *drape_get_outputs(cloth, DRAPE_OUT_POSITION | DRAPE_OUT_VELOCITY | DRAPE_OUT_STRAIN);
  if (o.has_fit) report.push_back(fit(cloth, o));
  if (o.seam_count > 0) report.push_back(seams(cloth, o));
  if (o.body_count > 0) {
    report.push_back(contact(cloth, o));
    report.push_back(bodies(o));
  }
  return report;
}

std::string report_text(const std::vector<ReportTable>& report) {
  std::string text;
  for (const ReportTable& t : report) text += (text.empty() ? "" : "\n") + table_text(t);
  return text;
}

std::string report_csv(const std::vector<ReportTable>& report) {
  std::string text = "table,what,quantity,value,unit\n";
  for (const ReportTable& t : report)
    for (const ReportTable::Row& row : t.rows)
      for (std::size_t k = 0; k < row.values.size(); ++k) {
        if (std::isnan(row.values[k])) continue;
        std::string what;
        for (const std::string& word : row.words) what += (what.empty() ? "" : " ") + word;
        text += t.title + "," + what + "," + t.columns[k].name + "," +
                description::decimal_text(row.values[k]) + "," + t.columns[k].unit + "\n";
      }
  return text;
}

std::string report_write(const std::filesystem::path& file, const std::vector<ReportTable>& report) {
  return file_write(file, file.extension() == ".csv" ? report_csv(report) : report_text(report)).problem;
}

}  // namespace drape::command
