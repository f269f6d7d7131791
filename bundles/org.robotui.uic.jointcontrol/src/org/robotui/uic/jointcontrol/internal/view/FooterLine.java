package org.robotui.uic.jointcontrol.internal.view;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.TextLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.jointcontrol.internal.model.JointFooter;

/**
 * The line below the table. What does not fit into one line goes on in the next: a question must be read whole. Display
 * thread.
 */
final class FooterLine {
  private static final int LINE = 28;
  private static final int LEFT = Theme.STEP + HealthDot.SIZE + 2 * Theme.STEP;

  private final Theme theme;
  private final Composite root;
  private final PaintedCanvas words;
  private final Map<JointFooter.Button, QuietButton> buttons = new EnumMap<>(JointFooter.Button.class);
  private JointFooter footer = new JointFooter(Health.NONE, "", List.of());

  FooterLine(Composite parent, Theme theme, Consumer<JointFooter.Button> pressed) {
    this.theme = theme;
    Boxes.rule(parent, theme);
    root = Boxes.bar(parent, theme, JointFooter.Button.values().length + 1);
    words = new PaintedCanvas(root, theme, this::paint);
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false);
    data.widthHint = 0;
    data.heightHint = LINE;
    words.setLayoutData(data);
    for (JointFooter.Button button : JointFooter.Button.values()) {
      QuietButton made = new QuietButton(root, theme, () -> pressed.accept(button)).text(button.label(""));
      made.setLayoutData(Boxes.middle());
      Boxes.seen(made, false);
      buttons.put(button, button.urgent() ? made.fill(Role.ACCENT) : made);
    }
    words.addListener(SWT.Resize, e -> words.getDisplay().asyncExec(this::fit));
  }

  void show(JointFooter next, String robot) {
    if (footer.equals(next)) {
      return;
    }
    footer = next;
    buttons.forEach((button, control) -> control.text(button.label(robot)));
    words.setToolTipText(next.text().replace("&", "&&"));
    boolean changed = false;
    for (Map.Entry<JointFooter.Button, QuietButton> entry : buttons.entrySet()) {
      changed |= Boxes.seen(entry.getValue(), next.buttons().contains(entry.getKey()));
    }
    if (changed) {
      root.layout();
    }
    fit();
    words.redraw();
  }

  private void fit() {
    if (words.isDisposed() || words.getClientArea().width <= LEFT) {
      return;
    }
    TextLayout text = text(words.getClientArea().width);
    int wanted = Math.max(LINE, text.getBounds().height + Theme.STEP);
    text.dispose();
    GridData data = (GridData) words.getLayoutData();
    if (data.heightHint != wanted) {
      data.heightHint = wanted;
      root.getParent().layout(true, true);
    }
  }

  private TextLayout text(int width) {
    TextLayout text = new TextLayout(words.getDisplay());
    text.setFont(theme.font(Face.BODY));
    text.setText(footer.text());
    text.setWidth(Math.max(1, width - LEFT - Theme.STEP));
    return text;
  }

  private void paint(GC gc, Rectangle area) {
    HealthDot.paint(gc, theme, footer.health(), Theme.STEP + HealthDot.SIZE / 2, area.height / 2);
    gc.setForeground(theme.color(footer.health() == Health.NONE ? Role.DIM : Role.TEXT));
    TextLayout text = text(area.width);
    text.draw(gc, LEFT, (area.height - text.getBounds().height) / 2);
    text.dispose();
  }
}
