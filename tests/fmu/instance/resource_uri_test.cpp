// Resource locations as masters write them.
#include "instance/resource_uri.h"

#include <gtest/gtest.h>

namespace drape::instance {
namespace {

TEST(ResourceUri, AllowedForms) {
  const std::pair<const char*, const char*> cases[] = {
      {"file:///tmp/fmu/resources", "/tmp/fmu/resources"},
      {"file:/tmp/fmu/resources", "/tmp/fmu/resources"},
      {"file://localhost/tmp/fmu/resources", "/tmp/fmu/resources"},
      {"file:///tmp/fmu/resources/", "/tmp/fmu/resources"},
      {"file:///tmp/my%20cloth/100%25/%d0%a8%D0%B5", "/tmp/my cloth/100%/\xd0\xa8\xd0\xb5"},
      {"/tmp/my cloth/100%/resources", "/tmp/my cloth/100%/resources"},
      {"resources", "resources"},
      {"/tmp/\xe2\x82\xac/\xf0\x9f\xa7\xb5", "/tmp/\xe2\x82\xac/\xf0\x9f\xa7\xb5"},
      {"file:///", "/"},
  };
  for (const auto& [location, path] : cases) {
    std::string problem;
    EXPECT_EQ(resource_path(location, problem), path);
    EXPECT_EQ(problem, "");
  }
}

TEST(ResourceUri, RefusedForms) {
  for (const char* location :
       {"", "file:", "file://", "file://otherhost/tmp", "file:relative", "http://localhost/tmp",
        "file:///tmp/%2", "file:///tmp/%zz", "file:///tmp/%00", "file:///tmp/%ff", "file:///tmp/%c0%af",
        "file:///tmp/%ed%a0%80", "file:///tmp/%f4%90%80%80", "file:///tmp/%e2%82", "/tmp/T\374cher"}) {
    std::string problem;
    EXPECT_EQ(resource_path(location, problem), "") << location;
    EXPECT_NE(problem.find(location), std::string::npos) << problem;
    EXPECT_NE(problem.find("allowed"), std::string::npos) << problem;
  }
}

}  // namespace
}  // namespace drape::instance
