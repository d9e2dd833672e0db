#include "semantic_slam/worlds/sdf_world.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iomanip>
#include <locale>
#include <map>
#include <sstream>

namespace semantic_slam {
namespace {

constexpr double kWaypointPeriod_s = 0.2;  // of actors; Gazebo lays a spline through them
constexpr double kLampRangeM = 12.0;

// Six decimals; not "-0.000000".
double Rounded(double value) {
  return std::round(1e6 * value) / 1e6 + 0.0;
}

// Numbers as they stand in SDF.
template <typename... Values>
std::string Numbers(const Values&... values) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(6);
  const char* separator = "";
  ((text << separator << Rounded(values), separator = " "), ...);
  return text.str();
}

std::string Colour(const std::array<float, 3>& rgb) {
  const auto limited = [&](int i) { return std::clamp(rgb[i], 0.0f, 1.0f); };
  return Numbers(limited(0), limited(1), limited(2), 1.0f);
}

// Indented XML. What is written needs no escapes: names are those of ModelNames(), the rest numbers
// and words of this file.
class XmlText {
 public:
  // Opens an element that ends with Close(). `attributes` as in name="a".
  void Open(const std::string& tag, const std::string& attributes = "") {
    Indent() << '<' << tag << (attributes.empty() ? "" : " ") << attributes << ">\n";
    open_.push_back(tag);
  }

  void Close() {
    const std::string tag = open_.back();
    open_.pop_back();
    Indent() << "</" << tag << ">\n";
  }

  void Leaf(const std::string& tag, const std::string& content) {
    Indent() << '<' << tag << '>' << content << "</" << tag << ">\n";
  }

  std::string str() const {
    assert(open_.empty());
    return "<?xml version=\"1.0\"?>\n" + text_.str();
  }

 private:
  std::ostream& Indent() { return text_ << std::string(2 * open_.size(), ' '); }

  std::ostringstream text_;
  std::vector<std::string> open_;
};

std::string Named(const std::string& name) {
  return "name=\"" + name + "\"";
}

std::string ValidName(const std::string& name) {
  std::string valid = name;
  for (char& c : valid) {
    const bool is_plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!is_plain && c != '-') c = '_';
  }
  // SDF keeps names that begin with two underscores for itself.
  return valid.empty() || valid.front() == '_' ? "object" + valid : valid;
}

void WritePhysics(XmlText& xml) {
  xml.Leaf("gravity", "0 0 -9.81");
  xml.Open("physics", "name=\"ode\" default=\"true\" type=\"ode\"");
  xml.Leaf("max_step_size", "0.001");
  xml.Leaf("real_time_factor", "1");
  xml.Leaf("real_time_update_rate", "1000");
  xml.Close();
}

void WriteScene(XmlText& xml, const World& world) {
  xml.Open("scene");
  xml.Leaf("ambient", Colour(world.ambient_rgb));
  xml.Leaf("background", Numbers(0.7, 0.8, 0.9, 1.0));
  xml.Leaf("shadows", "true");
  xml.Close();
}

void WriteSun(XmlText& xml) {
  xml.Open("light", Named("light__sun") + " type=\"directional\"");
  xml.Leaf("pose", "0 0 20 0 0 0");
  xml.Leaf("diffuse", Numbers(0.6, 0.6, 0.55, 1.0));
  xml.Leaf("specular", Numbers(0.1, 0.1, 0.1, 1.0));
  xml.Leaf("direction", Numbers(-0.4, 0.3, -0.87));
  xml.Leaf("cast_shadows", "true");  // so that the ceiling keeps it out
  xml.Close();
}

// Falls off with the square of the distance, but not without limit near the lamp; as bright 2 m
// below as Light says.
void WriteAttenuation(XmlText& xml) {
  xml.Open("attenuation");
  xml.Leaf("range", Numbers(kLampRangeM));
  xml.Leaf("constant", "0.2");
  xml.Leaf("linear", "0");
  xml.Leaf("quadratic", "0.2");
  xml.Close();
}

void WriteLamps(XmlText& xml, const World& world) {
  for (std::size_t i = 0; i < world.lights.size(); ++i) {
    const Light& light = world.lights[i];
    xml.Open("light", Named("light__" + std::to_string(i)) + " type=\"point\"");
    xml.Leaf("pose", SdfPose(Rigid3d(Eigen::Translation3d(light.centre_m))));
    xml.Leaf("diffuse", Colour(light.radiant_rgb));
    xml.Leaf("specular", Numbers(0.1, 0.1, 0.1, 1.0));
    WriteAttenuation(xml);
    xml.Leaf("cast_shadows", "false");  // Gazebo draws none for points of light
    xml.Close();
  }
}

