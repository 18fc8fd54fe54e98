#include "histories/catalogue.hpp"

#include "support/catalogue_walk.hpp"

namespace ixos {
namespace {

TEST(HistoryCatalogueTest, EveryEntryIsWhole) {
  Teuchos::ParameterList texts;
  texts.set("Value", std::string("sin(t)"));
  // The walk gives a table no values; a refusal is no table.
  test::walk(histories(), texts, {"Table/Times", "Table/Values", "Expression/Value", "Constant/Value"},
             [](const Teuchos::ParameterList& list, const HistoryEntry& entry) -> std::vector<double> {
               if (entry.name == "Table") return {1};
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
