#include "pack.h"

#include <zip.h>

#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "description.h"
#include "licenses/licenses.h"

namespace drape {
namespace {

// The binary that `drape` has been installed with.
std::filesystem::path binary_path() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "drape_fmi2.so";
}

// 1980-01-01 00:00, where the time of zip files begins: a packed scene does not depend on the hour.
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

bool fmu_pack(drape_cloth* cloth, Nodes nodes, const std::string& picture, const std::filesystem::path& file,
              std::string& problem) {
  const std::filesystem::path binary_file = binary_path();
  std::ifstream stream(binary_file, std::ios::binary);
  std::ostringstream binary;
  if (!stream || !(binary << stream.rdbuf())) {
    problem = "cannot read " + binary_file.string() +
              ", the binary of the FMU; it belongs beside the drape command";
    return false;
  }
  const Description d = description_of(cloth, nodes);
  std::vector<Entry> entries = {{"modelDescription.xml", description_xml_fmi2(d)},
                                {"binaries/linux64/" + d.identifier + ".so", binary.str()},
                                {"resources/scene.toml", drape_scene_text(cloth)},
                                {"documentation/index.html", description_html(d, picture)}};
  for (const License& license : kLicenses)
    entries.emplace_back("documentation/licenses/" + license.name, license.text);
  return archive_write(file, entries, problem);
}

}  // namespace drape
