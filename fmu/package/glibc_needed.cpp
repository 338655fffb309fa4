// The versions that an ELF library needs, read from its file: gABI 4.1, chapter 5, and the symbol versioning
// of the Linux Standard Base.
#include <elf.h>

#include <charconv>
#include <cstring>
#include <utility>

#include "package/platforms.h"

namespace drape::package {
namespace {

struct File {
  std::string_view bytes;

  // A struct at a place of the file. False beyond its end.
  template <class T>
  bool read(std::size_t at, T& to) const {
    if (at > bytes.size() || bytes.size() - at < sizeof to) return false;
    std::memcpy(&to, bytes.data() + at, sizeof to);
    return true;
  }
  std::string_view text(std::size_t at) const {
    return at < bytes.size() ? bytes.substr(at, bytes.find('\0', at) - at) : std::string_view{};
  }
};

struct Sections {
  Elf64_Shdr needed{}, names{};
};

// The section of needed versions and that of its texts.
bool sections_find(const File& file, Sections& found) {
  Elf64_Ehdr head;
  if (!file.read(0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
      head.e_ident[EI_CLASS] != ELFCLASS64 || head.e_ident[EI_DATA] != ELFDATA2LSB)
    return false;
  for (std::size_t k = 0; k < head.e_shnum; ++k)
    if (!file.read(head.e_shoff + k * sizeof(Elf64_Shdr), found.needed)) return false;
    else if (found.needed.sh_type == SHT_GNU_verneed)
      return file.read(head.e_shoff + found.needed.sh_link * sizeof(Elf64_Shdr), found.names);
  return false;
}

using Version = std::pair<int, int>;
// The first two numbers of "2.17" or "2.2.5"; zeros of any other text.
Version version_of(const std::string& text) {
  const char* const end = text.data() + text.size();
  Version version{0, 0};
  const auto [dot, no_first] = std::from_chars(text.data(), end, version.first);
  if (no_first != std::errc() || dot == end || *dot != '.') return {0, 0};
  const auto [rest, no_second] = std::from_chars(dot + 1, end, version.second);
  return no_second == std::errc() ? version : Version{0, 0};
}

}  // namespace

std::string glibc_newer(const std::string& a, const std::string& b) {
  return version_of(a) < version_of(b) ? b : a;
}

std::string glibc_needed(std::string_view bytes) {
  const File file{bytes};
  Sections sections;
  if (!sections_find(file, sections)) return "";
  constexpr std::string_view kPrefix = "GLIBC_";
  std::string newest;
  std::size_t library_at = sections.needed.sh_offset;
  Elf64_Verneed library;
  for (unsigned k = 0; k < sections.needed.sh_info && file.read(library_at, library); ++k) {
    std::size_t version_at = library_at + library.vn_aux;
    Elf64_Vernaux version;
    for (unsigned i = 0; i < library.vn_cnt && file.read(version_at, version); ++i) {
      const std::string name(file.text(sections.names.sh_offset + version.vna_name));
      if (name.starts_with(kPrefix)) newest = glibc_newer(newest, name.substr(kPrefix.size()));
      version_at += version.vna_next;
    }
    library_at += library.vn_next;
  }
  return newest;
}

}  // namespace drape::package
