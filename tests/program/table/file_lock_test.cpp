// Which mounts have locks that only one machine sees.
#include "solver/program/table/file_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stationary {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view mounts =
    "22 27 0:21 / /sys rw,nosuid - sysfs sysfs rw\n"
    "27 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"
    "90 27 0:45 / /home rw,relatime shared:44 - nfs4 server:/home rw,vers=4.2,local_lock=none\n"
    "91 27 0:46 / /old rw,relatime shared:45 - nfs server:/old rw,vers=3,nolock,local_lock=all\n"
    "92 27 0:47 / /scratch rw master:3 shared:46 - lustre mds@tcp:/scratch rw,localflock\n"
    "93 27 0:48 / /cut rw\n";

TEST(FileLock, MountsWithLocksOfOneMachineAreNamed) {
  EXPECT_EQ(only_local_locks(mounts, "8:1"), std::nullopt);
  EXPECT_EQ(only_local_locks(mounts, "0:45"), std::nullopt);
  EXPECT_EQ(only_local_locks(mounts, "0:99"), std::nullopt);
  EXPECT_EQ(only_local_locks(mounts, "0:48"), std::nullopt);
  EXPECT_EQ(only_local_locks("", "8:1"), std::nullopt);
  EXPECT_THAT(only_local_locks(mounts, "0:46").value(), HasSubstr("(nfs, mounted nolock)"));
  EXPECT_THAT(only_local_locks(mounts, "0:47").value(), HasSubstr("(lustre, mounted localflock)"));
}

}  // namespace
}  // namespace stationary
