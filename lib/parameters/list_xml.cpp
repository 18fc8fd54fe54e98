#include "parameters/list_xml.hpp"

#include <expat.h>
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "parameters/parameter_text.hpp"

namespace ixos {
namespace {

/// The elements of one document as they begin and end. Expat is a C library: an exception of a handler is kept until
/// Expat returns.
class Reader {
 public:
  explicit Reader(const std::string& origin) : origin_(origin), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_begin, on_end);
    XML_SetCharacterDataHandler(parser_.get(), on_text);
    XML_SetStartDoctypeDeclHandler(parser_.get(), on_document_type);
  }

  Teuchos::ParameterList read(const std::string& xml) {
    const XML_Status status = XML_Parse(parser_.get(), xml.data(), static_cast<int>(xml.size()), 1);
    if (problem_) std::rethrow_exception(problem_);
    if (status != XML_STATUS_OK && XML_GetErrorCode(parser_.get()) == XML_ERROR_NO_MEMORY) {
      note_failed_allocation(0);
      throw std::bad_alloc();
    }
    if (status != XML_STATUS_OK)
      throw InputError(fmt::format("{}: XML parse error at line {}: {}", origin_,
                                   XML_GetCurrentLineNumber(parser_.get()),
                                   XML_ErrorString(XML_GetErrorCode(parser_.get()))));
    return root_;
  }

 private:
  /// An open element. Its list is null if the element is not a list.
  struct Level {
    Teuchos::ParameterList* list;
    std::string path;
  };

  template <class Function>
  static void guarded(void* self, const Function& function) {
    auto& reader = *static_cast<Reader*>(self);
    if (reader.problem_) return;
    try {
      function(reader);
    } catch (...) {
      reader.problem_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }
  static void on_begin(void* self, const XML_Char* tag, const XML_Char** attributes) {
    guarded(self, [&](Reader& reader) { reader.begin(tag, attributes); });
  }
  static void on_end(void* self, const XML_Char*) {
    guarded(self, [](Reader& reader) { reader.levels_.pop_back(); });
  }
  static void on_text(void* self, const XML_Char* text, int length) {
    guarded(self, [&](Reader& reader) { reader.refuse_text({text, static_cast<std::size_t>(length)}); });
  }
  static void on_document_type(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    guarded(self, [](Reader& reader) { throw InputError(reader.origin_ + ": <!DOCTYPE is not allowed"); });
  }

  void begin(const std::string& tag, const XML_Char** attributes) {
    if (levels_.size() > deepest_list)
      throw InputError(fmt::format("{}: lists are nested deeper than {} levels", place(), deepest_list));
    if (levels_.empty()) return begin_root(tag, attributes);
    Teuchos::ParameterList* list = levels_.back().list;
    if (tag == "Validators" || passing()) return levels_.push_back({nullptr, ""});  // Teuchos writes an empty one
    if (list == nullptr) throw InputError(fmt::format("{}: <{}> inside a parameter", place(), tag));
    if (tag != "Parameter" && tag != "ParameterList")
      throw InputError(fmt::format("{}: <{}> is neither <Parameter> nor <ParameterList>", place(), tag));
    const std::string name = required(attributes, "name", tag, place());
    const std::string path = place() + (levels_.size() == 1 ? " " : "/") + name;
    if (list->isParameter(name)) throw InputError(path + " is given twice");
    try {
      check_name(name);
      levels_.push_back({nullptr, path});
      if (tag == "ParameterList")
        levels_.back().list = &list->sublist(name);
      else
        set_from_text(*list, name, required(attributes, "type", tag, path), required(attributes, "value", tag, path));
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(what.rfind(path, 0) == 0 ? what : path + ": " + what);
    }
  }

  void begin_root(const std::string& tag, const XML_Char** attributes) {
    if (tag != "ParameterList")
      throw InputError(origin_ + ": the outermost element is <" + tag + ">; it must be <ParameterList>");
    if (const XML_Char* name = find(attributes, "name"); name != nullptr) {
      check_name(name);
      root_.setName(name);
    }
    levels_.push_back({&root_, origin_ + ":"});
  }

  /// Returns whether the parser is within <Validators>.
  bool passing() const { return levels_.back().path.empty(); }
  const std::string& place() const { return levels_.empty() ? origin_ : levels_.back().path; }

  void refuse_text(const std::string& text) const {
    if (!passing() && text.find_first_not_of(" \t\r\n") != std::string::npos)
      throw InputError(fmt::format("{}: line {} has text outside of tags: \"{}\"", origin_,
                                   XML_GetCurrentLineNumber(parser_.get()), text));
  }

  static const XML_Char* find(const XML_Char** attributes, const std::string& name) {
    for (; *attributes != nullptr; attributes += 2)
      if (name == attributes[0]) return attributes[1];
    return nullptr;
  }
  static std::string required(const XML_Char** attributes, const std::string& name, const std::string& tag,
                              const std::string& place) {
    const XML_Char* value = find(attributes, name);
    if (value == nullptr) throw InputError(place + ": <" + tag + "> has no attribute \"" + name + "\"");
    return value;
  }

  const std::string& origin_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
  Teuchos::ParameterList root_;
  std::vector<Level> levels_;
  std::exception_ptr problem_;
};

}  // namespace

Teuchos::ParameterList list_from_xml(const std::string& xml, const std::string& origin) {
  if (xml.size() > largest_xml)
    throw InputError(fmt::format("{}: is larger than {} bytes, the largest size allowed", origin, largest_xml));
  return Reader(origin).read(xml);
}

}  // namespace ixos
