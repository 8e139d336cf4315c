// Parts that confine an importer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trivet {

/// Parts that keep a process that reads an untrusted file from anything else. Every part is there
/// where the system has it; an importer reports its parts before it opens the file.
struct Protection {
  bool files = false;       // Landlock: opens nothing but the model's folder, and writes nothing
  bool calls = false;       // seccomp: no programs, processes, sockets, or files to write
  bool network = false;     // a network of its own, without interfaces
  bool mounts = false;      // all file systems are read-only to it
  bool privileges = false;  // neither root nor any capability but that of reading

  bool operator==(const Protection&) const = default;
  /// Neither other files can be read, nor anything written, started or connected to.
  bool whole() const { return files && calls; }
};

/// Names of its parts: "landlock", "seccomp", "network", "mounts", "privileges".
std::vector<std::string> parts_of(const Protection& protection);
/// Names of the parts that are not there.
std::vector<std::string> lacking_in(const Protection& protection);
/// "models are read without landlock; ...": a note for people, if the protection is not whole; else
/// empty.
std::string warning_about(const Protection& protection);

/// A bit for each part, in the order of the struct.
std::uint8_t bits_of(const Protection& protection);
Protection protection_of_bits(std::uint8_t bits);

}  // namespace trivet
