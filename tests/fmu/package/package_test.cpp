// The packed FMU: its contents, and that packing twice gives the same bytes.
#include "package/package.h"

#include <gtest/gtest.h>
#include <zip.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>

#include "description.h"

namespace drape::package {
namespace {

using Cloth = std::unique_ptr<drape_cloth, void (*)(drape_cloth*)>;
Cloth open_swatch() { return {drape_open(DRAPE_SAMPLES "/swatch.toml", nullptr, nullptr), drape_close}; }

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::map<std::string, std::string> entries_of(const std::string& file) {
  std::map<std::string, std::string> entries;
  zip_t* archive = zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, nullptr);
  if (!archive) return entries;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
    zip_stat_t stat;
    zip_stat_index(archive, zip_uint64_t(i), 0, &stat);
    std::string bytes(stat.size, '\0');
    zip_file_t* entry = zip_fopen_index(archive, zip_uint64_t(i), 0);
    EXPECT_EQ(zip_fread(entry, bytes.data(), stat.size), zip_int64_t(stat.size));
    zip_fclose(entry);
    entries[stat.name] = bytes;
  }
  zip_discard(archive);
  return entries;
}

constexpr char kDate[] = "1970-01-02T00:00:00Z";
std::vector<Platform> own_platforms() {
  std::string problem;
  std::vector<Platform> platforms = platforms_built(program_folder(), Build::kDevelopment, {}, problem);
  EXPECT_EQ(problem, "");
  return platforms;
}

std::string pack_swatch(const std::string& name, description::Nodes nodes) {
  setenv("SOURCE_DATE_EPOCH", "86400", 1);
  const Cloth cloth = open_swatch();
  const std::string file = testing::TempDir() + name;
  std::string problem;
  const std::vector<PackedPlatform> packed =
      fmu_pack(cloth.get(), nodes, own_platforms(), "<svg><title>here</title></svg>", file, problem);
  EXPECT_EQ(packed.size(), 1u) << problem;
  return file;
}

TEST(Package, HoldsDescriptionBinarySceneAndDocumentation) {
  const Cloth cloth = open_swatch();
  std::map<std::string, std::string> entries =
      entries_of(pack_swatch("drape_pack.fmu", description::Nodes::kOutline));
  EXPECT_EQ(entries.size(), 11u);
  description::Description expected = description::description_of(cloth.get(), description::Nodes::kOutline);
  expected.date = kDate;
  EXPECT_EQ(entries["modelDescription.xml"], description::description_xml_fmi2(expected));
  EXPECT_TRUE(entries["model.png"].starts_with("\x89PNG"));
  EXPECT_EQ(entries["binaries/linux64/swatch.so"], bytes_of(DRAPE_FMI2_BINARY));
  EXPECT_EQ(entries["resources/scene.toml"], drape_scene_text(cloth.get()));
  EXPECT_NE(entries["documentation/index.html"].find("<title>here</title>"), std::string::npos);
  EXPECT_NE(entries["documentation/index.html"].find("fabric.wool.areal_density"), std::string::npos);
}

// Code compiled into the binary requires that its licence travels with it.
TEST(Package, CarriesTheLicencesOfWhatItHolds) {
  std::map<std::string, std::string> entries =
      entries_of(pack_swatch("drape_licences.fmu", description::Nodes::kNone));
  const std::string permission = "Permission is hereby granted, free of charge",
                    folder = "documentation/licenses/";
  EXPECT_EQ(entries[folder + "drape.txt"], bytes_of(DRAPE_LICENSE));
  EXPECT_NE(bytes_of(DRAPE_LICENSE).find(description::kCopyright), std::string::npos);
  EXPECT_NE(entries[folder + "tomlplusplus.txt"].find("Mark Gillard"), std::string::npos);
  EXPECT_NE(entries[folder + "tomlplusplus.txt"].find(permission), std::string::npos);
  EXPECT_NE(entries[folder + "gcc.txt"].find("GCC RUNTIME LIBRARY EXCEPTION"), std::string::npos);
  const std::string& gpl = entries[folder + "gpl-3.0.txt"];
  EXPECT_NE(gpl.find("Version 3, 29 June 2007"), std::string::npos);
  EXPECT_NE(gpl.find("END OF TERMS AND CONDITIONS"), std::string::npos);
  EXPECT_NE(entries[folder + "fmi.txt"].find("Modelica Association"), std::string::npos);
  EXPECT_NE(entries[folder + "components.csv"].find("Drape,0.1.0,MIT,drape.txt,the binary"),
            std::string::npos);
}

TEST(Package, SameSceneSameBytes) {
  const std::string once = bytes_of(pack_swatch("drape_once.fmu", description::Nodes::kNone));
  EXPECT_FALSE(once.empty());
  EXPECT_EQ(once, bytes_of(pack_swatch("drape_again.fmu", description::Nodes::kNone)));
  EXPECT_NE(once, bytes_of(pack_swatch("drape_nodes.fmu", description::Nodes::kAll)));
}

