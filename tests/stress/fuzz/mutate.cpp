#include "mutate.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace drape::fuzz {
namespace {

constexpr const char* kNumbers[] = {"0",
                                    "-0",
                                    "-0.0",
                                    "1",
                                    "-1",
                                    "2",
                                    "3",
                                    "0.5",
                                    "1e-3",
                                    "1e-9",
                                    "1e-300",
                                    "1e-320",
                                    "5e-324",
                                    "1e4",
                                    "1e6",
                                    "1e9",
                                    "1e19",
                                    "1e300",
                                    "1e308",
                                    "1.7976931348623157e308",
                                    "1e309",
                                    "-1e309",
                                    "1e99999",
                                    "nan",
                                    "-nan",
                                    "inf",
                                    "-inf",
                                    "+inf",
                                    "127",
                                    "128",
                                    "255",
                                    "256",
                                    "32768",
                                    "65536",
                                    "2147483647",
                                    "2147483648",
                                    "-2147483648",
                                    "-2147483649",
                                    "4294967295",
                                    "4294967296",
                                    "9007199254740993",
                                    "9223372036854775807",
                                    "9223372036854775808",
                                    "-9223372036854775808",
                                    "18446744073709551615",
                                    "99999999999999999999999",
                                    "0x7fffffff",
                                    "0o17",
                                    "0b1",
                                    "1_000",
                                    ".5",
                                    "5.",
                                    "1e",
                                    "1e+",
                                    "00",
                                    "+1",
                                    "0.1.2",
                                    "1979-05-27",
                                    "07:32:00",
                                    "true",
                                    "\"1\"",
                                    "[]",
                                    "{}",
                                    "[1]",
                                    "null"};

constexpr const char* kPieces[] = {"\"",
                                   "'",
                                   "\"\"\"",
                                   "'''",
                                   "[",
                                   "]",
                                   "[[",
                                   "]]",
                                   "{",
                                   "}",
                                   "=",
                                   ",",
                                   ".",
                                   "#",
                                   "\\",
                                   "\\u0000",
                                   "\\ud800",
                                   "\\x",
                                   "\r",
                                   "\r\n",
                                   "\n",
                                   "\t",
                                   " ",
                                   "-",
                                   "/",
                                   "//",
                                   "../",
                                   "%",
                                   "%s%n",
                                   "\xEF\xBB\xBF",
                                   "\xFF",
                                   "\xC0\x80",
                                   "\xED\xA0\x80",
                                   "\xF4\x90\x80\x80",
                                   "\xC3",
                                   "\xE2\x82",
                                   "\xC2\x85",
                                   "\xE2\x80\xA8",
                                   "\x7F",
                                   "\x01",
                                   "\x1B[31m"};

bool of_number(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+'; }
bool of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
}

struct Span {
  std::size_t begin = 0, size = 0;
};

// The run of characters of one sort that begins at or after a random place.
template <class Sort>
Span run_of(Random& random, const std::string& text, Sort sort) {
  std::size_t at = random.below(text.size());
  while (at < text.size() && !sort(text[at])) ++at;
  while (at > 0 && at < text.size() && sort(text[at - 1])) --at;
  Span span{at, 0};
  while (at + span.size < text.size() && sort(text[at + span.size])) ++span.size;
  return span;
}

// One to four whole lines.
Span lines_of(Random& random, const std::string& text) {
  if (text.empty()) return {};
  const std::size_t at = random.below(text.size()), before = text.rfind('\n', at);
  Span span{before == std::string::npos ? 0 : before + (at != before), 0};
  std::size_t end = span.begin;
  for (std::size_t k = 1 + random.below(4); k > 0 && end < text.size(); --k)
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  span.size = end - span.begin;
  return span;
}

// From one bracket to the other that belongs to it, so that lists and tables move whole.
Span group_of(Random& random, const std::string& text) {
  std::size_t at = random.below(text.size());
  while (at < text.size() && text[at] != '[' && text[at] != '{') ++at;
  int depth = 0;
  for (std::size_t end = at; end < text.size(); ++end) {
    depth += text[end] == '[' || text[end] == '{';
    depth -= text[end] == ']' || text[end] == '}';
    if (depth == 0) return {at, end + 1 - at};
  }
  return {std::min(at, text.size()), 0};
}

std::string cut_out(const std::string& text, Span span) { return text.substr(span.begin, span.size); }

void number_replace(Random& random, std::string& text) {
  const Span at = run_of(random, text, of_number);
  if (at.size == 0) return;
  std::string fresh = odd_number(random);
  if (random.chance(3)) {  // near the old one
    const double factors[] = {-1, 0.1, 0.5, 0.999999, 1.000001, 2, 10, 1000};
    fresh = std::to_string(std::strtod(text.c_str() + at.begin, nullptr) * random.pick(factors));
  }
  text.replace(at.begin, at.size, fresh);
}

void piece_insert(Random& random, std::string& text) {
  const std::size_t at = random.below(text.size() + 1);
  if (random.chance(8)) text.insert(at, 1, '\0');
  else text.insert(at, random.pick(kPieces));
}

void deepen(Random& random, std::string& text) {
  const char* const opens[] = {"[", "{", "{a=", "{\"a\":", "a.", "[[", "\"", "("};
  const std::size_t counts[] = {2, 20, 255, 256, 257, 1000, 20000};
  const std::string open = random.pick(opens);
  std::string deep;
  for (std::size_t k = random.pick(counts); k > 0; --k) deep += open;
  if (random.chance(2)) deep += "1" + std::string(deep.size() / open.size(), open[0] == '[' ? ']' : '}');
  const Span at = random.chance(2) ? run_of(random, text, of_number) : Span{random.below(text.size() + 1), 0};
  text.replace(at.begin, at.size, deep);
}

void repeat(Random& random, std::string& text, Span span) {
  const std::size_t counts[] = {1, 1, 2, 10, 300, 3000};
  const std::string part = cut_out(text, span);
  std::string many;
  for (std::size_t k = random.pick(counts); k > 0 && many.size() < kMaxBytes; --k) many += part;
  text.insert(span.begin, many);
}

void text_damage(Random& random, std::string& text, const std::string& other) {
  const auto move = [&](Span to, Span from) { text.replace(to.begin, to.size, cut_out(other, from)); };
  switch (random.below(14)) {
    case 0:
    case 1:
    case 2:
      return number_replace(random, text);
    case 3:
      return piece_insert(random, text);
    case 4:
      return repeat(random, text, lines_of(random, text));
    case 5:
      return move(lines_of(random, text), {});
    case 6:
      return move({lines_of(random, text).begin, 0}, lines_of(random, other));
    case 7:
      return move(lines_of(random, text), lines_of(random, other));
    case 8:
      return move(run_of(random, text, of_word), run_of(random, other, of_word));
    case 9:
      return move(group_of(random, text), group_of(random, other));
    case 10:
      return repeat(random, text, group_of(random, text));
    case 11:
      return repeat(random, text, run_of(random, text, of_word));
    case 12:
      return void(text.erase(random.below(text.size()), 1 + random.below(8)));
    default:
      return random.chance(4) ? deepen(random, text) : number_replace(random, text);
  }
}

void word_strike(Random& random, std::string& bytes) {
  if (bytes.size() < 4) return;
  const std::uint32_t words[] = {0,          1,          2,          3,
                                 0x7f800000, 0xff800000, 0x7fc00000, 0x7f7fffff,
                                 0x00000001, 0x7fffffff, 0x80000000, 0xffffffff,
                                 0x3f800000, 0xbf800000, 0x05f5e100, std::uint32_t(random.engine())};
  const std::uint32_t word = random.pick(words);
  // The count and the coordinates of STL are at 80 + 4 k, shifted by 2 a facet.
  const std::size_t at =
      random.chance(4) ? std::min<std::size_t>(80, bytes.size() - 4) : random.below(bytes.size() - 3);
  std::memcpy(bytes.data() + at, &word, 4);
}

void bytes_damage(Random& random, std::string& bytes, const std::string& other) {
  const std::size_t at = random.below(bytes.size() + 1);
  switch (random.below(5)) {
    case 0:
    case 1:
      return word_strike(random, bytes);
    case 2:
      return void(bytes.insert(at, other.substr(random.below(other.size() + 1), random.below(200))));
    case 3:
      return void(bytes.erase(at, 1 + random.below(100)));
    default:
      return piece_insert(random, bytes);
  }
}

}  // namespace

