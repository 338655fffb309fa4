// What the static C++ runtime of GCC lacks in a library that is loaded into an unknown host and unloaded
// again. Of the development build; the release build has another runtime.
#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <sys/random.h>

#include <cstdint>

#ifdef __GLIBCXX__
namespace __gnu_cxx {
void __freeres();  // NOLINT(bugprone-reserved-identifier): the name is libstdc++'s
}

namespace {

// libstdc++ takes 72 kB for exceptions without memory when it is loaded, and does not give them back by
// itself.
__attribute__((destructor)) void exception_pool_free() { __gnu_cxx::__freeres(); }

}  // namespace
#endif

// What newer versions of glibc give this code under newer names: with the older ones the library loads where
// glibc is 2.34, though it is built with 2.36.
#define DRAPE_HIDDEN extern "C" __attribute__((visibility("hidden")))

#if defined(__x86_64__) && defined(__GLIBC__) && __GLIBC_PREREQ(2, 35)

// The same function under its first name. glibc gave it another one when it stopped setting errno.
__asm__(".symver drape_first_hypot, hypot@GLIBC_2.2.5");
extern "C" double drape_first_hypot(double x, double y);
extern "C" double hypot(double x, double y) noexcept { return drape_first_hypot(x, y); }

// Of std::random_device.
DRAPE_HIDDEN std::uint32_t arc4random() noexcept {
  std::uint32_t number = 0;
  while (getrandom(&number, sizeof number, 0) != sizeof number) {
  }
  return number;
}

// Where the unwinder finds the tables of the code at an address, as it did before glibc had a function for
// it.
DRAPE_HIDDEN int _dl_find_object(void* code, dl_find_object* found) noexcept {
  struct Search {
    ElfW(Addr) code;
    dl_find_object* found;
  } search{reinterpret_cast<ElfW(Addr)>(code), found};
  const auto look = [](dl_phdr_info* object, std::size_t, void* to) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader gives addresses as numbers
    const auto pointer_to = [](ElfW(Addr) at) { return reinterpret_cast<void*>(at); };
    const Search& s = *static_cast<const Search*>(to);
    bool is_here = false;
    const ElfW(Phdr)* tables = nullptr;
    for (int k = 0; k < object->dlpi_phnum; ++k) {
      const ElfW(Phdr)& part = object->dlpi_phdr[k];
      const ElfW(Addr) begin = object->dlpi_addr + part.p_vaddr;
      if (part.p_type == PT_GNU_EH_FRAME) tables = &part;
      if (part.p_type != PT_LOAD || s.code < begin || s.code - begin >= part.p_memsz) continue;
      is_here = true;
      s.found->dlfo_map_start = pointer_to(begin);
      s.found->dlfo_map_end = pointer_to(begin + part.p_memsz);
    }
    if (!is_here || !tables) return 0;
    s.found->dlfo_flags = 0;
    s.found->dlfo_link_map = nullptr;
    s.found->dlfo_eh_frame = pointer_to(object->dlpi_addr + tables->p_vaddr);
    return 1;
  };
  return dl_iterate_phdr(look, &search) == 1 ? 0 : -1;
}

#endif
