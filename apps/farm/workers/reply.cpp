#include "apps/farm/workers/reply.h"

#include "ops/files/json/text.h"

namespace trivet::farm {
namespace {

using Cbor = nlohmann::json;

Cbor members_cbor(const SceneMembers& members) {
  Cbor more = Cbor::array();
  for (const Member& member : members.more)
    more.push_back({member.name, Cbor::binary({member.bytes.begin(), member.bytes.end()})});
  return {{"scene", json_line(members.scene)}, {"more", std::move(more)}};
}

SceneMembers members_from(const Cbor& cbor) {
  SceneMembers out{Json::parse(cbor.at("scene").get_ref<const std::string&>()), {}};
  for (const Cbor& member : cbor.at("more")) {
    const auto& bytes = member.at(1).get_binary();
    out.more.push_back({member.at(0).get<std::string>(), {bytes.begin(), bytes.end()}});
  }
  return out;
}

}  // namespace

void SceneWork::add(const SceneWork& other) {
  queries += other.queries;
  early += other.early;
  draws += other.draws;
  read_backs += other.read_backs;
}

std::string to_bytes(const WorkerReply& reply) {
  Cbor cbor = reply.members ? members_cbor(*reply.members)
                            : Cbor{{"error", reply.error}, {"fatal", reply.is_fatal}};
  cbor["k"] = reply.k;
  cbor["notes"] = reply.notes;
  const SceneWork& work = reply.work;
  cbor["work"] = {work.queries, work.early, work.draws, work.read_backs};
  const std::vector<std::uint8_t> bytes = Cbor::to_cbor(cbor);
  return {bytes.begin(), bytes.end()};
}

std::optional<WorkerReply> reply_from(const std::string& bytes) {
  try {
    const Cbor cbor = Cbor::from_cbor(bytes);
    WorkerReply out;
    out.k = cbor.at("k");
    out.notes = cbor.at("notes").get<std::vector<std::string>>();
    const Cbor& work = cbor.at("work");
    out.work = {work.at(0), work.at(1), work.at(2), work.at(3)};
    if (cbor.contains("scene"))
      out.members = members_from(cbor);
    else
      out.error = cbor.at("error"), out.is_fatal = cbor.at("fatal");
    return out;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace trivet::farm
