#pragma once

#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <boost/program_options.hpp>

namespace semantic_slam {

// The command line of a program: declare what it takes, each bound to a variable, then Parse().
//
//   int CountPoses(CommandLine& command_line) {
//     std::string path;
//     double max_dt_s = 0.02;               // what a variable holds before Parse() is the default
//     std::optional<double> rpe_seconds;    // stays nullopt if the option is not given
//     bool json = false;
//     command_line.Argument("TRAJECTORY", &path, "TUM format");
//     command_line.Option("max-dt", "S", &max_dt_s, "largest difference of stamps [s]");
//     command_line.Option("rpe-seconds", "S", &rpe_seconds, "...");
//     command_line.Flag("json", &json, "print JSON");
//     if (!command_line.Parse()) return EXIT_SUCCESS;  // --help was asked for and is printed
//     CheckInRange("--max-dt", max_dt_s, 0.0, 10.0);
//     ...
//     return EXIT_SUCCESS;
//   }
//
//   int main(int argc, char** argv) {
//     return semantic_slam::RunProgram(argc, argv, "Counts the poses.", semantic_slam::CountPoses);
//   }
//
// Variables must outlive Parse(). Not thread-safe.
class CommandLine {
 public:
  // `purpose` is the text between the usage line and the table of options in --help.
  CommandLine(int argc, const char* const* argv, std::string purpose);

  // A positional argument; all are required, in the order of these calls.
  void Argument(const std::string& name, std::string* value, const std::string& help);

  // "NAME...": one or more, behind all other arguments.
  void Arguments(const std::string& name, std::vector<std::string>* values, const std::string& help);

  // "--name VALUE_NAME".
  template <typename T>
  void Option(const std::string& name, const std::string& value_name, T* value,
              const std::string& help) {
    std::ostringstream default_text;
    default_text << *value;
    auto* semantic = Typed(value_name, value);
    if (!default_text.str().empty()) semantic->default_value(*value, default_text.str());
    Add(name, semantic, help);
  }
  template <typename T>
  void Option(const std::string& name, const std::string& value_name, std::optional<T>* value,
              const std::string& help) {
    auto* semantic = boost::program_options::value<T>()->value_name(value_name);
    Add(name, semantic->notifier([value](const T& given) { *value = given; }), help);
  }

  // The same, but Parse() refuses a command line without it.
  template <typename T>
  void RequiredOption(const std::string& name, const std::string& value_name, T* value,
                      const std::string& help) {
    required_.push_back({name, value_name});
    Add(name, Typed(value_name, value), help);
  }

  // "--name": sets `value` to true.
  void Flag(const std::string& name, bool* value, const std::string& help);

  // Fills the variables. Returns false after printing the help to stdout, if --help is given;
  // throws ConfigError naming what is unknown, malformed, missing, or given twice.
  [[nodiscard]] bool Parse();

  // The file name of argv[0].
  const std::string& program() const { return program_; }

  std::string Help() const;

 private:
  struct PositionalArgument {
    std::string name;
    std::string* value;  // null: those that are left
    std::string help;
  };
  struct OptionName {
    std::string name;
    std::string value_name;
  };

  template <typename T>
  static boost::program_options::typed_value<T>* Typed(const std::string& value_name, T* value) {
    return boost::program_options::value<T>(value)->value_name(value_name);
  }
  void Add(const std::string& name, const boost::program_options::value_semantic* semantic,
           const std::string& help);
  boost::program_options::variables_map ParseTokens() const;
  void AssignArguments(const std::vector<std::string>& given) const;

  const std::string program_;
  const std::vector<std::string> tokens_;
  const std::string purpose_;
  boost::program_options::options_description options_;
  std::vector<PositionalArgument> arguments_;
  std::vector<std::string>* remaining_ = nullptr;
  std::vector<OptionName> required_;
};

// Runs a program's body and returns main()'s exit code: what `body` returns, or 1 after the one
// line "program: what went wrong" on stderr if it throws or stdout cannot be written.
int RunProgram(int argc, const char* const* argv, const std::string& purpose,
               const std::function<int(CommandLine&)>& body);

}  // namespace semantic_slam
