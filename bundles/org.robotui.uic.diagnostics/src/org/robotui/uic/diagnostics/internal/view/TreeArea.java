package org.robotui.uic.diagnostics.internal.view;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Scrollable;
import org.robotui.ui.Figures;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowList;
import org.robotui.uic.diagnostics.internal.model.Ask;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsRow;
import org.robotui.uic.diagnostics.internal.model.Shown;

/** The tree, and over it a pill that leads back from a past moment. Display thread. */
final class TreeArea {
  private static final int ABOVE_EDGE = 14;
  private static final double MILLIS = 1000;
  private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT);

  private final Composite root;
  private final TreeLook look;
  private final RowList<DiagnosticsRow> list;
  private final QuietButton pill;
  private final DiagnosticsHands hands;
  private Ask ask = Ask.DEFAULT;

  TreeArea(Composite parent, Theme theme, DiagnosticsHands hands) {
    this.hands = hands;
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    look = new TreeLook(theme);
    pill = new QuietButton(root, theme, () -> hands.ask(ask.at(Optional.empty()))).fill(Role.ACCENT)
        .hint("Show what is now (Esc)");
    pill.setVisible(false);
    list = new RowList<>(root, theme, look).named("Diagnostics")
        .onSelect(rows -> hands.ask(ask.select(rows.stream().findFirst().map(DiagnosticsRow::key))))
        .onOpen(this::toggle)
        .menu(TreeArea::menu);
    root.addListener(SWT.Resize, e -> arrange());
    list.control().addListener(SWT.MouseDown, this::pressed);
    list.control().addListener(SWT.MouseMove, this::dragged);
    list.control().addListener(SWT.KeyDown, this::key);
  }

  Control control() {
    return root;
  }

  RowList<DiagnosticsRow> list() {
    return list;
  }

  void show(Frame frame) {
    ask = frame.ask();
    Shown shown = frame.shown();
    look.moment(shown.ask().slot());
    list.state(frame.treeState());
    frame.notice().ifPresentOrElse(n -> list.message(n.health(), n.title(), n.sentence()), list::noMessage);
    list.show(shown.rows());
    pill(shown);
  }

  private void pill(Shown shown) {
    Optional<Long> slot = shown.ask().slot();
    slot.ifPresent(s -> {
      double ago = Math.max(0, shown.secondsAgo(s));
      Instant then = Instant.now().minusMillis((long) (ago * MILLIS));
      pill.text(TIME.format(then.atZone(ZoneId.systemDefault())) + ", " + Figures.age(ago) + " ago. Back to now");
      arrange();
    });
    if (pill.getVisible() != slot.isPresent()) {
      pill.setVisible(slot.isPresent());
      pill.moveAbove(null);
    }
  }

  private void arrange() {
    Rectangle area = root.getClientArea();
    list.control().setBounds(area);
    Point size = pill.computeSize(SWT.DEFAULT, SWT.DEFAULT);
    pill.setBounds((area.width - size.x) / 2, Math.max(0, area.height - size.y - ABOVE_EDGE), size.x, size.y);
  }

  private void toggle(DiagnosticsRow row) {
    if (row.group()) {
      hands.ask(ask.open(row.key(), !row.open()));
    }
  }

  private static List<ViewAction> menu(List<DiagnosticsRow> rows) {
    return rows.stream().findFirst()
        .map(row -> List.of(copy("name", "Copy name", row.label()), copy("message", "Copy message", row.message())))
        .orElse(List.of());
  }

  private static ViewAction copy(String id, String label, String text) {
    return new ViewAction(id, label, Icon.COPY.id(), Optional.empty(), () -> Clipboards.copy(text));
  }

  /** The list has selected the line already. */
  private void pressed(Event event) {
    if (event.button == 1) {
      list.selected().stream().findFirst().filter(row -> TreeLook.isArrow(row, event.x)).ifPresent(this::toggle);
      look(event.x);
    }
  }

  private void dragged(Event event) {
    if ((event.stateMask & SWT.BUTTON1) != 0) {
      look(event.x);
    }
  }

  private void look(int x) {
    Rectangle line = ((Scrollable) list.control()).getClientArea();
    Optional<DiagnosticsRow> row = list.selected().stream().findFirst();
    TreeLook.strip(line).filter(strip -> row.isPresent() && x >= strip.x).ifPresent(
        strip -> hands.ask(ask.at(Optional.of(StripPainter.slot(row.get().strip(), x - strip.x, strip.width)))));
  }

  private void key(Event event) {
    Optional<DiagnosticsRow> row = list.selected().stream().findFirst();
    switch (event.keyCode) {
      case SWT.ARROW_RIGHT -> row.filter(r -> r.group() && !r.open()).ifPresent(this::toggle);
      case SWT.ARROW_LEFT -> row.ifPresent(r -> {
        if (r.open()) {
          toggle(r);
        } else {
          parent(r).ifPresent(p -> {
            list.select(p.key());
            hands.ask(ask.select(Optional.of(p.key())));
          });
        }
      });
      default -> {}
    }
  }

  private Optional<DiagnosticsRow> parent(DiagnosticsRow row) {
    List<DiagnosticsRow> rows = list.rows();
    for (int i = rows.indexOf(row); i >= 0; i--) {
      if (rows.get(i).depth() < row.depth()) {
        return Optional.of(rows.get(i));
      }
    }
    return Optional.empty();
  }
}
