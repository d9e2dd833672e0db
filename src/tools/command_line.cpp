#include "tools/command_line.h"

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

namespace po = boost::program_options;

namespace {

constexpr char kArguments[] = "ARGUMENTS";  // the hidden option that collects positional arguments
constexpr char kSeeHelp[] = "; see --help";
constexpr unsigned kLineWidth = 100;

// No guessing: "--out" must not mean "--output" today and be ambiguous tomorrow.
constexpr int kStyle = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;

std::string ProgramName(int argc, const char* const* argv) {
  return argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "program";
}

std::vector<std::string> Tokens(int argc, const char* const* argv) {
  return argc > 0 ? std::vector<std::string>(argv + 1, argv + argc) : std::vector<std::string>();
}

std::string OnOneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

CommandLine::CommandLine(int argc, const char* const* argv, std::string purpose)
    : program_(ProgramName(argc, argv)),
      tokens_(Tokens(argc, argv)),
      purpose_(std::move(purpose)),
      options_("options", kLineWidth) {}

void CommandLine::Argument(const std::string& name, std::string* value, const std::string& help) {
  arguments_.push_back({name, value, help});
}

void CommandLine::Arguments(const std::string& name, std::vector<std::string>* values,
                            const std::string& help) {
  arguments_.push_back({name + "...", nullptr, help});
  remaining_ = values;
}

void CommandLine::Flag(const std::string& name, bool* value, const std::string& help) {
  Add(name, po::bool_switch(value), help);
}

void CommandLine::Add(const std::string& name, const po::value_semantic* semantic,
                      const std::string& help) {
  options_.add_options()(name.c_str(), semantic, help.c_str());
}

bool CommandLine::Parse() {
  options_.add_options()("help,h", "print this and exit");
  try {
    po::variables_map variables = ParseTokens();
    if (variables.count("help") > 0) {
      std::cout << Help();
      return false;
    }
    AssignArguments(variables.count(kArguments) > 0
                        ? variables[kArguments].as<std::vector<std::string>>()
                        : std::vector<std::string>());
    for (const OptionName& option : required_) {
      if (variables.count(option.name) > 0) continue;
      throw ConfigError("missing option --" + option.name + " " + option.value_name + kSeeHelp);
    }
    po::notify(variables);
  } catch (const po::error& e) {
    throw ConfigError(e.what() + std::string(kSeeHelp));
  }
  return true;
}

po::variables_map CommandLine::ParseTokens() const {
  po::options_description all;
  all.add(options_).add_options()(kArguments, po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add(kArguments, -1);
  po::variables_map variables;
  po::store(
      po::command_line_parser(tokens_).options(all).positional(positional).style(kStyle).run(),
      variables);
  return variables;
}

void CommandLine::AssignArguments(const std::vector<std::string>& given) const {
  if (given.size() < arguments_.size()) {
    throw ConfigError("missing argument " + arguments_[given.size()].name + kSeeHelp);
  }
  if (given.size() > arguments_.size() && remaining_ == nullptr) {
    throw ConfigError("unexpected argument " + given[arguments_.size()] + kSeeHelp);
  }
  const std::size_t single = arguments_.size() - (remaining_ == nullptr ? 0 : 1);
  for (std::size_t i = 0; i < single; ++i) *arguments_[i].value = given[i];
  if (remaining_ != nullptr) {
    remaining_->assign(given.begin() + static_cast<std::ptrdiff_t>(single), given.end());
  }
}

std::string CommandLine::Help() const {
  std::ostringstream help;
  help << "usage: " << program_ << " [options]";
  for (const OptionName& option : required_)
    help << " --" << option.name << " " << option.value_name;
  for (const PositionalArgument& argument : arguments_) help << " " << argument.name;
  help << "\n\n" << purpose_ << "\n\n";
  if (!arguments_.empty()) {
    std::size_t width = 0;
    for (const PositionalArgument& argument : arguments_) {
      width = std::max(width, argument.name.size());
    }
    help << "arguments:\n";
    for (const PositionalArgument& argument : arguments_) {
      help << "  " << std::left << std::setw(static_cast<int>(width)) << argument.name << "  "
           << argument.help << "\n";
    }
    help << "\n";
  }
  help << options_;
  return help.str();
}

int RunProgram(int argc, const char* const* argv, const std::string& purpose,
               const std::function<int(CommandLine&)>& body) {
  CommandLine command_line(argc, argv, purpose);
  try {
    const int exit_code = body(command_line);
    if (!std::cout.flush()) throw InputError("cannot write to standard output");
    return exit_code;
  } catch (const std::exception& e) {
    std::cerr << command_line.program() << ": " << OnOneLine(e.what()) << std::endl;
    return EXIT_FAILURE;
  }
}

}  // namespace semantic_slam