TEST(Package, NamesTheFileItCannotWrite) {
  const Cloth cloth = open_swatch();
  std::string problem;
  EXPECT_TRUE(fmu_pack(cloth.get(), description::Nodes::kNone, own_platforms(), "<svg/>",
                       "/no/such/folder/cloth.fmu", problem)
                  .empty());
  EXPECT_NE(problem.find("/no/such/folder/cloth.fmu"), std::string::npos) << problem;
}

// A folder with empty files in place of binaries, some younger than others.
struct Binaries {
  std::filesystem::path folder;
  explicit Binaries(const char* name) : folder(testing::TempDir() + name) {
    std::filesystem::remove_all(folder);
  }
  ~Binaries() { std::filesystem::remove_all(folder); }
  void put(const std::string& file, int age) const {  // age in s
    std::filesystem::create_directories((folder / file).parent_path());
    std::ofstream(folder / file) << "x";
    std::filesystem::last_write_time(
        folder / file, std::filesystem::file_time_type::clock::now() - std::chrono::seconds(age));
  }
};

std::string names_of(const std::vector<Platform>& platforms) {
  std::string names;
  for (const Platform& p : platforms) names += p.name + (p.released ? "* " : " ");
  return names;
}

TEST(Platforms, TheReleaseBuildIsTakenUnlessTheSourcesHaveChangedSince) {
  const Binaries made("drape_platforms");
  const auto found = [&](Build build, const std::vector<std::string>& names = {}) {
    std::string problem;
    const std::string text = names_of(platforms_built(made.folder, build, names, problem));
    EXPECT_NE(text.empty(), problem.empty());
    return text + problem;
  };
  EXPECT_NE(found(Build::kNewest).find("drape_fmi2.so, the binary of the FMU; it belongs beside"),
            std::string::npos);
  made.put("drape_fmi2.so", 20);
  EXPECT_EQ(found(Build::kNewest), "linux64 ");
  EXPECT_EQ(found(Build::kNewest, {"win64"}),
            "--platforms names win64, which is not built; built: linux64; `bash fmu/release.sh` builds it");
  EXPECT_EQ(found(Build::kRelease), "there is no release build; `bash fmu/release.sh` builds it");
  made.put("release/win64/drape_fmi2.dll", 10);
  EXPECT_EQ(found(Build::kNewest), "linux64 win64* ");
  EXPECT_EQ(found(Build::kRelease), "win64* ");
  made.put("release/linux64/drape_fmi2.so", 10);
  EXPECT_EQ(found(Build::kNewest), "linux64* win64* ");
  EXPECT_EQ(found(Build::kNewest, {"win64"}), "win64* ");
  EXPECT_EQ(found(Build::kDevelopment), "linux64 ");
  EXPECT_EQ(found(Build::kNewest, {"win32"}), "--platforms names 'win32'; allowed: linux64, win64");
  EXPECT_EQ(found(Build::kNewest, {"win64", "win64"}), "--platforms names win64 twice; allowed: once");
  made.put("libdrape_contact.so", 0);  // the contact library alone is newer
  EXPECT_EQ(found(Build::kNewest), "linux64 ");
  made.put("libdrape_contact.so", 15);
  EXPECT_EQ(found(Build::kNewest), "linux64* win64* ");
  made.put("release/win64/drape_contact.dll", 17);  // older than that of the development build
  EXPECT_EQ(found(Build::kNewest), "linux64* ");
  made.put("release/win64/drape_contact.dll", 10);
  made.put("drape_fmi2.so", 0);
  EXPECT_EQ(found(Build::kNewest), "linux64 ");
  EXPECT_NE(found(Build::kNewest, {"win64"}).find("not built since the sources changed; built: linux64"),
            std::string::npos);
  EXPECT_NE(found(Build::kRelease).find("older than the development build"), std::string::npos);
}

TEST(Platforms, TheVersionOfGlibcIsReadFromTheLibrary) {
  const std::string bytes = bytes_of(DRAPE_FMI2_BINARY), needed = glibc_needed(bytes);
  EXPECT_TRUE(needed.starts_with("2.")) << needed;
  EXPECT_NE(bytes.find("GLIBC_" + needed + '\0'), std::string::npos);
  EXPECT_EQ(glibc_newer("2.9", "2.28"), "2.28");
  EXPECT_EQ(glibc_newer("2.36", "2.4"), "2.36");
  EXPECT_EQ(glibc_newer("", "2.4"), "2.4");
  EXPECT_EQ(glibc_needed("MZ, a library of Windows"), "");
  for (std::size_t size = 0; size < 4096; size += 7)
    EXPECT_EQ(glibc_needed(bytes.substr(0, size)), "") << size;
}

}  // namespace
}  // namespace drape::package
