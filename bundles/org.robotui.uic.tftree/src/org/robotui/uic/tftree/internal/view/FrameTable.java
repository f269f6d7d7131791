package org.robotui.uic.tftree.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.data.FrameId;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.FrameRow;
import org.robotui.uic.tftree.internal.model.TfTreeViewState;

/** The frames as a list, indented by depth. Display thread. */
final class FrameTable {
  private static final int DEEPEST = 12;
  private static final int FROM_MIDDLE = 420;
  private static final int FROM_WIDE = 620;

  private final RowTable<FrameRow> table;
  private final Consumer<FrameId> folding;

  FrameTable(Composite parent, Theme theme, Consumer<Optional<FrameId>> selecting, Consumer<FrameId> folding) {
    this.folding = folding;
    table = new RowTable<>(parent, theme, List.of(
        Column.<FrameRow>words("Frame", FrameTable::indented).weight(5).dot(FrameRow::health).unsearched(),
        Column.<FrameRow>figures("Rate", FrameRow::rate).width(86)
            .role(row -> row.link().filter(l -> !l.fixed()).isPresent() ? Role.TEXT : Role.DIM),
        Column.<FrameRow>figures("Age", FrameRow::ageWords).width(76),
        Column.<FrameRow>words("Sent by", row -> row.link().map(l -> l.authority()).orElse("")).weight(2).role(Role.DIM)
            .from(FROM_MIDDLE),
        Column.<FrameRow>words("Problem", FrameRow::problem).weight(2).from(FROM_WIDE)), FrameRow::id);
    table.list().named("Frames").onSelect(rows -> selecting.accept(rows.stream().findFirst().map(FrameRow::id)))
        .onOpen(row -> folding.accept(row.id()));
    table.list().control().addListener(SWT.KeyDown, this::key);
  }

  private static String indented(FrameRow row) {
    String fold = row.below() == 0 ? "" : row.open() ? "\u25be " : "\u25b8 ";
    String hidden = row.open() || row.below() == 0 ? "" : "  +" + row.below();
    return "\u2003".repeat(Math.min(row.depth(), DEEPEST)) + (row.below() == 0 ? "\u2002\u2009" : fold) + row.title()
        + hidden;
  }

  Control control() {
    return table.control();
  }

  RowList<FrameRow> list() {
    return table.list();
  }

  void show(TfTreeViewState look, Ask ask) {
    table.list().state(look.state());
    table.show(look.rows());
    look.nothing().ifPresentOrElse(n -> table.list().message(n.health(), n.title(), n.sentence()),
        table.list()::noMessage);
    Optional<FrameId> now = table.list().selected().stream().findFirst().map(FrameRow::id);
    if (!now.equals(ask.selected())) {
      ask.selected().ifPresentOrElse(table.list()::select, table.list()::selectNone);
    }
  }

  private void key(Event event) {
    Optional<FrameRow> row = table.list().selected().stream().findFirst().filter(r -> r.below() > 0);
    boolean open = event.keyCode == SWT.ARROW_RIGHT;
    if (open || event.keyCode == SWT.ARROW_LEFT) {
      row.filter(r -> r.open() != open).ifPresent(r -> folding.accept(r.id()));
    }
  }
}
