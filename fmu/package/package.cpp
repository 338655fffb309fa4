#include "package/package.h"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "description.h"
#include "figures/model_picture.h"

namespace drape::package {
namespace {

// 1980-01-01 00:00, where the time of zip files begins: the bytes of a package do not depend on the time.
constexpr zip_uint16_t kZipTime = 0, kZipDate = 1 << 5 | 1;

bool entry_add(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (!source) return false;
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  return zip_file_set_dostime(archive, zip_uint64_t(index), kZipTime, kZipDate, 0) == 0;
}

using Entry = std::pair<std::string, std::string>;  // name, bytes

bool archive_write(const std::filesystem::path& file, const std::vector<Entry>& entries,
                   std::string& problem) {
  int code = 0;
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    problem = "cannot write " + file.string() + ": " + zip_error_strerror(&error);
    zip_error_fini(&error);
    return false;
  }
  bool added = true;
  for (const auto& [name, bytes] : entries) added = added && entry_add(archive, name, bytes);
  if (added && zip_close(archive) == 0) return true;
  problem = "cannot write " + file.string() + ": " + zip_strerror(archive);
  zip_discard(archive);
  return false;
}

bool file_read(const std::filesystem::path& file, std::string& bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream read;
  if (!stream || !(read << stream.rdbuf())) return false;
  bytes = read.str();
  return true;
}

// Adds a file. Returns its size.
std::size_t file_add(std::vector<Entry>& entries, const std::string& name, const std::filesystem::path& file,
                     std::string& problem) {
  std::string bytes;
  if (!file_read(file, bytes)) {
    if (problem.empty())
      problem = "cannot read " + file.string() + ", which an FMU holds; it belongs beside the drape command";
    return 0;
  }
  entries.emplace_back(name, std::move(bytes));
  return entries.back().second.size();
}

// The time of packing as FMI writes it: that of SOURCE_DATE_EPOCH, with which the bytes are the same each
// time, or now.
std::string date_now(std::string& problem) {
  constexpr std::int64_t kLast = 253402300799;  // the last second of the year 9999
  std::int64_t seconds = std::time(nullptr);
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH")) {
    const char* const end = given + std::strlen(given);
    const auto [read, error] = std::from_chars(given, end, seconds);
    if (error != std::errc() || read != end || seconds < 0 || seconds > kLast)
      problem = std::string("SOURCE_DATE_EPOCH is '") + given +
                "'; allowed: a whole number of seconds since 1970, from 0 to " + std::to_string(kLast);
  }
  const std::time_t time = problem.empty() ? std::time_t(seconds) : 0;
  std::tm utc{};
  gmtime_r(&time, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

// Adds the licences of what is packed for a platform. `list` gets the lines of components.csv.
void licenses_add(const Platform& platform, bool has_body, std::vector<Entry>& entries, std::string& list,
                  std::string& problem) {
  const std::filesystem::path folder = platform.folder / "licenses";
  std::string text, line;
  if (!file_read(folder / "components.csv", text)) {
    problem = "cannot read " + (folder / "components.csv").string() + "; it belongs beside the drape command";
    return;
  }
  std::istringstream lines(text);
  for (bool head = true; std::getline(lines, line); head = false) {
    if (head && list.empty()) list = line + '\n';
    if (head || (!has_body && line.find(",the binary,") == std::string::npos)) continue;
    list += line + '\n';
    std::string texts, text_file;
    std::istringstream columns(line);
    for (int column = 0; column < 4; ++column) std::getline(columns, texts, ',');  // the fourth names files
    for (std::istringstream files(texts); files >> text_file;) {
      const std::string name = "documentation/licenses/" + text_file;
      const auto is_it = [&](const Entry& entry) { return entry.first == name; };
      if (std::none_of(entries.begin(), entries.end(), is_it))
        file_add(entries, name, folder / text_file, problem);
    }
  }
}

}  // namespace

std::filesystem::path program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

std::vector<PackedPlatform> fmu_pack(drape_cloth* cloth, description::Nodes nodes,
                                     const std::vector<Platform>& platforms, const std::string& picture,
                                     const std::filesystem::path& file, std::string& problem) {
  const bool has_body = drape_file_count(cloth) > 0;
  description::Description d = description::description_of(cloth, nodes);
  d.date = date_now(problem);
  if (!problem.empty()) return {};
  std::vector<Entry> entries = {{"modelDescription.xml", description::description_xml_fmi2(d)},
                                {"resources/scene.toml", drape_scene_text(cloth)},
                                {"model.png", figures::model_png(cloth)},
                                {"documentation/index.html", description::description_html(d, picture)}};
  for (int k = 0; k < drape_file_count(cloth); ++k)
    file_add(entries, std::string("resources/") + drape_file_name(cloth, k), drape_file_path(cloth, k),
             problem);
  std::vector<PackedPlatform> packed;
  std::string list;
  for (const Platform& platform : platforms) {
    PackedPlatform& now = packed.emplace_back();
    now.name = platform.name;
    const std::string folder = "binaries/" + platform.name + "/";
    now.size = file_add(entries, folder + d.identifier + platform.ending, platform.folder / platform.binary,
                        problem);
    if (problem.empty()) now.glibc = glibc_needed(entries.back().second);
    if (has_body)
      now.size += file_add(entries, folder + platform.contact, platform.folder / platform.contact, problem);
    if (has_body && problem.empty()) now.glibc = glibc_newer(now.glibc, glibc_needed(entries.back().second));
    licenses_add(platform, has_body, entries, list, problem);
  }
  entries.emplace_back("documentation/licenses/components.csv", list);
  if (!problem.empty() || !archive_write(file, entries, problem)) packed.clear();
  return packed;
}

}  // namespace drape::package
