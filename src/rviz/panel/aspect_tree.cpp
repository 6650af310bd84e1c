// SPDX-License-Identifier: BSD-3-Clause
#include "rviz/panel/aspect_tree.h"

#include <QHeaderView>
#include <QPixmap>
#include <QTreeWidgetItemIterator>
#include <utility>

namespace parallel_aspects {
namespace {

enum Column { name_column, sign_column, size_column, clearance_column, index_column, column_count };

constexpr int swatch_size = 12;  // [pixels]

QIcon swatch_of(Rgb color) {
  QPixmap pixmap(swatch_size, swatch_size);
  pixmap.fill(QColor::fromRgb(color));
  return QIcon(pixmap);
}

std::vector<std::vector<std::uint32_t>> ids_of(const std::vector<ModeRows>& modes) {
  std::vector<std::vector<std::uint32_t>> ids;
  for (const ModeRows& mode : modes) {
    ids.emplace_back();
    for (const AspectRow& row : mode.aspects) ids.back().push_back(row.id);
  }
  return ids;
}

bool is_empty(const std::vector<ModeRows>& modes, std::string AspectRow::*column) {
  for (const ModeRows& mode : modes)
    for (const AspectRow& row : mode.aspects)
      if (!(row.*column).empty()) return false;
  return true;
}

}  // namespace

AspectTree::AspectTree(OnShown on_shown, QWidget* parent)
    : QTreeWidget(parent), on_shown_(std::move(on_shown)) {
  setObjectName("aspects");
  setColumnCount(column_count);
  setHeaderLabels({"aspect", "det A", "size", "radius", "index"});
  const char* const tips[] = {
      "Working modes and their aspects. Ticked ones are drawn.", "Sign of det A.",
      "Volume of the aspect in the workspace.",
      "Radius of the largest ball of poses in it: from its middle no singularity or limit is closer [m or "
      "rad].",
      "Inverse condition number at the middle of that ball: 0 at a parallel singularity, 1 at best."};
  for (int i = 0; i < column_count; ++i) headerItem()->setToolTip(i, tips[i]);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setStretchLastSection(false);
  setAlternatingRowColors(true);
  setUniformRowHeights(true);
  setIndentation(14);
  for (int i = sign_column; i < column_count; ++i) headerItem()->setTextAlignment(i, Qt::AlignRight);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem*, int column) {
    if (!filling_ && column == name_column) on_shown_(ticked());
  });
}

void AspectTree::show_rows(const std::vector<ModeRows>& modes, const std::string& unit) {
  filling_ = true;
  headerItem()->setText(size_column,  // in two lines, so that all columns fit
                        unit.empty() ? QString("size") : QString::fromStdString("size\n[" + unit + "]"));
  setColumnHidden(clearance_column, is_empty(modes, &AspectRow::clearance));
  setColumnHidden(index_column, is_empty(modes, &AspectRow::index));
  if (ids_ != ids_of(modes)) make_items(modes);
  QTreeWidgetItem* present = nullptr;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    QTreeWidgetItem& parent = *topLevelItem(static_cast<int>(i));
    mark(parent, modes[i].present);
    for (std::size_t j = 0; j < modes[i].aspects.size(); ++j) {
      QTreeWidgetItem& item = *parent.child(static_cast<int>(j));
      fill(item, modes[i].aspects[j]);
      if (modes[i].aspects[j].present) present = &item;
    }
  }
  filling_ = false;
  follow(present);
}

// Goes to the present aspect when it becomes another one, and not while somebody looks elsewhere.
void AspectTree::follow(QTreeWidgetItem* present) {
  const std::uint32_t id = present == nullptr ? 0 : present->data(name_column, Qt::UserRole).toUInt();
  if (id != present_ && present != nullptr) scrollToItem(present);
  present_ = id;
}

void AspectTree::make_items(const std::vector<ModeRows>& modes) {
  ids_ = ids_of(modes);
  clear();
  for (const ModeRows& mode : modes) {
    auto* const parent = new QTreeWidgetItem(this, {QString::fromStdString(mode.mode)});
    parent->setFlags(parent->flags() | Qt::ItemIsAutoTristate | Qt::ItemIsUserCheckable);
    for (const AspectRow& row : mode.aspects) {
      auto* const item = new QTreeWidgetItem(parent);
      item->setData(name_column, Qt::UserRole, row.id);
      for (int i = sign_column; i < column_count; ++i)
        item->setTextAlignment(i, Qt::AlignRight | Qt::AlignVCenter);
      if (row.id == 0) continue;
      item->setCheckState(name_column, Qt::Checked);
      item->setIcon(name_column, swatch_of(row.color));
    }
    parent->setExpanded(true);
  }
}

void AspectTree::fill(QTreeWidgetItem& item, const AspectRow& row) {
  item.setText(name_column, QString::fromStdString(row.name));
  item.setText(sign_column, QString::fromStdString(row.sign));
  item.setText(size_column, QString::fromStdString(row.size));
  item.setText(clearance_column, QString::fromStdString(row.clearance));
  item.setText(index_column, QString::fromStdString(row.index));
  item.setToolTip(name_column, QString::fromStdString(row.tip));
  mark(item, row.present);
}

void AspectTree::mark(QTreeWidgetItem& item, bool present) {
  QFont font = this->font();
  font.setBold(present);
  for (int i = 0; i < column_count; ++i) {
    item.setFont(i, font);
    item.setBackground(i, present ? QBrush(QColor(0xFF, 0xEE, 0xBB)) : QBrush());
    item.setForeground(i, present ? QBrush(Qt::black) : QBrush());
  }
  const QString name = item.text(name_column);
  const QString mark = QString(" \u25C0");
  if (present && !name.endsWith(mark)) item.setText(name_column, name + mark);
  if (!present && name.endsWith(mark)) item.setText(name_column, name.left(name.size() - mark.size()));
}

void AspectTree::select(std::uint32_t aspect) {
  clearSelection();
  for (QTreeWidgetItemIterator it(this); aspect > 0 && *it != nullptr; ++it)
    if ((*it)->data(name_column, Qt::UserRole).toUInt() == aspect) return setCurrentItem(*it);
}

std::set<std::uint32_t> AspectTree::ticked() const {
  std::set<std::uint32_t> ids;
  for (int i = 0; i < topLevelItemCount(); ++i)
    for (int j = 0; j < topLevelItem(i)->childCount(); ++j) {
      const QTreeWidgetItem& item = *topLevelItem(i)->child(j);
      const bool is_ticked = item.checkState(name_column) == Qt::Checked;
      if (const auto id = item.data(name_column, Qt::UserRole).toUInt(); is_ticked && id > 0) ids.insert(id);
    }
  return ids;
}

}  // namespace parallel_aspects
