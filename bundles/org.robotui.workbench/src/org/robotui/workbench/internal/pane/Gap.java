package org.robotui.workbench.internal.pane;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;

/** Empty room on the ground of its parent. */
final class Gap extends Canvas {
  Gap(Composite parent) {
    super(parent, SWT.NONE);
    setBackground(parent.getBackground());
  }

  @Override
  public Point computeSize(int widthHint, int heightHint, boolean changed) {
    return new Point(Math.max(0, widthHint), Math.max(0, heightHint));
  }
}
