// What the runtime of the release build lacks in a library of Linux that is unloaded. Other compilers link a
// crtbeginS.o, which destroys the static objects of a library when it is closed. The one of `ziglang` does
// not, and a host crashed at its end, when it called their destructors where the library had been.
extern "C" {
extern void* __dso_handle;  // NOLINT(bugprone-reserved-identifier): the names are those of the C++ ABI
void __cxa_finalize(void* library);
}

__attribute__((destructor)) static void static_objects_destroy() { __cxa_finalize(&__dso_handle); }
