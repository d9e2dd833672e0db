#include "semantic_slam/object_mapping/object_map_file.h"

#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"

namespace semantic_slam {
namespace {

using Json = nlohmann::ordered_json;

// To a tenth of a millimetre: more digits are none of the measurement's.
double Rounded(double metres) {
  return std::round(metres * 1e4) / 1e4;
}

template <typename Vector>
Json ToJson(const Vector& vector) {
  Json numbers = Json::array();
  for (int i = 0; i < vector.size(); ++i) numbers.push_back(Rounded(vector[i]));
  return numbers;
}

Json CovarianceToJson(const Eigen::Matrix3d& covariance) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back({covariance(row, 0), covariance(row, 1), covariance(row, 2)});
  }
  return rows;
}

Json LabelsToJson(const MapObject& object, const LabelVocabulary& vocabulary) {
  Json labels = Json::object();
  for (const LabelProbability& label : object.labels) {
    labels[vocabulary[label.label].name] = label.probability;
  }
  return labels;
}

Json ToJson(const MapObject& object, const LabelVocabulary& vocabulary) {
  const Eigen::Matrix3d R = object.T_map_box.linear();
  Json json;
  json["id"] = object.id;
  json["class"] = vocabulary[object.labels.front().label].name;
  json["probabilities"] = LabelsToJson(object, vocabulary);
  json["position_m"] = ToJson(object.position_m);
  json["position_covariance_m2"] = CovarianceToJson(object.position_covariance_m2);
  json["box"] = {{"centre_m", ToJson(Eigen::Vector3d(object.T_map_box.translation()))},
                 {"size_m", ToJson(object.box_size_m)},
                 {"yaw_rad", Rounded(std::atan2(R(1, 0), R(0, 0)))}};
  json["min_height_m"] = Rounded(object.min_height_m);
  json["max_height_m"] = Rounded(object.max_height_m);
  json["hollow"] = ToString(object.hollow);
  json["footprint_m"] = Json::array();
  for (const Eigen::Vector2d& corner : object.footprint_m)
    json["footprint_m"].push_back(ToJson(corner));
  json["observations"] = object.observations;
  json["last_seen_s"] = semantic_slam::ToString(object.last_seen);
  return json;
}

template <typename Vector>
Vector VectorFrom(const Json& json) {
  Vector vector;
  if (json.size() != static_cast<std::size_t>(vector.size())) throw InputError("a vector of another length");
  for (int i = 0; i < vector.size(); ++i) vector[i] = json.at(i).get<double>();
  return vector;
}

Stamp StampFrom(const Json& json) {
  const auto stamp = Stamp::Parse(json.get<std::string>());
  if (!stamp) throw InputError("a stamp that is not seconds");
  return *stamp;
}

Hollowness HollownessFrom(const Json& json) {
  for (const auto hollow : {Hollowness::kNo, Hollowness::kPartly, Hollowness::kFull}) {
    if (json == ToString(hollow)) return hollow;
  }
  throw InputError("an unknown hollowness");
}

std::vector<LabelProbability> LabelsFrom(const Json& json, const LabelVocabulary& vocabulary) {
  std::vector<LabelProbability> labels;
  for (const auto& [name, probability] : json.items()) {
    const auto label = vocabulary.Find(name);
    if (!label) throw InputError("a class that is not in it, " + name);
    labels.push_back({*label, probability.get<float>()});
  }
  if (labels.empty()) throw InputError("an object without a class");
  return labels;
}

MapObject ObjectFrom(const Json& json, const LabelVocabulary& vocabulary) {
  MapObject object;
  object.id = json.at("id").get<ObjectId>();
  object.labels = LabelsFrom(json.at("probabilities"), vocabulary);
  object.position_m = VectorFrom<Eigen::Vector3d>(json.at("position_m"));
  for (int row = 0; row < 3; ++row) {
    object.position_covariance_m2.row(row) =
        VectorFrom<Eigen::Vector3d>(json.at("position_covariance_m2").at(row));
  }
  const Json& box = json.at("box");
  object.T_map_box = Eigen::Translation3d(VectorFrom<Eigen::Vector3d>(box.at("centre_m"))) *
                     Eigen::AngleAxisd(box.at("yaw_rad").get<double>(), Eigen::Vector3d::UnitZ());
  object.box_size_m = VectorFrom<Eigen::Vector3d>(box.at("size_m"));
  object.min_height_m = json.at("min_height_m").get<double>();
  object.max_height_m = json.at("max_height_m").get<double>();
  object.hollow = HollownessFrom(json.at("hollow"));
  for (const Json& corner : json.at("footprint_m")) {
    object.footprint_m.push_back(VectorFrom<Eigen::Vector2d>(corner));
  }
  object.observations = json.at("observations").get<int>();
  object.last_seen = StampFrom(json.at("last_seen_s"));
  return object;
}

}  // namespace

const char* ToString(Hollowness hollowness) {
  switch (hollowness) {
    case Hollowness::kNo:
      return "no";
    case Hollowness::kPartly:
      return "partly";
    case Hollowness::kFull:
      return "full";
  }
  return "no";
}

void WriteObjectMap(const std::string& path, const ObjectMap& map,
                    const LabelVocabulary& vocabulary) {
  Json json;
  json["stamp_s"] = ToString(map.stamp);
  json["map_id"] = map.map_id;
  json["revision"] = map.revision;
  json["label_set_hash"] = map.vocabulary_hash;
  json["objects"] = Json::array();
  for (const MapObject& object : map.objects) json["objects"].push_back(ToJson(object, vocabulary));
  WriteFileAtomically(path, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
}

ObjectMap ReadObjectMap(const std::string& path, const LabelVocabulary& vocabulary) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot open object map " + path);
  try {
    const Json json = Json::parse(file);
    ObjectMap map;
    map.stamp = StampFrom(json.at("stamp_s"));
    map.map_id = json.at("map_id").get<int>();
    map.revision = json.at("revision").get<std::uint64_t>();
    map.vocabulary_hash = json.at("label_set_hash").get<std::uint64_t>();
    CheckLabelSet("object map", map.vocabulary_hash, vocabulary);
    for (const Json& object : json.at("objects"))
      map.objects.push_back(ObjectFrom(object, vocabulary));
    return map;
  } catch (const nlohmann::json::exception& e) {
    throw InputError(path + " is no object map: " + e.what());
  } catch (const InputError& e) {
    throw InputError(path + " is no object map of this label set: " + e.what());
  }
}

}  // namespace semantic_slam
