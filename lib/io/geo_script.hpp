/// The files of a drawing, and what a script of gmsh does besides drawing.
#pragma once
#include <string>
#include <vector>

namespace ixos {

/// Returns the path of a drawing and those of the files that it reads: scripts that it includes or merges, files that
/// its texts name, and options beside it (<file>.opt), which gmsh reads, too; each once. Throws FileError if the
/// drawing cannot be read. Unless the scripts are trusted it throws InputError, with the place, where one of them does
/// what a drawing has no need of: starts a program, writes a file, sets options other than those of geometry and mesh,
/// reads a script in a way that hides its name, or has such a word in a comment or a text beside If, For or Macro,
/// which make gmsh read comments and texts as commands. gmsh would do it with the rights of the user. The scan
/// knows words, not the language: it refuses more than it must.
std::vector<std::string> drawing_files(const std::string& path, bool trusted);

/// Returns whether a word stands in one of the scripts (.geo) among the files.
bool has_word(const std::vector<std::string>& files, const std::string& word);

}  // namespace ixos
