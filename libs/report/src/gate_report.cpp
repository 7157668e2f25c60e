#include "roomgraph/report/gate_report.h"

#include <boost/algorithm/string/join.hpp>

#include "roomgraph/base/printable.h"
#include "roomgraph/base/sentence_text.h"
#include "roomgraph/base/sequences.h"
#include "roomgraph/base/utf8_text.h"
#include "roomgraph/base/xml_text.h"

namespace roomgraph {
namespace {

constexpr char kUnread[] = "it could not be read";

/** What the gate says of a run, or why it could not ask. */
struct TestCase {
  std::string name;
  std::vector<std::string> complaints;
  std::string skipped{};
};

/** The complaints are "run: what is wrong"; those of no run that is known stand below "gate". A map
 *  that could not be read fails, judged or not, as the call does. */
std::vector<TestCase> testCases(const Comparison& comparison) {
  const GateVerdict gate = comparison.gate.value_or(GateVerdict{});
  const auto isJudged = [&](const std::string& name) {
    return gate.candidates.empty() || contains(gate.candidates, name);
  };
  std::vector<TestCase> runs;
  for (const ComparedRun& run : comparison.runs)
    if (run.name != comparison.reference && isJudged(run.name)) runs.push_back({run.name, {}});
  for (const LeftOutRun& run : comparison.leftOut) {
    if (run.isOtherSite && !isJudged(run.name)) continue;
    TestCase& left = runs.emplace_back();
    left.name = run.name;
    (run.isOtherSite ? left.skipped : left.complaints.emplace_back()) = run.reason;
  }
  TestCase rest{"gate", {}};
  for (const std::string& line : gate.complaints) {
    TestCase* owner = &rest;
    for (TestCase& run : runs)
      if (line.rfind(run.name + ": ", 0) == 0) owner = &run;
    const std::size_t begin = owner == &rest ? 0 : owner->name.size() + 2;
    owner->complaints.push_back(line.substr(begin));
  }
  if (!rest.complaints.empty() || runs.empty()) runs.push_back(rest);
  return runs;
}

/** In a table of Markdown, as text and nothing else. */
std::string markdownText(const std::string& given) {
  std::string text;
  for (const char c : printable(utf8Text(given))) {
    if (std::string("\\`*_{}[]<>|#&").find(c) != std::string::npos) text += '\\';
    text += c;
  }
  return text;
}

/** In bold; all but the first complaint stand above the table. */
std::string verdictCell(const std::vector<std::string>& complaints) {
  if (complaints.empty()) return "passes";
  const std::size_t more = complaints.size() - 1;
  return "**" + markdownText(complaints.front()) + "**" +
         (more ? formatted(" and %zu more", more) : "");
}

std::string rowOf(const ComparedRun& run, const Comparison& comparison,
                  const std::vector<TestCase>& judged) {
  const RunScore score = run.score.value_or(RunScore());
  const std::string figures = run.score ? formatted("%.3f | %.3f to %.3f | %.0f (", score.mapError,
                                                    score.errorLow, score.errorHigh, score.score) +
                                              nameOf(comparison.certaintyOf(run)) + ")"
                                        : " - | - | - ";
  std::string verdict = "not judged";
  for (const TestCase& one : judged)
    if (comparison.gate && one.name == run.name) verdict = verdictCell(one.complaints);
  return "| " + (run.rank ? std::to_string(run.rank) : "-") + " | " + markdownText(run.name) +
         " | " + figures + " | " + verdict + " |\n";
}

/** One line: what the gate says of whom, or without a gate what this is. */
std::string headingOf(const Comparison& comparison) {
  if (!comparison.gate)
    return "## " + counted(comparison.runs.size(), "map", "maps") + " compared\n\n";
  constexpr std::size_t mostNames = 3;
  const GateVerdict& gate = *comparison.gate;
  const std::string names = listed(gate.candidates, mostNames);
  return std::string("## The gate ") + (gate.isPassed() ? "passes" : "fails") +
         (names.empty() ? "" : ": " + markdownText(names)) + "\n\n";
}

/** What stands in a test that does not pass. */
std::string resultOf(const TestCase& run) {
  if (run.complaints.empty()) return "<skipped message=\"" + xmlText(run.skipped) + "\"/>";
  return "<failure message=\"" + xmlText(boost::algorithm::join(run.complaints, "; ")) + "\"/>";
}

std::string junitOf(const std::vector<TestCase>& runs) {
  const auto failures = countIf(runs, [](const TestCase& run) { return !run.complaints.empty(); });
  const auto skipped = countIf(
      runs, [](const TestCase& run) { return run.complaints.empty() && !run.skipped.empty(); });
  const std::string counts =
      "tests=\"" + std::to_string(runs.size()) + "\" failures=\"" + std::to_string(failures) + "\"";
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                     ">\n <testsuite name=\"roomgraph\" " + counts + " errors=\"0\" skipped=\"" +
                     std::to_string(skipped) + "\">\n";
  for (const TestCase& run : runs) {
    text += "  <testcase classname=\"roomgraph\" name=\"" + xmlText(run.name) + "\"";
    if (run.complaints.empty() && run.skipped.empty())
      text += "/>\n";
    else
      text += ">\n   " + resultOf(run) + "\n  </testcase>\n";
  }
  return text + " </testsuite>\n</testsuites>\n";
}

}  // namespace

std::string gateJunit(const Comparison& comparison) { return junitOf(testCases(comparison)); }

std::string gateJunit(const std::vector<RunCheck>& checks, const std::vector<std::string>& unread) {
  std::vector<TestCase> runs;
  for (const RunCheck& check : checks) runs.push_back({check.name, check.complaints});
  for (const std::string& file : unread) runs.push_back({file, {kUnread}});
  return junitOf(runs);
}

std::string gateMarkdown(const std::vector<RunCheck>& checks,
                         const std::vector<std::string>& unread) {
  std::string text =
      "| run | self error [m] | seen twice | breaks | drawn twice | laid over others | gate |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const RunCheck& check : checks)
    text += "| " + markdownText(check.name) + " | " +
            (check.selfError ? formatted("%.3f", *check.selfError) : "-") +
            formatted(" | %.0f %% | ", 100 * check.seenTwice) +
            std::to_string(check.breaks.size()) + " | " + std::to_string(check.doubled.size()) +
            " | " + std::to_string(check.welded.size()) + " | " +
            (check.complaints.empty()
                 ? "passes"
                 : "**" + markdownText(boost::algorithm::join(check.complaints, "; ")) + "**") +
            " |\n";
  for (const std::string& file : unread)
    text += "| " + markdownText(file) + " | - | - | - | - | - | **" + kUnread + "** |\n";
  return text;
}

std::string gateMarkdown(const Comparison& comparison) {
  const std::vector<TestCase> judged = testCases(comparison);
  std::string text = headingOf(comparison);
  if (comparison.gate) {
    const GateVerdict& gate = *comparison.gate;
    const std::string asked = boost::algorithm::join(gate.asked, "; ");
    if (!asked.empty()) text += "Criteria: " + markdownText(asked) + ".\n\n";
    const std::vector<std::string>& lines = gate.isPassed() ? gate.margins : gate.complaints;
    for (const std::string& line : lines) text += "- " + markdownText(line) + "\n";
    if (!lines.empty()) text += "\n";
  }
  text += markdownText(comparison.verdict) + "\n\n";
  text +=
      "| rank | run | map error [m] | in 4 of 5 cases [m] | score | gate |\n"
      "|---|---|---|---|---|---|\n";
  for (const ComparedRun& run : comparison.runs) text += rowOf(run, comparison, judged);
  for (const LeftOutRun& run : comparison.leftOut)
    text += "| - | " + markdownText(run.name) +
            " | - | - | - | left out: " + markdownText(run.reason) + " |\n";
  return text;
}

}  // namespace roomgraph
