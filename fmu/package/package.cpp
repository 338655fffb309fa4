#include "package/package.h"

#include <link.h>
#include <zip.h>

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
#include "package/licenses/licenses.h"

namespace drape::package {
namespace {

// The FMU binary installed with `drape`.
std::filesystem::path binary_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "drape_fmi2.so";
}

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

}  // namespace

namespace {

bool file_read(const std::filesystem::path& file, std::string& bytes) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream read;
  if (!stream || !(read << stream.rdbuf())) return false;
  bytes = read.str();
  return true;
}

// The contact library and what it needs beyond the C library, as loaded by this process.
std::vector<std::filesystem::path> contact_files() {
  std::vector<std::filesystem::path> files;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* to) {
        const std::filesystem::path file = info->dlpi_name;
        for (const char* name : {"libdrape_contact.", "libfcl.", "libccd.", "liboctomap.", "liboctomath.",
                                 "libstdc++.", "libgcc_s."})
          if (file.filename().string().starts_with(name))
            static_cast<std::vector<std::filesystem::path>*>(to)->push_back(file);
        return 0;
      },
      &files);
  return files;
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

// Adds what a scene with bodies needs beside the rest: meshes, libraries and their licences.
bool bodies_add(drape_cloth* cloth, std::vector<Entry>& entries, std::string& problem) {
  const auto add = [&](const std::string& name, const std::filesystem::path& file) {
    if (!file_read(file, entries.emplace_back(name, "").second)) problem = "cannot read " + file.string();
  };
  for (int k = 0; k < drape_file_count(cloth); ++k)
    add(std::string("resources/") + drape_file_name(cloth, k), drape_file_path(cloth, k));
  if (drape_file_count(cloth) == 0) return true;
  for (const std::filesystem::path& file : contact_files())
    add("binaries/linux64/" + file.filename().string(), file);
  for (const License& license : kContactLicenses)
    entries.emplace_back("documentation/licenses/" + license.name, license.text);
  return problem.empty();
}

}  // namespace

bool fmu_pack(drape_cloth* cloth, description::Nodes nodes, const std::string& picture,
              const std::filesystem::path& file, std::string& problem) {
  const std::filesystem::path binary_file = binary_path();
  std::string binary;
  if (!file_read(binary_file, binary)) {
    problem = "cannot read " + binary_file.string() +
              ", the binary of the FMU; it belongs beside the drape command";
    return false;
  }
  description::Description d = description::description_of(cloth, nodes);
  d.date = date_now(problem);
  if (!problem.empty()) return false;
  std::vector<Entry> entries = {{"modelDescription.xml", description::description_xml_fmi2(d)},
                                {"binaries/linux64/" + d.identifier + ".so", binary},
                                {"resources/scene.toml", drape_scene_text(cloth)},
                                {"model.png", figures::model_png(cloth)},
                                {"documentation/index.html", description::description_html(d, picture)}};
  for (const License& license : kLicenses)
    entries.emplace_back("documentation/licenses/" + license.name, license.text);
  if (!bodies_add(cloth, entries, problem)) return false;
  entries.emplace_back("documentation/licenses/components.csv",
                       kComponents + (drape_file_count(cloth) > 0 ? kContactComponents : ""));
  return archive_write(file, entries, problem);
}

}  // namespace drape::package
