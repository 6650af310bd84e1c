// SPDX-License-Identifier: BSD-3-Clause
#include "aspects/map/proof_revision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <zlib.h>

namespace parallel_aspects {
namespace {

namespace fs = std::filesystem;

const fs::path root = PARALLEL_ASPECTS_SOURCE_DIR;
const fs::path kept = root / "test/aspects/map/proof_fingerprint.txt";

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// What the compiler reads of a source: no comments, no spaces, no includes, no guard of a header.
std::string code(const std::string& source) {
  static const std::regex ignored("//[^\n]*|#include[^\n]*|#(ifndef|define|endif) ?PARALLEL_ASPECTS[^\n]*");
  std::string result = std::regex_replace(source, ignored, "");
  result.erase(
      std::remove_if(result.begin(), result.end(), [](unsigned char c) { return std::isspace(c) != 0; }),
      result.end());
  return result;
}

std::string checksum(const std::string& text) {
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size());
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08lx", static_cast<unsigned long>(sum));
  return digits;
}

bool is_source(const fs::path& file) { return file.extension() == ".h" || file.extension() == ".cpp"; }

/// The checksum of each source that maps are proved by, by its name, so that moves change nothing: the maps,
/// and the intervals and legs that they stand on.
std::map<std::string, std::string> checksums() {
  std::map<std::string, std::string> result;
  for (const char* folder : {"include/parallel_aspects/aspects", "include/parallel_aspects/model",
                             "src/aspects", "src/interval", "src/legs", "src/model"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
      if (is_source(entry.path())) result[entry.path().filename()] = checksum(code(contents(entry.path())));
  return result;
}

std::string fingerprint() {
  std::ostringstream text;
  text << "revision " << proof_revision << '\n';
  for (const auto& [path, sum] : checksums()) text << sum << ' ' << path << '\n';
  return text.str();
}

TEST(ProofRevision, CodeIsComparedWithoutCommentsAndSpaces) {
  EXPECT_EQ(code("int a;  // one\n\n  int b;"), code("#include <new>\nint a; int b; // two"));
  EXPECT_NE(code("int a = 1;"), code("int a = 2;"));
}

// Where a proof changed, raise `proof_revision`, so that maps of the old one are computed anew. Where the
// change is harmless, as a new name, leave it. Either way keep the fingerprint that this test writes.
TEST(ProofRevision, IsRaisedWhenTheProofsChange) {
  const std::string now = fingerprint();
  if (now == contents(kept)) return;
  const fs::path written = fs::temp_directory_path() / kept.filename();
  std::ofstream(written, std::ios::trunc) << now;
  ADD_FAILURE() << "Sources of the proofs changed since revision " << proof_revision
                << ". If any proof did, raise proof_revision in aspects/map/proof_revision.h and run this "
                   "test again. Then copy "
                << written << " to " << kept << '.';
}

}  // namespace
}  // namespace parallel_aspects