// What is seen ("visual") or run into ("collision").
void WriteShape(XmlText& xml, const std::string& tag, const std::string& model_name) {
  xml.Open(tag, Named(tag));
  xml.Open("geometry");
  xml.Open("mesh");
  xml.Leaf("uri", "file://meshes/" + model_name + ".obj");
  xml.Close();
  xml.Close();
  xml.Close();
}

void WriteStaticModel(XmlText& xml, const WorldObject& object, const std::string& name) {
  xml.Open("model", Named(name));
  xml.Leaf("static", "true");
  xml.Leaf("pose", SdfPose(object.T_world_object));
  xml.Open("link", Named("link"));
  WriteShape(xml, "collision", name);
  WriteShape(xml, "visual", name);
  xml.Close();
  xml.Close();
}

// One round of a walk, its last waypoint where the first was.
void WriteTrajectory(XmlText& xml, const Walk& walk) {
  const double round_s = walk.RoundDuration();
  const int steps = std::max(1, static_cast<int>(std::ceil(round_s / kWaypointPeriod_s)));
  xml.Open("trajectory", "id=\"0\" type=\"walk\"");
  for (int i = 0; i <= steps; ++i) {
    const double time_s = round_s * i / steps;
    xml.Open("waypoint");
    xml.Leaf("time", Numbers(time_s));
    xml.Leaf("pose", SdfPose(walk.Pose(i == steps ? 0.0 : time_s)));
    xml.Close();
  }
  xml.Close();
}

void WriteActor(XmlText& xml, const WorldObject& object, const std::string& name) {
  xml.Open("actor", Named(name));
  xml.Open("link", Named("link"));
  WriteShape(xml, "visual", name);
  xml.Close();
  xml.Open("script");
  xml.Leaf("loop", "true");
  xml.Leaf("delay_start", "0");
  xml.Leaf("auto_start", "true");
  WriteTrajectory(xml, *object.walk);
  xml.Close();
  xml.Close();
}

void WriteDrone(XmlText& xml, const SdfDrone& drone) {
  xml.Open("include");
  xml.Leaf("uri", drone.uri);
  xml.Leaf("pose", SdfPose(drone.T_world_drone));
  xml.Close();
}

}  // namespace

std::vector<std::string> ModelNames(const World& world) {
  std::map<std::string, int> uses;
  for (const WorldObject& object : world.objects) ++uses[ValidName(object.name)];
  std::vector<std::string> names;
  for (const WorldObject& object : world.objects) {
    const std::string name = ValidName(object.name);
    const std::string number = "__" + std::to_string(object.instance);
    names.push_back(uses[name] == 1 ? name : name + number);
  }
  return names;
}

std::string SdfPose(const Rigid3d& T) {
  const Eigen::Matrix3d R = T.linear();
  const double across = std::hypot(R(0, 0), R(1, 0));  // cosine of the pitch
  const double pitch_rad = std::atan2(-R(2, 0), across);
  // Nose straight up or down: only roll plus or minus yaw matters, so let the roll be zero.
  const bool is_upright = across < 1e-9;
  const double roll_rad = is_upright ? 0.0 : std::atan2(R(2, 1), R(2, 2));
  const double yaw_rad = is_upright ? std::atan2(-R(0, 1), R(1, 1)) : std::atan2(R(1, 0), R(0, 0));
  const Eigen::Vector3d& t = T.translation();
  return Numbers(t.x(), t.y(), t.z(), roll_rad, pitch_rad, yaw_rad);
}

std::string SdfText(const World& world, const std::vector<std::string>& model_names,
                    const std::optional<SdfDrone>& drone) {
  assert(model_names.size() == world.objects.size());
  XmlText xml;
  xml.Open("sdf", "version=\"1.6\"");
  xml.Open("world", Named(ValidName(world.name)));
  WritePhysics(xml);
  WriteScene(xml, world);
  WriteSun(xml);
  WriteLamps(xml, world);
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    const WorldObject& object = world.objects[i];
    if (object.IsMoving()) {
      WriteActor(xml, object, model_names[i]);
    } else {
      WriteStaticModel(xml, object, model_names[i]);
    }
  }
  if (drone) WriteDrone(xml, *drone);
  xml.Close();
  xml.Close();
  return xml.str();
}

}  // namespace semantic_slam
