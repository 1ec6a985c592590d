#pragma once

#include <QString>
#include <QStringList>
#include <variant>
#include <vector>

namespace vantage {

/// One setting of a struct T: what it is called, what it means, and where in T it is. A table of fields drives the form
/// that edits T and the file that keeps it.
template <typename T>
struct Field {
  struct Switch {
    bool T::*value;
  };
  struct Whole {
    int T::*value;
    int least = 0;
    int most = 100;
    QString unit;
  };
  struct Number {
    double T::*value;
    double least = 0.0;
    double most = 1.0;
    int decimals = 2;
    QString unit;
  };
  struct Choice {
    int T::*value;  ///< index into the options
    QStringList options;
  };
  struct Named {
    QString T::*value;  ///< one of the codes
    QStringList codes;
    QStringList names;  ///< of the codes, in the form
  };

  QString key;    ///< in the file
  QString label;  ///< in the form
  QString help;   ///< one sentence
  std::variant<Switch, Whole, Number, Choice, Named> kind;
};

template <typename T>
using FieldTable = std::vector<Field<T>>;

}  // namespace vantage
