#include "semantic_slam/object_mapping/object_map_file.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/atomic_file.h"

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

}  // namespace semantic_slam
