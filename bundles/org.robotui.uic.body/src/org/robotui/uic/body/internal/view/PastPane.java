package org.robotui.uic.body.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Figures;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.uic.body.internal.model.BodyPast;

/** What the selected line says, and said. Display thread. */
final class PastPane {
  private static final int AGO = 84;

  private final CurvePaint painter;
  private final PaintedCanvas head;
  private final RowTable<BodyPast.Moment> moments;
  private Optional<BodyPast> past = Optional.empty();

  PastPane(Composite parent, Theme theme, Runnable close) {
    Composite root = Boxes.panel(parent, theme, 2);
    painter = new CurvePaint(theme);
    head = new PaintedCanvas(root, theme, (gc, area) -> past.ifPresent(p -> painter.paint(gc, area, p)));
    head.setLayoutData(Boxes.line(CurvePaint.WORDS));
    new QuietButton(root, theme, close).icon(Icon.CLOSE).hint("Close the history (Esc)")
        .setLayoutData(new GridData(SWT.END, SWT.TOP, false, false));
    moments = new RowTable<>(root, theme, List.of(
        Column.<BodyPast.Moment>figures("Age", moment -> Figures.age(moment.ago())).width(AGO).role(Role.DIM),
        Column.<BodyPast.Moment>values("Value", BodyPast.Moment::value).weight(1)), moment -> moment);
    moments.list().named("History");
    moments.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true, 2, 1));
    moments.list().control().addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        close.run();
      }
    });
  }

  void show(BodyPast next) {
    past = Optional.of(next);
    int height = CurvePaint.height(next);
    if (height != ((GridData) head.getLayoutData()).heightHint) {
      head.setLayoutData(Boxes.line(height));
      head.getParent().layout();
    }
    head.requestPaint();
    moments.show(next.moments());
  }
}
