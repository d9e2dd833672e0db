#pragma once

#include <string>

#include <gtest/gtest.h>

namespace semantic_slam {

// The message of the `Error` that `run` throws; "" if it throws nothing. Other exceptions pass.
template <typename Error, typename Run>
std::string MessageOf(Run&& run) {
  try {
    run();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

// For messages that carry a path: expects every part, and that the message is one line.
inline void ExpectOneLineWith(const std::string& message,
                              std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    EXPECT_NE(message.find(part), std::string::npos)
        << "expected '" << part << "' in '" << message << "'";
  }
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace semantic_slam
