// Models of a batch: each stored once under the name of its bytes, with the files it refers to.
#pragma once

#include <string>
#include <vector>

namespace trivet::farm {

/// A model of a recipe. In the store it is DIR/models/HASH/ with the file and, at the same relative
/// names, the files beside it that it refers to: buffers and images of glTF, .mtl and images of
/// OBJ. (FBX and DAE are stored without images of their own.)
struct BatchModel {
  std::string file;                 // where it is read from
  std::string name;                 // of the file alone
  std::vector<std::string> beside;  // relative to the file's folder, sorted
  /// SHA-256 of the lines "SHA-256  NAME" of all these files, NAME sorted: what sha256sum prints.
  std::string hash;

  /// models/HASH/NAME: its path in scenes, wherever the batch is made.
  std::string stored_path() const { return stored_in + hash + "/" + name; }
  /// A folder of the batch: "models/", or another one of files that are stored likewise.
  std::string stored_in = "models/";
};

/// Reads all its bytes. @throws Error (BadInput) when it cannot be read.
BatchModel batch_model(const std::string& file);

/// Copies it to its folder in `out` unless it is there: the first of several processes that do
/// wins.
/// @throws Error (Environment).
void store_model(const BatchModel& model, const std::string& out);

/// "" if what is stored is the same bytes; else what is wrong.
std::string check_stored(const std::string& out, const std::string& stored_path);

}  // namespace trivet::farm
