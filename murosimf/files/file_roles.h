/// file_roles.h - the files that a command reads and those that it writes: none is both, and no two results go to one file.
///
///     const FileRoles roles;                       // in main()
///     claim_output("--csv", "table.csv");          // refused if this command has read it, or writes it by another option
///     read_input_file("table.csv", most);          // refused from now on
///
/// Files are compared by device and inode, so a link or another spelling of the name is the same file. Devices, pipes and
/// open descriptors (/dev/stdout) are never the same. Without a FileRoles nothing is recorded: a program that uses the library
/// may write a file and read it again.
#pragma once

#include <filesystem>
#include <string>

namespace murosimf::files {

/// Records the files of the whole process while it lives; one at a time.
class FileRoles {
 public:
  FileRoles();
  ~FileRoles();
  FileRoles(const FileRoles&) = delete;
  FileRoles& operator=(const FileRoles&) = delete;
};

/// Claims a result. `option` as the user gives it, "--csv"; the same option may claim its file again. Checks that it could be written
/// (output_file.h). Throws SetupError: "--csv 'a.csv': ...".
void claim_output(const std::string& option, const std::filesystem::path& file);

/// The same for a file that the command continues: its contents are read first, and kept.
void claim_continued(const std::string& option, const std::filesystem::path& file);

/// To be called before a file is opened for reading. Throws SetupError if it is a claimed output.
void note_input(const std::filesystem::path& file);

/// To be called before a file is replaced. Throws SetupError if this command has read it.
void check_not_input(const std::filesystem::path& file);

}  // namespace murosimf::files
