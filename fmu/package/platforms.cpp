#include "package/platforms.h"

#include <algorithm>
#include <system_error>

namespace drape::package {
namespace {

namespace fs = std::filesystem;

std::vector<Platform> all_platforms(const fs::path& folder) {
  return {{"linux64", folder / "release" / "linux64", "drape_fmi2.so", "libdrape_contact.so", ".so", true},
          {"win64", folder / "release" / "win64", "drape_fmi2.dll", "drape_contact.dll", ".dll", true}};
}

Platform development(const fs::path& folder) {
  return {"linux64", folder, "drape_fmi2.so", "libdrape_contact.so", ".so", false};
}

bool is_built(const Platform& platform) {
  std::error_code error;
  return fs::exists(platform.folder / platform.binary, error);
}

// When the two libraries of a build were written, of those that exist.
std::vector<fs::file_time_type> times_of(const Platform& platform) {
  std::vector<fs::file_time_type> times;
  for (const std::string& name : {platform.binary, platform.contact}) {
    std::error_code error;
    const auto time = fs::last_write_time(platform.folder / name, error);
    if (!error) times.push_back(time);
  }
  return times;
}

// Whether no library of a release build is older than one of the development build.
bool is_fresh(const Platform& release, const Platform& development) {
  const std::vector<fs::file_time_type> made = times_of(release), other = times_of(development);
  if (made.empty() || other.empty()) return !made.empty();
  return *std::min_element(made.begin(), made.end()) >= *std::max_element(other.begin(), other.end());
}

std::string names_text(const std::vector<Platform>& platforms) {
  std::string text;
  for (const Platform& p : platforms) text += (text.empty() ? "" : ", ") + p.name;
  return text.empty() ? "none" : text;
}

}  // namespace

std::vector<Platform> platforms_built(const fs::path& folder, Build build,
                                      const std::vector<std::string>& names, std::string& problem) {
  const std::vector<Platform> all = all_platforms(folder);
  const Platform own = development(folder);
  std::vector<Platform> built, stale;
  if (build != Build::kDevelopment)
    for (const Platform& p : all)
      if (is_built(p)) (is_fresh(p, own) ? built : stale).push_back(p);
  const std::string remedy = "; `bash fmu/release.sh` builds it";
  if (build == Build::kRelease && built.empty())
    return problem = stale.empty()
                         ? "there is no release build" + remedy
                         : "the release build is older than the development build" + remedy + " again",
           built;
  const auto is_own = [&](const Platform& p) { return p.name == own.name; };
  if (build != Build::kRelease && is_built(own) && std::none_of(built.begin(), built.end(), is_own))
    built.insert(built.begin(), own);
  if (built.empty())
    return problem = "cannot read " + (folder / own.binary).string() +
                     ", the binary of the FMU; it belongs beside the drape command",
           built;
  if (names.empty()) return built;

  std::vector<Platform> chosen;
  for (const std::string& name : names) {
    const auto is_it = [&](const Platform& p) { return p.name == name; };
    if (std::none_of(all.begin(), all.end(), is_it))
      return problem = "--platforms names '" + name + "'; allowed: " + names_text(all),
             std::vector<Platform>{};
    if (std::any_of(chosen.begin(), chosen.end(), is_it))
      return problem = "--platforms names " + name + " twice; allowed: once", std::vector<Platform>{};
    const auto at = std::find_if(built.begin(), built.end(), is_it);
    if (at == built.end())
      return problem = "--platforms names " + name + ", which is not built" +
                       (std::any_of(stale.begin(), stale.end(), is_it) ? " since the sources changed" : "") +
                       "; built: " + names_text(built) + remedy,
             std::vector<Platform>{};
    chosen.push_back(*at);
  }
  return chosen;
}

}  // namespace drape::package
