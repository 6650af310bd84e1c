// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_FILE_H
#define PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_FILE_H

#include "parallel_aspects/model/problems.h"
#include "tools/sweep/sweep_plan.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace parallel_aspects::tools {

/// A part of a sweep: designs i, i + n, i + 2 n and so on, for i from 1.
struct Shard {
  std::size_t index = 1, count = 1;

  std::size_t rows(std::size_t designs) const { return (designs + count - index) / count; }
  std::size_t design(std::size_t row) const { return index - 1 + row * count; }  ///< from 0
};

/// The first line of a file of rows.
struct SweepHeader {
  std::uint32_t fingerprint = 0;
  std::size_t designs = 0;
  Shard shard;
};

/// "# aspects sweep 1, fingerprint 0123abcd, 441 designs, shard 1/4", without a line end.
std::string header_line(const SweepHeader& header);

/// Whether a row may stand under these columns: as many cells, a status, and numbers or nothing elsewhere.
bool is_row_of(const std::string& columns, const std::string& row);

/// A file that rows are added to, one by one, in order. Nobody else writes to it meanwhile. A row is there
/// for good once `add` returns, whatever then happens to this process; the rest of one that was cut off is
/// removed when the file is opened again.
class SweepFile {
 public:
  /// Creates the file, or goes on with one of the same sweep and shard. Throws `InvalidDescription` where it
  /// cannot be written, is in use, or is of another sweep or no sweep at all.
  SweepFile(const SweepPlan& plan, const Shard& shard, std::string file);

  std::size_t rows() const { return rows_; }  ///< that it holds

  /// Throws `InvalidDescription` where it cannot be written.
  void add(const std::string& row);

 private:
  /// A file that is open, and locked; free for others once this is gone.
  class Descriptor {
   public:
    Descriptor() = default;
    ~Descriptor();
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number = -1;
  };

  void open();
  std::string contents() const;
  void take_rows(const SweepPlan& plan, const Shard& shard, const std::string& text, std::size_t at);
  void write(const std::string& text);
  [[noreturn]] void refuse(const std::string& why) const;

  std::string file_;
  Descriptor descriptor_;
  std::size_t rows_ = 0;
};

/// The text of the whole sweep out of the files of all its shards, in any order. Throws `InvalidDescription`
/// with everything that keeps them from being that: parts that are missing, given twice, not finished,
/// damaged, or of another sweep.
std::string merged_parts(const std::vector<std::string>& files);

/// Reported while rows are written: how many of this shard there are, and how many there will be.
using SweepProgress = std::function<void(std::size_t rows, std::size_t of)>;

/// Computes the rows that the file does not have, one thread a design, and adds each in its turn. Ends soon
/// after it is cancelled, and then leaves those rows out that are not finished.
void run_sweep(const SweepPlan& plan, const Shard& shard, unsigned threads, const MapControl& control,
               const SweepProgress& progress, SweepFile& file);

}  // namespace parallel_aspects::tools

#endif  // PARALLEL_ASPECTS_TOOLS_SWEEP_SWEEP_FILE_H
