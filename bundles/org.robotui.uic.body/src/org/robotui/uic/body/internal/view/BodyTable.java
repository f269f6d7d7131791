package org.robotui.uic.body.internal.view;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.RowList;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.body.internal.model.BodyLine;
import org.robotui.uic.body.internal.model.BodyLook;
import org.robotui.uic.body.internal.model.BodyWish;

/** The tree as a table, indented by depth. Display thread. */
final class BodyTable {
  private static final int DEEPEST = 12;
  private static final int AGE = 76;
  private static final int FROM_MIDDLE = 300;

  private final RowTable<BodyLine> table;
  private final Supplier<BodyWish> wished;
  private final Consumer<BodyWish> wishes;

  BodyTable(Composite parent, Theme theme, Supplier<BodyWish> wished, Consumer<BodyWish> wishes) {
    this.wished = wished;
    this.wishes = wishes;
    table = new RowTable<>(parent, theme, List.of(
        Column.<BodyLine>words("Part", BodyTable::indented).weight(2).dot(BodyLine::health).unsearched(),
        Column.<BodyLine>values("Value", BodyLine::value).weight(3).from(FROM_MIDDLE)
            .role(line -> line.depth() == 0 && line.health() == Health.OK ? Role.DIM : Role.TEXT),
        Column.<BodyLine>figures("Age", line -> Figures.ageOfValue(line.age())).width(AGE)
            .role(line -> line.health() == Health.STALE ? Role.WARNING : Role.DIM)),
        BodyLine::key);
    table.list().named("Body")
        .onSelect(rows -> wishes.accept(wished.get().select(rows.stream().findFirst().map(BodyLine::key))))
        .onOpen(this::turn);
    table.list().control().addListener(SWT.KeyDown, this::key);
  }

  private static String indented(BodyLine line) {
    String fold = line.below() == 0 ? "\u2002\u2009" : line.open() ? "\u25be " : "\u25b8 ";
    return "\u2003".repeat(Math.min(line.depth(), DEEPEST)) + fold + line.title();
  }

  Control control() {
    return table.control();
  }

  RowList<BodyLine> list() {
    return table.list();
  }

  void show(BodyLook look) {
    table.list().state(look.state());
    table.show(look.lines());
    if (look.lines().isEmpty() && look.parts() > 0) {
      table.list().message(Health.NONE, "No match", "Nothing that the body says has these words.");
    } else if (look.lines().isEmpty() && look.state() instanceof InputState.Live) {
      table.list().message(Health.WAITING, "No parts yet",
          "The brain is there; its roblets appear here when they begin.");
    } else {
      table.list().noMessage();
    }
  }

  private void turn(BodyLine line) {
    if (line.below() > 0) {
      wishes.accept(wished.get().turn(line.key()));
    }
  }

  private void key(Event event) {
    boolean open = event.keyCode == SWT.ARROW_RIGHT;
    if (open || event.keyCode == SWT.ARROW_LEFT) {
      table.list().selected().stream().findFirst().filter(line -> line.open() != open).ifPresent(this::turn);
    }
  }
}
