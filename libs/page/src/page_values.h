#pragma once
#include <cstddef>
#include <string>

#include "kainjow/mustache.hpp"
#include "roomgraph/base/utf8_text.h"

/** Values for the page's template. */
namespace roomgraph::page_values {

/** Any text, as UTF-8. */
inline kainjow::mustache::data text(const std::string& value) {
  return kainjow::mustache::data(utf8Text(value));
}

/** An empty list. */
inline kainjow::mustache::data list() {
  return kainjow::mustache::data(kainjow::mustache::data::type::list);
}

/** A list with what `toRow` makes of each thing and its place, in their order. */
template <class Things, class ToRow>
kainjow::mustache::data rowsOf(const Things& things, const ToRow& toRow) {
  kainjow::mustache::data rows = list();
  std::size_t place = 0;
  for (const auto& thing : things) rows << toRow(thing, place++);
  return rows;
}

inline kainjow::mustache::data flag(bool isSo) {
  using kainjow::mustache::data;
  return data(isSo ? data::type::bool_true : data::type::bool_false);
}

}  // namespace roomgraph::page_values
