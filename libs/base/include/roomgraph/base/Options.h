#pragma once
#include <string>
#include <variant>
#include <vector>

namespace roomgraph {

/** One setting: where its value lives and all that is said about it, in one place.
 *  Loading, saving, checking, help and documents are made from this. The default is not here: it is
 *  the initialiser of the member that `value` points to. */
struct Field {
  std::string section;       ///< the step that reads it, as in its file name
  std::string name;          ///< snake_case
  std::string unit;          ///< "m", "m2", "px2", "rad", "" for none
  double low = 0, high = 0;  ///< closed range of numbers; unused for switches and choices
  std::string sentence;      ///< what it does, one sentence
  std::variant<double*, int*, bool*, std::string*> value;  ///< where it is kept
  std::vector<std::string> choices;                        ///< the legal values of a string
};

/** The settings of all steps, in pipeline order. Points into an options object that must outlive
 *  it. */
class FieldTable {
 public:
  void number(const char* section, const char* name, double& value, const char* unit, double low,
              double high, const char* sentence);
  void count(const char* section, const char* name, int& value, int low, int high,
             const char* sentence);
  void flag(const char* section, const char* name, bool& value, const char* sentence);
  void choice(const char* section, const char* name, std::string& value,
              std::vector<std::string> choices, const char* sentence);

  const std::vector<Field>& fields() const { return fields_; }

  /** Sets one field from text. Throws UsageError naming section, key, value and range. */
  void set(const std::string& section, const std::string& key, const std::string& value);

 private:
  std::vector<Field> fields_;
};

/** The value as the ini file and the JSON write it: shortest text that reads back equal. */
[[nodiscard]] std::string valueText(const Field& field);
/** For people: "0.1 to 10 m", "on or off", "a, b or c". */
[[nodiscard]] std::string rangeText(const Field& field);

/** The whole table as a commented ini file. */
[[nodiscard]] std::string toIni(const FieldTable& table);

/** Sets every key that the text names; the others keep their value.
 *  `name` is the file's name for messages. Throws UsageError for an unknown section or key, a
 *  value out of range, a key set twice, or a line that is neither section, key nor comment. */
void fromIni(const std::string& text, const std::string& name, FieldTable& table);

}  // namespace roomgraph
