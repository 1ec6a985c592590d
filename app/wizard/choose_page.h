#pragma once

#include "session_import.h"
#include "wizard/wizard_page.h"

class QComboBox;
class QLineEdit;
class QToolButton;
class QVBoxLayout;

namespace vantage {

class DeviceEditor;
class RecentSessions;
struct RigFile;
class SettingsForm;

/// Which scanner, which object, where to.
class ChoosePage final : public WizardPage {
  Q_OBJECT

 public:
  /// @param resources folder with scanners/ and objects/
  ChoosePage(SessionController& controller, const QString& resources, QWidget* parent = nullptr);

  [[nodiscard]] QString key() const override { return QStringLiteral("choose"); }
  [[nodiscard]] QString title() const override { return tr("Scanner and object"); }
  [[nodiscard]] QString whatNext() const override;
  [[nodiscard]] QString nextText() const override { return tr("&Next: check the set-up"); }
  [[nodiscard]] bool complete() const override;
  [[nodiscard]] QString whyNotNext() const override;
  void entered() override;
  void leaving() override;

  /// What of the page holds for recorded scans, too.
  [[nodiscard]] ImportChoice importChoice() const;

  /// Offers the sessions of lately, as long as none is open.
  void showRecent(RecentSessions& sessions);
  /// Why no mesh can be chosen as what the simulated scanner looks at; empty when one can.
  [[nodiscard]] QString whyNoObject() const;
  /// Chooses a mesh as what the simulated scanner looks at. @pre whyNoObject is empty
  void takeObject(const QString& path);

 signals:
  void recentRequested(const QString& path);  ///< one of those is to be opened
  void openRequested();                       ///< the operator wants to open a session
  void importRequested();                     ///< or to import recorded scans

 private:
  void build();
  void fill(QComboBox& box, const QString& folder, const QString& pattern, const QString& preferred);
  QComboBox* addFileRow(QVBoxLayout& column, const QString& label, const QString& name, const QString& help,
                        const QString& filter);
  void suggestFolder();
  void takeRig(const RigFile& file);
  void suggestCut();
  void takeWhatWasTried();
  void showWhatIsSimulated();
  void showScanner();
  void allowChoice();
  [[nodiscard]] SetUpChoice choice() const;

  QString resources_;
  DeviceEditor* devices_ = nullptr;
  QComboBox* scanner_ = nullptr;
  QComboBox* object_ = nullptr;
  QWidget* objectRow_ = nullptr;  ///< with its title; real scanners see what stands before them
  QLineEdit* folder_ = nullptr;
  SettingsForm* form_ = nullptr;
  bool folderIsChosen_ = false;  ///< and not suggested
  bool cutIsForReal_ = false;    ///< what is cut was suggested for a real scanner
  QString chosenScanner_;        // before a session was opened
};

}  // namespace vantage
