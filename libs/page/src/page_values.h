#pragma once
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

inline kainjow::mustache::data flag(bool isSo) {
  using kainjow::mustache::data;
  return data(isSo ? data::type::bool_true : data::type::bool_false);
}

}  // namespace roomgraph::page_values
