#include "help.hpp"

#include <cstddef>
#include <memory>

namespace ixos {
namespace {

constexpr std::size_t column = 30;  ///< where descriptions begin

std::string entry(const std::string& name, const std::string& description) {
  const std::string left = "  " + name;
  const std::string gap =
      left.size() < column ? std::string(column - left.size(), ' ') : '\n' + std::string(column, ' ');
  return left + gap + description + '\n';
}

/// CLI11's own formatters differ from version to version.
class HelpFormatter final : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string /*name*/, CLI::AppFormatMode /*mode*/) const override {
    std::string usage = "Usage: " + app->get_name() + " [OPTIONS]", arguments, options;
    for (const CLI::Option* option : app->get_options()) {
      if (option->get_group().empty()) continue;  // hidden
      if (option->nonpositional()) {
        const bool takes_value = option->get_type_size() != 0;
        options += entry(option->get_name(false, true) + (takes_value ? " " + option->get_type_name() : ""),
                         option->get_description());
      } else {
        usage += " [" + option->get_name(true) + "]";
        arguments += entry(option->get_name(true), option->get_description());
      }
    }
    return app->get_description() + '\n' + usage + "\n\nArguments:\n" + arguments + "\nOptions:\n" + options + '\n' +
           app->get_footer();
  }
};

}  // namespace

void set_help(CLI::App& app, const std::string& examples, const std::string& remark) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help");
  app.footer("Examples:\n" + examples + (remark.empty() ? "" : "\n" + remark));
}

}  // namespace ixos
