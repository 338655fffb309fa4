#include "command/status_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace drape::command {
namespace {

std::size_t shown = 0;  // bytes of the line that stands there: there is one standard error

// One less than the columns: in the last one some terminals begin a new line.
std::size_t line_width() {
  constexpr std::size_t kUsual = 79;
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1u : kUsual;
}

}  // namespace

std::string text_cut(const std::string& text, std::size_t width) {
  if (text.size() <= width) return text;
  while (width > 0 && (static_cast<unsigned char>(text[width]) & 0xC0) == 0x80)
    --width;  // within a character
  return text.substr(0, width);
}

// Blanks rather than an escape sequence, which some terminals print.
void status_line_show(const std::string& text) {
  const std::string line = text_cut(text, line_width());
  const std::string rest(shown > line.size() ? shown - line.size() : 0, ' ');
  std::fprintf(stderr, "\r%s%s", line.c_str(), rest.c_str());
  std::fflush(stderr);
  shown = line.size();
}

void status_line_erase() {
  if (shown == 0) return;
  status_line_show("");
  std::fputc('\r', stderr);
}

void message_print(const char* kind, const std::string& sentence) {
  status_line_erase();
  std::fprintf(stderr, "%s: %s\n", kind, sentence.c_str());
}

}  // namespace drape::command