const char* odd_number(Random& random) { return random.pick(kNumbers); }

double odd_value(Random& random) {
  using Limits = std::numeric_limits<double>;
  const double values[] = {0,
                           -0.0,
                           1,
                           -1,
                           0.5,
                           2,
                           1e-300,
                           Limits::denorm_min(),
                           1e300,
                           Limits::max(),
                           Limits::lowest(),
                           Limits::infinity(),
                           -Limits::infinity(),
                           Limits::quiet_NaN(),
                           1e4,
                           -1e4,
                           1e6,
                           1e-9,
                           64,
                           65};
  return random.pick(values);
}

std::string mutate(Random& random, const std::vector<std::string>& corpus, Form form) {
  std::string bytes = random.pick(corpus);
  for (std::size_t k = 1 + random.below(random.chance(2) ? 3 : 8); k > 0; --k) {
    const std::string& other = random.pick(corpus);
    if (bytes.empty()) bytes = other;
    const std::size_t at = random.below(bytes.size() + 1);
    switch (random.below(20)) {
      case 0:
        bytes.resize(at);
        break;
      case 1:
        bytes = bytes.substr(0, at) + other.substr(random.below(other.size() + 1));
        break;
      case 2:
        if (at < bytes.size()) bytes[at] = char(bytes[at] ^ (1 << random.below(8)));
        break;
      default:
        if (form == Form::kText) text_damage(random, bytes, other);
        else bytes_damage(random, bytes, other);
    }
  }
  if (bytes.size() > kMaxBytes) bytes.resize(kMaxBytes);
  return bytes;
}

}  // namespace drape::fuzz
