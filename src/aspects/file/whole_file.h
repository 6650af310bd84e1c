// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_ASPECTS_FILE_WHOLE_FILE_H
#define PARALLEL_ASPECTS_ASPECTS_FILE_WHOLE_FILE_H

#include "aspects/file/byte_stream.h"

#include <cstddef>
#include <string>

namespace parallel_aspects {

/// Fills `bytes` with a regular file of at most `most` bytes. Empty when done, else why not, such as "it
/// cannot be read: No such file or directory".
std::string read_whole_file(const std::string& path, std::size_t most, Bytes& bytes);

/// Why no file can be written there, such as "is in no folder that can be written to"; empty where one can.
std::string problem_of_writing(const std::string& path);

/// Makes `bytes` the file's whole contents: at every moment, also after a crash, the file is the old one or
/// the new one. A link is followed, and what is no regular file, such as a device, is not touched. Empty when
/// done; else why not, and the old file is untouched.
std::string replace_file(const std::string& name, const Bytes& bytes);

}  // namespace parallel_aspects

#endif  // PARALLEL_ASPECTS_ASPECTS_FILE_WHOLE_FILE_H
