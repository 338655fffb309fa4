// Standard error of the command: messages, and one line below them that is rewritten.
#pragma once
#include <string>

namespace drape::command {

// Prints "error: ...", "warning: ...", one line each; the status line goes first.
void message_print(const char* kind, const std::string& sentence);

// Shows the text in place of the one before, cut to the width of the terminal.
void status_line_show(const std::string& text);
void status_line_erase();

// The first bytes of a text, `width` at most, without a part of a character.
std::string text_cut(const std::string& text, std::size_t width);

}  // namespace drape::command
