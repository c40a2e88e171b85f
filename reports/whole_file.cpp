// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/whole_file.hpp"

#include <QSaveFile>

namespace isograsp {

Result<void> write_whole_file(const std::string& path, const QByteArray& bytes) {
  QSaveFile file(QString::fromStdString(path));
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
    return Error{Error::Code::failed,
                 "cannot be written (" + file.errorString().toStdString() + ")",
                 "choose a folder that exists and is writable",
                 path,
                 0,
                 ""};
  return {};
}

}  // namespace isograsp
