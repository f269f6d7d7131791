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
import org.robotui.uic.tftree.internal.model.Look;
import org.robotui.uic.tftree.internal.model.Row;

/** The frames as a list, indented by depth. Display thread. */
final class FrameTable {
  private static final int DEEPEST = 12;
  private static final int FROM_MIDDLE = 420;
  private static final int FROM_WIDE = 620;

  private final RowTable<Row> table;
  private final Consumer<FrameId> folding;

  FrameTable(Composite parent, Theme theme, Consumer<Optional<FrameId>> selecting, Consumer<FrameId> folding) {
    this.folding = folding;
    table = new RowTable<>(parent, theme, List.of(
        Column.<Row>words("Frame", FrameTable::indented).weight(5).dot(Row::health).unsearched(),
        Column.<Row>figures("Rate", Row::rate).width(86).role(row -> row.link().filter(l -> !l.fixed()).isPresent() ? Role.TEXT : Role.DIM),
        Column.<Row>figures("Age", Row::ageWords).width(76),
        Column.<Row>words("Sent by", row -> row.link().map(l -> l.authority()).orElse("")).weight(2).role(Role.DIM).from(FROM_MIDDLE),
        Column.<Row>words("Problem", Row::problem).weight(2).from(FROM_WIDE)), Row::id);
    table.list().named("Frames").onSelect(rows -> selecting.accept(rows.stream().findFirst().map(Row::id))).onOpen(row -> folding.accept(row.id()));
    table.list().control().addListener(SWT.KeyDown, this::key);
  }

  private static String indented(Row row) {
    String fold = row.below() == 0 ? "" : row.open() ? "\u25be " : "\u25b8 ";
    String hidden = row.open() || row.below() == 0 ? "" : "  +" + row.below();
    return "\u2003".repeat(Math.min(row.depth(), DEEPEST)) + (row.below() == 0 ? "\u2002\u2009" : fold) + row.title() + hidden;
  }

  Control control() {
    return table.control();
  }

  RowList<Row> list() {
    return table.list();
  }

  void show(Look look, Ask ask) {
    table.list().state(look.state());
    table.show(look.rows());
    look.nothing().ifPresentOrElse(n -> table.list().message(n.health(), n.title(), n.sentence()), table.list()::noMessage);
    Optional<FrameId> now = table.list().selected().stream().findFirst().map(Row::id);
    if (!now.equals(ask.selected())) {
      ask.selected().ifPresentOrElse(table.list()::select, table.list()::selectNone);
    }
  }

  private void key(Event event) {
    Optional<Row> row = table.list().selected().stream().findFirst().filter(r -> r.below() > 0);
    boolean open = event.keyCode == SWT.ARROW_RIGHT;
    if (open || event.keyCode == SWT.ARROW_LEFT) {
      row.filter(r -> r.open() != open).ifPresent(r -> folding.accept(r.id()));
    }
  }
}
