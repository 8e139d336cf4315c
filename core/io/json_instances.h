// Parts of nlohmann's JSON that nearly every unit that uses it would instantiate, a third of its
// code: declared in precompiled headers, so that json_instances.cpp alone compiles them. Sources
// include <nlohmann/json.hpp> and need not know; without precompiled headers each has its own.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#ifdef TRIVET_JSON_INSTANCES
#define TRIVET_INSTANCE template
#else
#define TRIVET_INSTANCE extern template
#endif

// Texts parsed and written.
#define TRIVET_JSON_INSTANCE(Json)                                                   \
  TRIVET_INSTANCE class nlohmann::detail::serializer<Json>;                          \
  TRIVET_INSTANCE class nlohmann::detail::json_sax_dom_parser<Json>;                 \
  TRIVET_INSTANCE class nlohmann::detail::json_sax_dom_callback_parser<Json>;        \
  TRIVET_INSTANCE class nlohmann::detail::lexer<                                     \
      Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>;  \
  TRIVET_INSTANCE class nlohmann::detail::parser<                                    \
      Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>;  \
  TRIVET_INSTANCE bool nlohmann::detail::parser<                                     \
      Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>:: \
      sax_parse_internal(nlohmann::detail::json_sax_dom_parser<Json>*);              \
  TRIVET_INSTANCE bool nlohmann::detail::parser<                                     \
      Json, nlohmann::detail::iterator_input_adapter<std::string::const_iterator>>:: \
      sax_parse_internal(nlohmann::detail::json_sax_dom_callback_parser<Json>*);

TRIVET_INSTANCE class nlohmann::basic_json<>;
TRIVET_INSTANCE class nlohmann::basic_json<nlohmann::ordered_map>;
TRIVET_JSON_INSTANCE(nlohmann::json)
TRIVET_JSON_INSTANCE(nlohmann::ordered_json)
