#pragma once
#include "kainjow/mustache.hpp"
#include "roomgraph/base/Json.h"
#include "roomgraph/base/utf8_text.h"

namespace roomgraph {

/** Objects, lists, flags and texts, any text as UTF-8, as a template takes them. */
inline kainjow::mustache::data mustacheValues(const Json& value) {
  using kainjow::mustache::data;
  if (value.is_string()) return data(utf8Text(value.get<std::string>()));
  if (value.is_boolean()) return data(value ? data::type::bool_true : data::type::bool_false);
  data values(value.is_array() ? data::type::list : data::type::object);
  for (const auto& [key, one] : value.items())
    if (value.is_array())
      values << mustacheValues(one);
    else
      values.set(key, mustacheValues(one));
  return values;
}

}  // namespace roomgraph
