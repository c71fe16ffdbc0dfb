#include "reports/mathml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "reports/markup.hpp"

namespace odemark {

namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 24> greek{
    {{"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"eps", "ε"},    {"epsilon", "ε"},
     {"zeta", "ζ"},  {"eta", "η"},  {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},
     {"nu", "ν"},    {"xi", "ξ"},   {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},
     {"phi", "φ"},   {"chi", "χ"},  {"psi", "ψ"},   {"omega", "ω"}, {"Delta", "Δ"},  {"Omega", "Ω"}}};
constexpr std::array<std::string_view, 20> functions{"sin",  "cos",  "tan",   "exp",  "log",   "sinh", "cosh",
                                                     "tanh", "asin", "acos",  "atan", "atan2", "abs",  "min",
                                                     "max",  "sign", "floor", "mod",  "asinh", "cross"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string greek_or_same(std::string_view name) {
  for (const auto& [word, letter] : greek)
    if (word == name) return std::string(letter);
  return std::string(name);
}
bool is_greek(std::string_view name) { return greek_or_same(name) != name; }

class Setter {
 public:
  Setter(std::string_view text, const std::vector<std::string>& names) : text_(text), names_(names) {}

  /// Everything up to `closing` (which is not taken) or the end of the equation.
  std::string row(char closing) {
    std::string out;
    for (;;) {
      skip_blanks();
      if (at_ >= text_.size() || text_[at_] == closing) return out;
      Piece piece = factor(closing);
      while (next() == '/' && ahead(1) != '\0') {
        ++at_;
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] == closing) {
          piece.whole += "<mo>/</mo>";
          break;
        }
        const Piece below = factor(closing);
        piece.whole =
            fmt::format("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>", piece.inside, below.inside);
        piece.inside = piece.whole;
      }
      out += piece.whole;
    }
  }

 private:
  struct Piece {
    std::string whole,
        inside;  // inside: without the parentheses around it, where a fraction makes them needless
  };

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  char next() {
    skip_blanks();
    return ahead(0);
  }
  char ahead(std::size_t by) const { return at_ + by < text_.size() ? text_[at_ + by] : '\0'; }

  /// An atom with its primes and its power.
  Piece factor(char closing) {
    Piece piece = atom();
    std::string primes;
    for (; ahead(0) == '\''; ++at_) primes += "′";
    if (!primes.empty())
      piece.whole = piece.inside =
          fmt::format("<msup><mrow>{}</mrow><mo>{}</mo></msup>", piece.whole, primes);
    if (ahead(0) == '^' && ahead(1) != '\0' && ahead(1) != ' ' && ahead(1) != closing) {
      ++at_;
      const std::string sign = ahead(0) == '-' ? (++at_, "<mo>−</mo>") : "";
      const std::string power = sign + (at_ < text_.size() ? atom().inside : "");
      piece.whole = piece.inside =
          fmt::format("<msup><mrow>{}</mrow><mrow>{}</mrow></msup>", piece.whole, power);
    }
    return piece;
  }

  Piece atom() {
    const char c = text_[at_];
    if (is_digit(c) || (c == '.' && is_digit(ahead(1)))) return number();
    if (is_letter(c)) return word();
    if (c == '(') return group(')', "(", ")");
    if (c == '|' && !in_bars_) {
      in_bars_ = true;
      Piece bars = group('|', "|", "|");
      in_bars_ = false;
      bars.inside = bars.whole;
      return bars;
    }
    return sign();
  }

  Piece same(std::string text) { return {text, text}; }

  Piece number() {
    const std::size_t begin = at_;
    while (is_digit(ahead(0)) || (ahead(0) == '.' && is_digit(ahead(1)))) ++at_;
    if (ahead(0) == 'e' && (is_digit(ahead(1)) || (ahead(1) == '-' && is_digit(ahead(2)))))
      for (at_ += 2; is_digit(ahead(0));) ++at_;
    return same(fmt::format("<mn>{}</mn>", text_.substr(begin, at_ - begin)));
  }

  Piece word() {
    const std::size_t begin = at_;
    while (is_letter(ahead(0)) || is_digit(ahead(0)) ||
           (ahead(0) == '_' && (is_letter(ahead(1)) || is_digit(ahead(1)))))
      ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    if (name == "sqrt" && ahead(0) == '(') {
      const Piece under = group(')', "(", ")");
      return same(fmt::format("<msqrt><mrow>{}</mrow></msqrt>", under.inside));
    }
    const bool known = std::find(names_.begin(), names_.end(), name) != names_.end();
    if (std::find(functions.begin(), functions.end(), name) != functions.end() && !known)
      return same(fmt::format("<mi>{}</mi><mo>&#x2061;</mo>", name));
    const std::size_t letters = std::size_t(
        std::find_if(name.begin(), name.end(), [](char c) { return !is_letter(c); }) - name.begin());
    const std::string_view stem = name.substr(0, letters);
    std::string_view rest = name.substr(letters);
    if (!known && letters == name.size() && letters >= 2 && !is_greek(name))
      return same(fmt::format("<mtext>&#xA0;{}&#xA0;</mtext>", name));
    if (rest.starts_with('_')) rest.remove_prefix(1);
    if (rest.empty()) return same(fmt::format("<mi>{}</mi>", greek_or_same(stem)));
    return same(fmt::format("<msub><mi>{}</mi><mi>{}</mi></msub>", greek_or_same(stem), rest));
  }

  Piece group(char closing, std::string_view open, std::string_view close) {
    ++at_;
    if (++depth_ > 40) return --depth_, same(fmt::format("<mo>{}</mo>", open));
    const std::string content = row(closing);
    --depth_;
    if (at_ >= text_.size()) return same(fmt::format("<mo>{}</mo>{}", open, content));
    ++at_;
    return {fmt::format("<mrow><mo>{}</mo>{}<mo>{}</mo></mrow>", open, content, close), content};
  }

  Piece sign() {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> longer{{{"...", "…"},
                                                                                   {"->", "→"},
                                                                                   {"<=", "≤"},
                                                                                   {">=", "≥"},
                                                                                   {"!=", "≠"},
                                                                                   {"+-", "±"},
                                                                                   {"-", "−"},
                                                                                   {"*", "·"},
                                                                                   {"'", "′"}}};
    for (const auto& [from, to] : longer)
      if (text_.substr(at_).starts_with(from)) {
        at_ += from.size();
        return same(fmt::format("<mo>{}</mo>", to));
      }
    std::size_t length = 1;  // a character of several bytes stays whole
    while ((static_cast<unsigned char>(ahead(length)) & 0xC0) == 0x80) ++length;
    const std::string_view character = text_.substr(at_, length);
    at_ += length;
    return same(fmt::format("<mo>{}</mo>", escaped(character)));
  }

  std::string_view text_;
  const std::vector<std::string>& names_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool in_bars_ = false;
};

}  // namespace

std::string to_mathml(std::string_view equations, const std::vector<std::string>& names) {
  std::string rows;
  while (!equations.empty()) {
    const std::size_t end = std::min(equations.find(';'), equations.size());
    const std::string row = Setter(equations.substr(0, end), names).row('\0');
    if (!row.empty()) rows += fmt::format("<mtr><mtd columnalign=\"left\"><mrow>{}</mrow></mtd></mtr>", row);
    equations.remove_prefix(std::min(end + 1, equations.size()));
  }
  return fmt::format("<math display=\"block\"><mtable>{}</mtable></math>", rows);
}

}  // namespace odemark
