package org.robotui.workbench.internal.pane;

import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.model.Lease;
/** Who drives; a press takes control or releases it. Display thread only. */
final class LeaseLamp extends LampButton {
  private Lease lease = new Lease(Health.NONE, "Nothing to drive");

  LeaseLamp(Composite parent, Theme theme, Runnable pressed) {
    super(parent, theme, control -> pressed.run());
  }

  void show(Lease shown) {
    if (!lease.equals(shown)) {
      lease = shown;
      setToolTipText(shown.words() + "; press to take or release control");
      redraw();
    }
  }

  Lease shown() {
    return lease;
  }

  @Override
  String spoken() {
    return lease.words();
  }

  @Override
  Role edge() {
    return Role.LINE;
  }

  @Override
  Label label() {
    return new Label(lease.words(), Face.BODY, lease.health() == Health.BAD ? Role.BAD : Role.TEXT);
  }

  @Override
  int mark(GC gc, Theme colours, int middle) {
    HealthDot.paint(gc, colours, lease.health(), Theme.EDGE + HealthDot.SIZE / 2, middle);
    return Theme.EDGE + HealthDot.SIZE + 2 * Theme.STEP;
  }
}
