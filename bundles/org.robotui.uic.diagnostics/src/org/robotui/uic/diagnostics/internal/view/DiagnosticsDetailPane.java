package org.robotui.uic.diagnostics.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.diagnostics.internal.model.DiagnosticsDetail;

/** Everything about the selected line. Display thread. */
final class DiagnosticsDetailPane {
  private static final double NAME_SHARE = 2;
  private static final double VALUE_SHARE = 3;

  private final Composite root;
  private final DetailHead painter;
  private final PaintedCanvas head;
  private final RowTable<DiagnosticsDetail.Value> values;
  private Optional<DiagnosticsDetail> detail = Optional.empty();

  DiagnosticsDetailPane(Composite parent, Theme theme, Runnable close) {
    root = Boxes.panel(parent, theme, 3);
    painter = new DetailHead(theme);
    head = new PaintedCanvas(root, theme, (gc, area) -> detail.ifPresent(d -> painter.paint(gc, area, d)));
    head.setLayoutData(Boxes.line(DetailHead.HEIGHT));
    button(theme, Icon.COPY, "Copy all of it", this::copy);
    button(theme, Icon.CLOSE, "Close the details (Esc)", close);
    values = new RowTable<>(root, theme, List.of(
        Column.<DiagnosticsDetail.Value>words("Name", DiagnosticsDetail.Value::name).weight(NAME_SHARE).role(Role.DIM),
        Column.<DiagnosticsDetail.Value>values("Value", DiagnosticsDetail.Value::value).weight(VALUE_SHARE)),
        DiagnosticsDetail.Value::name);
    values.list().named("Values").several();
    values.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true, 3, 1));
    values.list().control().addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        close.run();
      }
    });
  }

  Control control() {
    return root;
  }

  void show(DiagnosticsDetail next) {
    if (!detail.equals(Optional.of(next))) {
      head.setToolTipText((next.title() + "\n" + next.message()).strip().replace("&", "&&"));
    }
    detail = Optional.of(next);
    head.redraw();
    values.show(next.values());
    if (next.values().isEmpty()) {
      values.list().message(Health.NONE, "No values", "This part reports no values.");
    } else {
      values.list().noMessage();
    }
  }

  private void button(Theme theme, Icon icon, String hint, Runnable action) {
    QuietButton button = new QuietButton(root, theme, action).icon(icon).hint(hint);
    button.setLayoutData(new GridData(SWT.END, SWT.TOP, false, false));
  }

  private void copy() {
    detail.map(DiagnosticsDetail::text).ifPresent(Clipboards::copy);
  }
}
