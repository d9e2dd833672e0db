#include "semantic_slam/map/byte_stream.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

TEST(ByteStreamTest, TheLeastByteComesFirst) {
  ByteWriter out;
  out.Put<std::uint32_t>(0x04030201);
  EXPECT_EQ(out.bytes(), "\1\2\3\4");
}

TEST(ByteStreamTest, NumbersComeBackAsTheyWere) {
  ByteWriter out;
  out.Put<std::int64_t>(-2);
  out.Put(-0.1);
  out.Put(std::numeric_limits<float>::quiet_NaN());
  out.Put<std::uint8_t>(200);
  ByteReader in(out.bytes());
  EXPECT_EQ(in.Get<std::int64_t>(), -2);
  EXPECT_EQ(in.Get<double>(), -0.1);
  EXPECT_TRUE(std::isnan(in.Get<float>()));
  EXPECT_EQ(in.remaining(), 1u);
  EXPECT_EQ(in.Get<std::uint8_t>(), 200);
  EXPECT_EQ(MessageOf<InputError>([&] { in.Get<std::uint8_t>(); }), "it ends too soon");
}

TEST(ByteStreamTest, NoMoreThingsAreAnnouncedThanCanFollow) {
  ByteWriter out;
  out.Put<std::uint64_t>(2);
  out.Put<std::uint64_t>(0);
  ByteReader in(out.bytes()), same(out.bytes());
  EXPECT_EQ(in.GetCount(4), 2u);
  EXPECT_EQ(MessageOf<InputError>([&] { same.GetCount(5); }), "it ends too soon");
}

}  // namespace
}  // namespace semantic_slam
