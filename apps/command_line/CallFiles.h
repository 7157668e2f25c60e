#pragma once
#include <map>
#include <string>
#include <vector>

#include "output_names.h"

namespace roomgraph {

/** All files of a call, told before any work: first those that it reads, then those that it will
 *  write. Whatever would be lost by the latter is refused at once: where two of them are one file,
 *  where one is a file that is read, or would replace what is not ours to replace (see isOurs), and
 *  where a name is too long. Each throws UsageError with one line: file, problem, remedy. */
class CallFiles {
 public:
  /** Of a ROS map its picture is read, too. An empty name is none. */
  void reads(const std::string& file);
  void reads(const std::vector<std::string>& files);
  /** What is read before all else, such as options: a JSON or ini result may take its place. */
  void consults(const std::string& file);

  /** A result in the folder of --output, of a map or another `source`. */
  void writes(const std::string& file, const std::string& source = kFolderOption);
  /** folder/X.extension of each map and each extension. */
  void writesOfEach(const std::vector<std::string>& maps, const std::string& folder,
                    const std::vector<std::string>& extensions);
  /** Results that are numbered only when they are found: those that are there already, whose names
   *  begin so and go on with a digit. To be told last. */
  void writesNumbered(const std::string& stem, const std::string& source = kFolderOption);
  /** The file that an option names. An empty name is none. */
  void writesTo(const std::string& option, const std::string& file);
  /** The same for a picture, which may take the place of one of ours. */
  void draws(const std::string& option, const std::string& file);
  /** The same for one that is read and written anew by design. */
  void updates(const std::string& option, const std::string& file);

 private:
  static constexpr char kFolderOption[] = "--output";

  enum class Place { inFolder, named, drawn, updated };

  struct Output {
    std::string file;
    std::string source;  ///< the map or the option that it is written for
    Place place = Place::inFolder;

    std::string remedy() const;
  };

  void addInput(const std::string& file, bool mayBeRenewed);
  void add(const Output& output);
  void checkReplaced(const Output& output) const;

  std::map<FileIdentity, bool> inputs_;         ///< whether a JSON result may take its place
  std::map<std::string, std::string> sources_;  ///< of each output, by its place on the disk
};

}  // namespace roomgraph
