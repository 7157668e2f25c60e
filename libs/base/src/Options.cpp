#include "roomgraph/base/Options.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "roomgraph/base/Error.h"
#include "roomgraph/base/sentence_text.h"

namespace roomgraph {
namespace {

template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

template <class Number>
bool assignNumber(const Field& field, const std::string& text, Number& target) {
  Number value{};
  // Written so that NaN is refused, too.
  if (!parseNumber(text, value) || !(value >= field.low && value <= field.high)) return false;
  target = value;
  return true;
}

bool assignFlag(const std::string& text, bool& target) {
  const bool isOn = text == "true" || text == "on" || text == "1";
  if (!isOn && text != "false" && text != "off" && text != "0") return false;
  target = isOn;
  return true;
}

bool assign(const Field& field, const std::string& text) {
  return std::visit(Overload{[&](double* value) { return assignNumber(field, text, *value); },
                             [&](int* value) { return assignNumber(field, text, *value); },
                             [&](bool* value) { return assignFlag(text, *value); },
                             [&](std::string* value) {
                               const auto& known = field.choices;
                               if (std::find(known.begin(), known.end(), text) == known.end())
                                 return false;
                               *value = text;
                               return true;
                             }},
                    field.value);
}

/** What was meant, if that can be guessed. */
std::string wayOut(const std::string& typed, const std::vector<std::string>& words) {
  const std::string meant = nearestWord(typed, words);
  return meant.empty() ? "see 'roomgraph config'" : "did you mean '" + meant + "'?";
}

}  // namespace

void FieldTable::number(const char* section, const char* name, double& value, const char* unit,
                        double low, double high, const char* sentence) {
  fields_.push_back({section, name, unit, low, high, sentence, &value, {}});
}

void FieldTable::count(const char* section, const char* name, int& value, int low, int high,
                       const char* sentence) {
  fields_.push_back({section, name, "", double(low), double(high), sentence, &value, {}});
}

void FieldTable::flag(const char* section, const char* name, bool& value, const char* sentence) {
  fields_.push_back({section, name, "", 0, 0, sentence, &value, {}});
}

void FieldTable::choice(const char* section, const char* name, std::string& value,
                        std::vector<std::string> choices, const char* sentence) {
  fields_.push_back({section, name, "", 0, 0, sentence, &value, std::move(choices)});
}

void FieldTable::set(const std::string& section, const std::string& key, const std::string& value) {
  std::vector<std::string> sections, keys;
  for (const Field& field : fields_) {
    sections.push_back(field.section);
    if (field.section != section) continue;
    keys.push_back(field.name);
    if (field.name != key) continue;
    if (assign(field, value)) return;
    throw UsageError("[" + section + "] " + key + " = " + value + " is not allowed: use " +
                     rangeText(field));
  }
  if (keys.empty())
    throw UsageError("there is no section [" + section + "]: " + wayOut(section, sections));
  throw UsageError("[" + section + "] has no key '" + key + "': " + wayOut(key, keys));
}

std::string valueText(const Field& field) {
  return std::visit(
      Overload{[](const double* value) { return numberText(*value); },
               [](const int* value) { return numberText(*value); },
               [](const bool* value) { return std::string(*value ? "true" : "false"); },
               [](const std::string* value) { return *value; }},
      field.value);
}

std::string rangeText(const Field& field) {
  if (std::holds_alternative<bool*>(field.value)) return "true or false";
  if (!field.choices.empty()) return alternatives(field.choices);
  const std::string unit = field.unit.empty() ? "" : " " + field.unit;
  return numberText(field.low) + " to " + numberText(field.high) + unit;
}

std::string toIni(const FieldTable& table) {
  std::ostringstream out;
  std::string section;
  for (const Field& field : table.fields()) {
    if (field.section != section) {
      out << (section.empty() ? "" : "\n") << "[" << field.section << "]\n";
      section = field.section;
    }
    out << "# " << field.sentence << " (" << rangeText(field) << ")\n";
    out << field.name << " = " << valueText(field) << "\n";
  }
  return out.str();
}

void fromIni(const std::string& text, const std::string& name, FieldTable& table) {
  std::istringstream in(text);
  std::string line, section;
  std::set<std::string> seen;
  for (int number = 1; std::getline(in, line); ++number) {
    const std::string place = name + ":" + std::to_string(number) + ": ";
    line = trimmed(line.substr(0, line.find_first_of("#;")));
    if (line.empty()) continue;
    if (line.front() == '[' && line.back() == ']') {
      section = trimmed(line.substr(1, line.size() - 2));
      continue;
    }
    const auto equals = line.find('=');
    if (equals == std::string::npos)
      throw UsageError(place + "'" + line + "' is neither [section] nor key = value");
    const std::string key = trimmed(line.substr(0, equals));
    if (!seen.insert(section + "/" + key).second)
      throw UsageError(place + "[" + section + "] " + key + " is set twice");
    try {
      table.set(section, key, trimmed(line.substr(equals + 1)));
    } catch (const UsageError& error) {
      throw UsageError(place + error.what());
    }
  }
}

}  // namespace roomgraph
