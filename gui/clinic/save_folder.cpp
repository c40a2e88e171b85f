// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/save_folder.hpp"

#include <QFileInfo>
#include <QStandardPaths>

namespace isograsp::gui {

QString proposed_folder(const std::string& database) {
  for (const auto place : {QStandardPaths::DocumentsLocation, QStandardPaths::HomeLocation}) {
    const QFileInfo folder(QStandardPaths::writableLocation(place));
    if (folder.isDir() && folder.isWritable()) return folder.absoluteFilePath();
  }
  return QFileInfo(QString::fromStdString(database)).absolutePath();
}

Result<void> check_folder_of(const std::string& path) {
  const QFileInfo folder(QFileInfo(QString::fromStdString(path)).absolutePath());
  const auto refuse_folder = [&](Words why, Words what_to_do) {
    return failed(why, what_to_do).at(folder.filePath().toStdString());
  };
  if (!folder.exists())
    return refuse_folder("this folder does not exist"_text,
                         "choose another folder, or make it first"_text);
  if (!folder.isDir()) return refuse_folder("this is no folder"_text, "choose another folder"_text);
  if (!folder.isWritable())
    return refuse_folder("nothing may be written into this folder"_text,
                         "choose another folder, or ask for the permission"_text);
  return {};
}

}  // namespace isograsp::gui
