#include "histories/catalogue.hpp"

#include <string>
#include <vector>

#include "support/catalogue_walk.hpp"

namespace ixos {
namespace {

TEST(HistoryCatalogueTest, EveryEntryIsWhole) {
  Teuchos::ParameterList texts;
  texts.set("Value", std::string("sin(t)"));
  texts.set("Times", Teuchos::Array<double>(std::vector<double>{-1, 0.5, 8}));
  texts.set("Values", Teuchos::Array<double>(std::vector<double>{1, -2, 3}));
  test::walk(histories(), texts, {"Expression/Value", "Constant/Value"},
             [](const Teuchos::ParameterList& list, const HistoryEntry&) -> std::vector<double> {
               const auto function = histories().make(SceneNode(list, ""));
               std::vector<double> values;
               for (double time : {0.0, 0.05, 0.11, 0.3, 5.0}) {
                 const TimeValue value = function->at(time);
                 values.insert(values.end(), {value.value, value.rate, value.acceleration});
               }
               return values;
             });
}

}  // namespace
}  // namespace ixos
