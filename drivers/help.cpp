#include "help.hpp"

#include <memory>

namespace ixos {
namespace {

class HelpFormatter final : public CLI::Formatter {
 public:
  HelpFormatter() { label("Positionals", "Arguments"); }

  /// Returns the type of an option's value, and nothing else.
  std::string make_option_opts(const CLI::Option* option) const override {
    const bool takes_value = option->nonpositional() && option->get_type_size() != 0;
    return takes_value ? " " + option->get_type_name() : "";
  }
  std::string make_footer(const CLI::App* app) const override { return app->get_footer(); }
};

}  // namespace

void set_help(CLI::App& app, const std::string& examples, const std::string& remark) {
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help");
  app.footer("Examples:\n" + examples + (remark.empty() ? "" : "\n" + remark));
}

}  // namespace ixos
